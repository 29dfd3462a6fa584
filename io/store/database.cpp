#include "io/store/database.h"

#include <sqlite3.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <limits>
#include <optional>
#include <string_view>
#include <thread>

namespace coapt {
namespace {

// The header of a database (sqlite.org/fileformat.html, 1.3); its integers are big-endian.
constexpr std::size_t kHeaderBytes = 100, kUserVersionAt = 60, kApplicationAt = 68;
constexpr std::string_view kMagic("SQLite format 3\0", 16);

/// What a database says that it is; zeros if it is empty.
struct Kind {
  int application = 0, schema = 0;
};

Error refusal(const std::string& path, const std::string& problem) {
  return {ErrorCode::InputOutput, "", path + ": " + problem};
}

Error foreign(const std::string& path, const std::string& problem) {
  Error error = refusal(path, problem);
  error.code = ErrorCode::Unsupported;
  return error;
}

bool needs_upgrade(const Kind& kind, const StoreFormat& format) {
  return *format.upgrade != '\0' && kind.schema == format.schema - 1;
}

/// What speaks against a database of this kind.
Errors check_kind(const Kind& kind, const StoreFormat& format, const std::string& path) {
  if (kind.application != format.application)
    return {foreign(path, std::string("is not a store of ") + format.rows +
                              ", but a database of another application")};
  if (kind.schema != format.schema && !needs_upgrade(kind, format))
    return {foreign(path, "is a store of schema " + std::to_string(kind.schema) +
                              "; this coapt knows schema " + std::to_string(format.schema))};
  return {};
}

/// What speaks against using the file. By the header alone, through the handle that SQLite has open:
/// a query would recover or checkpoint what another application left, and closing a handle of our
/// own would drop the locks that this process has on the file.
Errors check_header(sqlite3* database, const StoreFormat& format, const std::string& path) {
  std::array<unsigned char, kHeaderBytes> header{};
  const auto integer = [&header](std::size_t at) {
    return header[at] << 24 | header[at + 1] << 16 | header[at + 2] << 8 | header[at + 3];
  };

  sqlite3_file* file = nullptr;
  sqlite3_int64 bytes = 0;
  sqlite3_file_control(database, "main", SQLITE_FCNTL_FILE_POINTER, &file);
  const auto refuse = [&path](const std::string& problem) {
    return Errors{refusal(path, problem)};
  };
  if (file == nullptr || file->pMethods == nullptr) return refuse("is not a file");
  if (file->pMethods->xFileSize(file, &bytes) != SQLITE_OK) return refuse("cannot be read");
  const int read = file->pMethods->xRead(file, header.data(), header.size(), 0);
  if (read != SQLITE_OK && read != SQLITE_IOERR_SHORT_READ) return refuse("cannot be read");
  if (bytes == 0 && header[0] == 0) return {};  // SQLite calls one byte none
  if (std::memcmp(header.data(), kMagic.data(), kMagic.size()) != 0)
    return {
        foreign(path, std::string("is not a store of ") + format.rows + ", but some other file")};
  if (Errors errors = check_kind({integer(kApplicationAt), integer(kUserVersionAt)}, format, path);
      !errors.empty())
    return errors;
  if (sqlite3_db_readonly(database, "main") == 1) return refuse("is read-only");
  return {};
}

bool run(sqlite3* database, const std::string& sql) {
  return sqlite3_exec(database, sql.c_str(), nullptr, nullptr, nullptr) == SQLITE_OK;
}

std::optional<int> integer_of(sqlite3* database, const char* pragma) {
  sqlite3_stmt* statement = nullptr;
  sqlite3_prepare_v2(database, pragma, -1, &statement, nullptr);
  const Statement row(statement);
  if (sqlite3_step(statement) != SQLITE_ROW) return {};
  return sqlite3_column_int(statement, 0);
}

/// Zeros if there is no store yet, though the header may say so, if the process that made it was
/// killed. The first alone may be zero if another process makes it now. None if it cannot be read.
std::optional<Kind> kind_of(sqlite3* database) {
  const std::optional<int> application = integer_of(database, "PRAGMA application_id");
  if (!application) return {};
  const std::optional<int> schema = integer_of(database, "PRAGMA user_version");
  if (!schema) return {};
  return Kind{*application, *schema};
}

/// Makes the tables, unless another process made something since. In one transaction, and before
/// there is a log: what is not empty has application and schema in its header. None if it fails.
std::optional<Kind> make(sqlite3* database, const StoreFormat& format) {
  if (!run(database, "BEGIN IMMEDIATE")) return {};
  const std::optional<Kind> kind = kind_of(database);
  if (!kind) return {};
  if (kind->application == 0 && kind->schema == 0 &&
      !run(database, std::string(format.tables) +
                         "PRAGMA application_id = " + std::to_string(format.application) +
                         "; PRAGMA user_version = " + std::to_string(format.schema)))
    return {};
  if (!run(database, "COMMIT")) return {};
  return kind_of(database);
}

/// In one transaction, unless another process has done it since.
bool upgrade(sqlite3* database, const StoreFormat& format) {
  if (!run(database, "BEGIN IMMEDIATE")) return false;
  const std::optional<Kind> kind = kind_of(database);
  return kind &&
         (!needs_upgrade(*kind, format) ||
          run(database, std::string(format.upgrade) +
                            "PRAGMA user_version = " + std::to_string(format.schema))) &&
         run(database, "COMMIT");
}

/// Has commits written to a log. SQLite waits for the first lock of a transaction alone, and this one
/// reads before it writes: where another process has just the file, it is asked again.
bool keep_log(sqlite3* database, int lock_timeout_ms) {
  using std::chrono::steady_clock, std::chrono::milliseconds;
  const auto end = steady_clock::now() + milliseconds(lock_timeout_ms);
  while (!run(database, "PRAGMA journal_mode = WAL")) {
    if (sqlite3_errcode(database) != SQLITE_BUSY || steady_clock::now() >= end) return false;
    std::this_thread::sleep_for(milliseconds(1));
  }
  return true;
}

/// Whether the last write to one of the files failed for want of room. The system's error is asked of
/// each file: by the time that a call returns, rolling back has overwritten errno.
bool lacks_room(sqlite3* database) {
  if (code_of_errno(sqlite3_system_errno(database)) == ErrorCode::NoSpace) return true;
  for (const int which : {SQLITE_FCNTL_FILE_POINTER, SQLITE_FCNTL_JOURNAL_POINTER}) {
    sqlite3_file* file = nullptr;
    int last = 0;
    sqlite3_file_control(database, "main", which, &file);  // the log is the journal, too
    if (file == nullptr || file->pMethods == nullptr) continue;
    file->pMethods->xFileControl(file, SQLITE_FCNTL_LAST_ERRNO, &last);
    if (code_of_errno(last) == ErrorCode::NoSpace) return true;
  }
  return false;
}

/// Why the last call failed.
ErrorCode cause(sqlite3* database) {
  const int code = sqlite3_extended_errcode(database);
  switch (code & 0xff) {  // what all of its kind have in common
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
      return ErrorCode::Busy;
    case SQLITE_FULL:
      return ErrorCode::NoSpace;
    case SQLITE_IOERR:
    case SQLITE_CANTOPEN:
      // A file keeps its last error until the next, of a write perhaps long ago.
      return code != SQLITE_IOERR_READ && lacks_room(database) ? ErrorCode::NoSpace
                                                               : ErrorCode::InputOutput;
    default:
      return ErrorCode::InputOutput;
  }
}

}  // namespace

void SqliteClose::operator()(sqlite3* database) const { sqlite3_close_v2(database); }
void SqliteClose::operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }

Expected<StoreDatabase> StoreDatabase::open(const std::string& path, const StoreFormat& format,
                                            int lock_timeout_ms) {
  StoreDatabase store;
  store.path_ = path;
  store.tells_causes_ = format.tells_causes;
  if (path.empty())
    return refusal(std::string("a store of ") + format.rows, "needs the path of a file");

  sqlite3* database = nullptr;
  const int opened =
      sqlite3_open_v2(path.c_str(), &database, SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE, nullptr);
  store.handle_.reset(database);
  if (opened != SQLITE_OK) {
    Error error = store.failure("cannot be opened");
    // Of a link to itself the system's error is none.
    if (const int number = sqlite3_system_errno(database); number != 0)
      error.message = path + ": cannot be opened: " + std::strerror(number);
    return error;
  }
  if (const Errors errors = check_header(database, format, path); !errors.empty()) return errors;

  sqlite3_busy_timeout(database, lock_timeout_ms);
  std::optional<Kind> kind = kind_of(database);
  if (kind && kind->application == 0) kind = make(database, format);
  if (!kind) return store.failure("cannot be opened");
  if (const Errors errors = check_kind(*kind, format, path); !errors.empty()) return errors;
  if (needs_upgrade(*kind, format) && !upgrade(database, format))
    return store.failure("cannot be brought to this release's schema");
  // NORMAL: commits are written to the log, not forced to the disk one by one.
  if (!keep_log(database, lock_timeout_ms) ||
      !run(database, "PRAGMA synchronous = NORMAL; PRAGMA wal_autocheckpoint = " +
                         std::to_string(format.log_pages) + ';' + format.settings))
    return store.failure("cannot be opened");
  return store;
}

Statement StoreDatabase::prepare(const char* sql) const {
  sqlite3_stmt* statement = nullptr;
  sqlite3_prepare_v2(handle_.get(), sql, -1, &statement, nullptr);
  return Statement(statement);
}

Error StoreDatabase::failure(const std::string& problem) const {
  Error error = refusal(path_, problem + ": " + sqlite3_errmsg(handle_.get()));
  if (tells_causes_) error.code = cause(handle_.get());
  return error;
}

std::string StoreDatabase::file() const { return sqlite3_db_filename(handle_.get(), "main"); }
int StoreDatabase::changed() const { return sqlite3_changes(handle_.get()); }
bool StoreDatabase::in_transaction() const { return sqlite3_get_autocommit(handle_.get()) == 0; }

ErrorCode code_of_errno(int system_error) {
  return system_error == ENOSPC || system_error == EDQUOT || system_error == EFBIG
             ? ErrorCode::NoSpace
             : ErrorCode::InputOutput;
}

void bind_text(const Statement& statement, int parameter, const std::string& text) {
  sqlite3_bind_text64(statement.get(), parameter, text.data(), text.size(), SQLITE_STATIC,
                      SQLITE_UTF8);
}

double number_at(const Statement& row, int column) {
  return sqlite3_column_type(row.get(), column) == SQLITE_NULL
             ? std::numeric_limits<double>::quiet_NaN()
             : sqlite3_column_double(row.get(), column);
}

std::string bytes_at(const Statement& row, int column) {
  const void* const bytes = sqlite3_column_blob(row.get(), column);  // null if there are none
  const int length = bytes == nullptr ? 0 : sqlite3_column_bytes(row.get(), column);
  return {static_cast<const char*>(bytes), static_cast<std::size_t>(length)};
}

}  // namespace coapt
