// The SQLite file under a store: told from all other files before a byte of it is changed, made if
// there is none, with a write-ahead log (PATH-wal and PATH-shm beside it while it is open).
//
// A commit outlives the process, kill -9 included; a crash of the machine or loss of power may cost
// the last commits, not the file, unless the settings say otherwise. Several processes may share a
// file on a local disk.
#pragma once

#include <memory>
#include <string>

#include "core/valve/types.h"

struct sqlite3;
struct sqlite3_stmt;

namespace coapt {

struct SqliteClose {
  void operator()(sqlite3* database) const;
  void operator()(sqlite3_stmt* statement) const;
};
using Statement = std::unique_ptr<sqlite3_stmt, SqliteClose>;

/// What tells the stores of one kind from other files.
struct StoreFormat {
  int application = 0;      ///< application_id of the file, not 0
  int schema = 0;           ///< user_version of the file, not 0
  const char* rows = "";    ///< for messages: "closures"
  const char* tables = "";  ///< SQL that makes them
  const char* upgrade =
      "";  ///< SQL that makes them of those of the schema before; empty: such a file is refused
  int log_pages = 1000;  ///< of 4 KiB, after which the log goes into the file, forced to the disk
  const char* settings = "";  ///< SQL of each connection, after all else: PRAGMA ...
  bool tells_causes = false;  ///< failures are Busy or NoSpace where that is why
};

/// Every failure is InputOutput, unless the format tells causes; its message names the file and what
/// SQLite or the system says.
class StoreDatabase {
 public:
  /// Makes the file if it is missing or empty. What is not of this format is refused, and not a byte
  /// of it changed; so is a file that cannot be written. This call and every statement wait up to
  /// `lock_timeout_ms` for other processes.
  static Expected<StoreDatabase> open(const std::string& path, const StoreFormat& format,
                                      int lock_timeout_ms);

  /// Null if it does not fit the tables.
  Statement prepare(const char* sql) const;

  /// Of the last call: file, problem and what SQLite says.
  Error failure(const std::string& problem) const;

  /// Its absolute path, without symbolic links.
  std::string file() const;
  /// Rows that the last statement inserted, updated or deleted.
  int changed() const;
  /// Whether a transaction is open.
  bool in_transaction() const;

 private:
  StoreDatabase() = default;

  std::string path_;
  bool tells_causes_ = false;
  std::unique_ptr<sqlite3, SqliteClose> handle_;
};

/// NoSpace for an errno of disk, quota or size of a file, else InputOutput.
ErrorCode code_of_errno(int system_error);

/// @pre `text` lives until the statement is reset.
void bind_text(const Statement& statement, int parameter, const std::string& text);

/// NaN if it is NULL, as which SQLite keeps NaN.
double number_at(const Statement& row, int column);

/// Of a text or blob, every byte; empty if it is NULL.
std::string bytes_at(const Statement& row, int column);

}  // namespace coapt
