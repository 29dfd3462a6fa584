// Closures kept in a file as they are made, so that a study that is killed loses none and repeats
// none.
//
// The file is an SQLite database with a write-ahead log (PATH-wal and PATH-shm beside it while it is
// open), a row per closure, a transaction per row. What keep() has accepted outlives the process,
// kill -9 included; a crash of the machine or loss of power may cost the last rows, not the file.
// Rows are never changed or removed. Several processes may share a file on a local disk.
#pragma once

#include <memory>
#include <string>

#include "core/valve/types.h"
#include "search/studies/orifice_table.h"

struct sqlite3;
struct sqlite3_stmt;

namespace coapt {

/// Every failure is InputOutput; its message names the file and what SQLite or the system says.
class ClosureStore {
 public:
  /// Makes the file if it is missing or empty. What is not a store of this schema is refused, and
  /// not a byte of it changed; so is a file that cannot be written. This call and those below wait
  /// up to `lock_timeout_ms` for other processes.
  static Expected<ClosureStore> open(const std::string& path, int lock_timeout_ms = 5000);

  /// All closures of one subject (subject.h).
  Expected<KnownOrifices> read(const std::string& subject) const;

  /// Empty if the closure is kept now, or was before: the first answer stays. All bits of the
  /// numbers are kept, but those that tell one NaN from another. From one thread at a time. Under
  /// 0.1 ms in the mean, median 0.01; some 50 ms when the log goes into the file.
  Errors keep(const std::string& subject, const ConfigurationKey& key, const OrificeSample& sample);

 private:
  struct Close {
    void operator()(sqlite3* database) const;
    void operator()(sqlite3_stmt* statement) const;
  };

  ClosureStore() = default;

  std::string path_;
  std::unique_ptr<sqlite3, Close> database_;
  std::unique_ptr<sqlite3_stmt, Close> insert_;
};

}  // namespace coapt
