// The SQLite file under a store: told from all other files before a byte of it is changed, made if
// there is none, with a write-ahead log (PATH-wal and PATH-shm beside it while it is open).
//
// A commit outlives the process, kill -9 included; a crash of the machine or loss of power may cost
// the last commits, not the file. Several processes may share a file on a local disk.
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
  int log_pages = 1000;  ///< of 4 KiB, after which the log goes into the file, forced to the disk
};

/// Every failure is InputOutput; its message names the file and what SQLite or the system says.
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

 private:
  StoreDatabase() = default;

  std::string path_;
  std::unique_ptr<sqlite3, SqliteClose> handle_;
};

/// @pre `text` lives until the statement is reset.
void bind_text(const Statement& statement, int parameter, const std::string& text);

/// NaN if it is NULL, as which SQLite keeps NaN.
double number_at(const Statement& row, int column);

}  // namespace coapt
