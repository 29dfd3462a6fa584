#include "io/store/closure_store.h"

#include <sqlite3.h>

#include <cstdint>
#include <utility>

namespace coapt {
namespace {

// The numbers are ANY, because REAL would make 0.0 of -0.0.
constexpr StoreFormat kClosureFormat = {.application = 0x636f6170,  // "coap"
                                        .schema = 1,
                                        .rows = "closures",
                                        .tables = R"(
CREATE TABLE closures (
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
)"};

// Not INSERT OR IGNORE, which would pass over every constraint and not only over the key's.
constexpr const char* kInsertClosure =
    "INSERT INTO closures VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?) ON CONFLICT DO NOTHING";

constexpr const char* kSelectClosures =
    "SELECT dilation, height, al_transverse, al_posterior, al_apical, pm_transverse, pm_posterior, "
    "pm_apical, sizes, area_mm2, sd_mm2, trusted FROM closures WHERE subject = ?";

// The names are found one after the other in the key, because DISTINCT would read every row.
constexpr SubjectTables kClosureTables = {
    .subjects =
        "WITH RECURSIVE names (name) AS (SELECT min(subject) FROM closures UNION ALL "
        "SELECT (SELECT min(subject) FROM closures WHERE subject > name) FROM names "
        "WHERE name IS NOT NULL) SELECT name FROM names WHERE name IS NOT NULL",
    .count = "SELECT count(*) FROM closures WHERE subject = ?1",
    .remove =
        "DELETE FROM closures WHERE (subject, dilation, height, al_transverse, al_posterior, "
        "al_apical, pm_transverse, pm_posterior, pm_apical, sizes) IN (SELECT subject, dilation, "
        "height, al_transverse, al_posterior, al_apical, pm_transverse, pm_posterior, pm_apical, "
        "sizes FROM closures WHERE subject = ?1 LIMIT 10000)",
    .forget = "",
    .tidy = ""};

}  // namespace

ClosureStore::ClosureStore(std::unique_ptr<StoreConnection> connection, Statement insert)
    : connection_(std::move(connection)), insert_(std::move(insert)) {}

Expected<ClosureStore> ClosureStore::open(const std::string& path, int lock_timeout_ms) {
  Expected<StoreDatabase> database = StoreDatabase::open(path, kClosureFormat, lock_timeout_ms);
  if (!database) return database.errors();
  if (Errors errors = add_uses(*database); !errors.empty()) return errors;
  Statement insert = database->prepare(kInsertClosure);
  if (!insert) return database->failure("cannot be opened");
  return ClosureStore(std::make_unique<StoreConnection>(*std::move(database)), std::move(insert));
}

Expected<KnownOrifices> ClosureStore::read(const std::string& subject) const {
  const Statement rows = connection_->database.prepare(kSelectClosures);
  KnownOrifices known;
  int step = SQLITE_ERROR;
  if (rows) {
    bind_text(rows, 1, subject);
    while ((step = sqlite3_step(rows.get())) == SQLITE_ROW) {
      int column = 0;
      ConfigurationKey key;
      for (std::int64_t& value : key) value = sqlite3_column_int64(rows.get(), column++);
      OrificeSample& sample = known[key];
      sample.area_mm2 = number_at(rows, column++);
      sample.sd_mm2 = number_at(rows, column++);
      sample.trusted = sqlite3_column_int(rows.get(), column) != 0;
    }
  }
  if (step != SQLITE_DONE) return connection_->database.failure("cannot be read");
  return known;
}

Errors ClosureStore::keep(const std::string& subject, const ConfigurationKey& key,
                          const OrificeSample& sample) {
  sqlite3_stmt* const insert = insert_.get();
  int column = 0;
  bind_text(insert_, ++column, subject);
  for (const std::int64_t value : key) sqlite3_bind_int64(insert, ++column, value);
  for (const double value : {sample.area_mm2, sample.sd_mm2})
    sqlite3_bind_double(insert, ++column, value);  // NaN as NULL
  sqlite3_bind_int(insert, ++column, sample.trusted ? 1 : 0);

  Errors errors;
  if (sqlite3_step(insert) != SQLITE_DONE)
    errors.push_back(connection_->database.failure("a closure cannot be kept"));
  sqlite3_reset(insert);
  return errors;
}

Errors ClosureStore::note_use(const std::string& subject, std::int64_t now_ms) {
  return coapt::note_use(*connection_, kClosureTables, subject, now_ms);
}

Errors ClosureStore::retain(const ClosureLimits& limits, const SubjectsInUse& in_use,
                            std::int64_t now_ms) {
  return retain_subjects(*connection_, kClosureTables, limits, in_use, now_ms);
}

}  // namespace coapt
