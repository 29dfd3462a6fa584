#include "io/store/closure_store.h"

#include <sqlite3.h>

#include <array>
#include <cstdint>
#include <cstring>
#include <limits>
#include <optional>
#include <string_view>

namespace coapt {
namespace {

constexpr int kSchema = 1;                // user_version of the file
constexpr int kApplication = 0x636f6170;  // application_id of the file: "coap"

// The header of a database (sqlite.org/fileformat.html, 1.3); its integers are big-endian.
constexpr std::size_t kHeaderBytes = 100, kUserVersionAt = 60, kApplicationAt = 68;
constexpr std::string_view kMagic("SQLite format 3\0", 16);

// One transaction, and before there is a log: what is not empty has application and schema in its
// header. The numbers are ANY, because REAL would make 0.0 of -0.0.
const std::string kCreate = R"(
BEGIN IMMEDIATE;
CREATE TABLE IF NOT EXISTS closures (
  subject TEXT,           -- valve, closure options and version, hashed
  dilation INTEGER,       -- of the annulus, 1e-6 percent
  height INTEGER,         -- of the annulus, 1e-6 percent
  al_transverse INTEGER,  -- anterolateral displacement, 1e-6 mm
  al_posterior INTEGER,
  al_apical INTEGER,
  pm_transverse INTEGER,  -- posteromedial displacement, 1e-6 mm
  pm_posterior INTEGER,
  pm_apical INTEGER,
  sizes INTEGER,          -- of the ring below the valve's
  area_mm2 ANY,           -- floating point; NULL is NaN
  sd_mm2 ANY,             -- likewise
  trusted INTEGER NOT NULL,
  PRIMARY KEY (subject, dilation, height, al_transverse, al_posterior, al_apical, pm_transverse,
               pm_posterior, pm_apical, sizes)
) STRICT, WITHOUT ROWID;
PRAGMA application_id = )" + std::to_string(kApplication) +
                            R"(;
PRAGMA user_version = )" + std::to_string(kSchema) +
                            R"(;
COMMIT;
)";

// NORMAL: commits are written to the log, not forced to the disk one by one.
constexpr const char* kLog = "PRAGMA journal_mode = WAL; PRAGMA synchronous = NORMAL;";

// Not INSERT OR IGNORE, which would pass over every constraint and not only over the key's.
constexpr const char* kInsert =
    "INSERT INTO closures VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?) ON CONFLICT DO NOTHING";

constexpr const char* kSelect =
    "SELECT dilation, height, al_transverse, al_posterior, al_apical, pm_transverse, pm_posterior, "
    "pm_apical, sizes, area_mm2, sd_mm2, trusted FROM closures WHERE subject = ?";

Error failure(const std::string& path, const std::string& problem) {
  return {ErrorCode::InputOutput, "", path + ": " + problem};
}

Error wrong_schema(const std::string& path, int schema) {
  return failure(path, "is a store of schema " + std::to_string(schema) +
                           "; this coapt knows schema " + std::to_string(kSchema));
}

/// Null if the statement does not fit the database.
sqlite3_stmt* prepare(sqlite3* database, const char* sql) {
  sqlite3_stmt* statement = nullptr;
  sqlite3_prepare_v2(database, sql, -1, &statement, nullptr);
  return statement;
}

/// @pre `text` lives until the statement is reset.
void bind_text(sqlite3_stmt* statement, int column, const std::string& text) {
  sqlite3_bind_text64(statement, column, text.data(), text.size(), SQLITE_STATIC, SQLITE_UTF8);
}

double number(sqlite3_stmt* row, int column) {
  return sqlite3_column_type(row, column) == SQLITE_NULL ? std::numeric_limits<double>::quiet_NaN()
                                                         : sqlite3_column_double(row, column);
}

/// What speaks against using the file. By the header alone, through the handle that SQLite has open:
/// a query would recover or checkpoint what another application left, and closing a handle of our
/// own would drop the locks that this process has on the file.
Errors check_header(sqlite3* database, const std::string& path) {
  std::array<unsigned char, kHeaderBytes> header{};
  const auto integer = [&header](std::size_t at) {
    return header[at] << 24 | header[at + 1] << 16 | header[at + 2] << 8 | header[at + 3];
  };

  sqlite3_file* file = nullptr;
  sqlite3_int64 bytes = 0;
  sqlite3_file_control(database, "main", SQLITE_FCNTL_FILE_POINTER, &file);
  const auto refuse = [&path](const std::string& problem) {
    return Errors{failure(path, problem)};
  };
  if (file == nullptr || file->pMethods == nullptr) return refuse("is not a file");
  if (file->pMethods->xFileSize(file, &bytes) != SQLITE_OK) return refuse("cannot be read");
  const int read = file->pMethods->xRead(file, header.data(), header.size(), 0);
  if (read != SQLITE_OK && read != SQLITE_IOERR_SHORT_READ) return refuse("cannot be read");
  if (bytes == 0 && header[0] == 0) return {};  // SQLite calls one byte none
  if (std::memcmp(header.data(), kMagic.data(), kMagic.size()) != 0)
    return refuse("is not a store of closures, but some other file");
  if (integer(kApplicationAt) != kApplication)
    return refuse("is not a store of closures, but a database of another application");
  if (const int schema = integer(kUserVersionAt); schema != kSchema)
    return {wrong_schema(path, schema)};
  if (sqlite3_db_readonly(database, "main") == 1) return refuse("is read-only");
  return {};
}

/// 0 if there is no store yet, though the header may say so, if the process that made it was killed.
/// None if it cannot be read.
std::optional<int> schema_of(sqlite3* database) {
  sqlite3_stmt* const statement = prepare(database, "PRAGMA user_version");
  std::optional<int> schema;
  if (sqlite3_step(statement) == SQLITE_ROW) schema = sqlite3_column_int(statement, 0);
  sqlite3_finalize(statement);
  return schema;
}

}  // namespace

void ClosureStore::Close::operator()(sqlite3* database) const { sqlite3_close_v2(database); }
void ClosureStore::Close::operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }

Expected<ClosureStore> ClosureStore::open(const std::string& path, int lock_timeout_ms) {
  ClosureStore store;
  store.path_ = path;
  if (path.empty()) return failure("a store of closures", "needs the path of a file");

  sqlite3* database = nullptr;
  const int opened =
      sqlite3_open_v2(path.c_str(), &database, SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE, nullptr);
  store.database_.reset(database);
  const auto cannot_be_opened = [&](const char* reason) {
    return failure(path, std::string("cannot be opened: ") + reason);
  };
  if (opened != SQLITE_OK) return cannot_be_opened(std::strerror(sqlite3_system_errno(database)));
  if (const Errors errors = check_header(database, path); !errors.empty()) return errors;

  sqlite3_busy_timeout(database, lock_timeout_ms);
  const auto run = [database](const char* sql) {
    return sqlite3_exec(database, sql, nullptr, nullptr, nullptr) == SQLITE_OK;
  };
  const std::optional<int> schema = schema_of(database);
  if (schema && *schema != 0 && *schema != kSchema) return wrong_schema(path, *schema);
  if (schema && (*schema == kSchema || run(kCreate.c_str())) && run(kLog))
    store.insert_.reset(prepare(database, kInsert));
  if (!store.insert_) return cannot_be_opened(sqlite3_errmsg(database));
  return store;
}

Expected<KnownOrifices> ClosureStore::read(const std::string& subject) const {
  const std::unique_ptr<sqlite3_stmt, Close> rows(prepare(database_.get(), kSelect));
  KnownOrifices known;
  int step = SQLITE_ERROR;
  if (rows) {
    bind_text(rows.get(), 1, subject);
    while ((step = sqlite3_step(rows.get())) == SQLITE_ROW) {
      int column = 0;
      ConfigurationKey key;
      for (std::int64_t& value : key) value = sqlite3_column_int64(rows.get(), column++);
      OrificeSample& sample = known[key];
      sample.area_mm2 = number(rows.get(), column++);
      sample.sd_mm2 = number(rows.get(), column++);
      sample.trusted = sqlite3_column_int(rows.get(), column) != 0;
    }
  }
  if (step != SQLITE_DONE)
    return failure(path_, std::string("cannot be read: ") + sqlite3_errmsg(database_.get()));
  return known;
}

Errors ClosureStore::keep(const std::string& subject, const ConfigurationKey& key,
                          const OrificeSample& sample) {
  sqlite3_stmt* const insert = insert_.get();
  int column = 0;
  bind_text(insert, ++column, subject);
  for (const std::int64_t value : key) sqlite3_bind_int64(insert, ++column, value);
  for (const double value : {sample.area_mm2, sample.sd_mm2})
    sqlite3_bind_double(insert, ++column, value);  // NaN as NULL
  sqlite3_bind_int(insert, ++column, sample.trusted ? 1 : 0);

  Errors errors;
  if (sqlite3_step(insert) != SQLITE_DONE)
    errors.push_back(failure(
        path_, std::string("a closure cannot be kept: ") + sqlite3_errmsg(database_.get())));
  sqlite3_reset(insert);
  return errors;
}

}  // namespace coapt
