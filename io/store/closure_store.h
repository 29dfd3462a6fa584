// Closures kept in a file as they are made, so that a study that is killed loses none and repeats
// none.
//
// A row per closure, a transaction per row: what keep() has accepted outlives the process, kill -9
// included (database.h). Rows are never changed; retain() alone removes some. Several processes may
// share a file on a local disk.
#pragma once

#include <memory>
#include <string>

#include "core/valve/types.h"
#include "io/store/subject_uses.h"
#include "search/studies/orifice_table.h"

namespace coapt {

/// Every failure is InputOutput, but a file of another kind or schema Unsupported; its message names the file and what SQLite or the system says.
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

  /// The subject was used now: see subject_uses.h, likewise below.
  Errors note_use(const std::string& subject, std::int64_t now_ms);
  Errors retain(const ClosureLimits& limits, const SubjectsInUse& in_use, std::int64_t now_ms);

 private:
  ClosureStore(std::unique_ptr<StoreConnection> connection, Statement insert);

  std::unique_ptr<StoreConnection> connection_;
  Statement insert_;
};

}  // namespace coapt
