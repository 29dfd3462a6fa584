#include "io/store/plan_store.h"

#include <sqlite3.h>

#include <array>
#include <utility>

namespace coapt {
namespace {

// The numbers are ANY, because REAL would make 0.0 of -0.0.
constexpr StoreFormat kPlanFormat = {
    .application = 0x636f706c,  // "copl"
    .schema = 2,
    .rows = "plans",
    .tables = R"(
CREATE TABLE subjects (
  number INTEGER PRIMARY KEY,
  name TEXT NOT NULL UNIQUE  -- valve, closure options and version, hashed
) STRICT;
CREATE TABLE plans (
  number INTEGER PRIMARY KEY,
  name TEXT NOT NULL UNIQUE  -- the steps, a line of text
) STRICT;
CREATE TABLE closures (
  subject INTEGER REFERENCES subjects,
  plan INTEGER REFERENCES plans,
  disturbance INTEGER,    -- 0 is the plan as planned
  status INTEGER NOT NULL CHECK (status BETWEEN 0 AND 2),  -- converged, step limit, diverged
  crossing INTEGER NOT NULL,
  leak_mm2 ANY,           -- floating point; NULL is NaN
  coaptation_mm ANY,      -- likewise, as all below
  distance_max_mm ANY,
  tension_max_n ANY,
  leaflet_ratio ANY,
  PRIMARY KEY (subject, plan, disturbance)
) STRICT, WITHOUT ROWID;
)",
    // What release 0.2 kept is of subjects that are not asked for again.
    .upgrade =
        "ALTER TABLE closures RENAME COLUMN orifice_mm2 TO "
        "leak_mm2; ALTER TABLE closures DROP COLUMN gap_mm2; "
        "ALTER TABLE closures ADD COLUMN leaflet_ratio ANY;",
    // 16 MB: a third faster than 1,000 where every plan is new
    .log_pages = 4000};

// Not INSERT OR IGNORE, which would pass over every constraint and not only over the key's. No row if subject or
// plan has no name in the file yet.
constexpr const char* kInsertOutcome =
    "INSERT INTO closures SELECT subjects.number, plans.number, ?, ?, ?, ?, ?, ?, ?, ? "
    "FROM subjects CROSS JOIN plans WHERE subjects.name = ? AND plans.name = ? "
    "ON CONFLICT DO NOTHING";
constexpr const char* kInsertSubject =
    "INSERT INTO subjects (name) VALUES (?) ON CONFLICT DO NOTHING";
constexpr const char* kInsertPlan = "INSERT INTO plans (name) VALUES (?) ON CONFLICT DO NOTHING";

// CROSS JOIN: closures outside, plans inside. In the order of the key, so nothing is sorted.
constexpr const char* kSelectOutcomes =
    "SELECT plan, name, disturbance, status, crossing, leak_mm2, coaptation_mm, "
    "distance_max_mm, tension_max_n, leaflet_ratio FROM closures CROSS JOIN plans ON plans.number "
    "= plan "
    "WHERE subject = (SELECT number FROM subjects WHERE name = ?) ORDER BY plan, disturbance";

constexpr SubjectTables kPlanTables = {
    .subjects = "SELECT name FROM subjects",
    .count =
        "SELECT count(*) FROM closures WHERE subject = "
        "(SELECT number FROM subjects WHERE name = ?1)",
    .remove =
        "DELETE FROM closures WHERE (subject, plan, disturbance) IN (SELECT subject, plan, "
        "disturbance FROM closures WHERE subject = "
        "(SELECT number FROM subjects WHERE name = ?1) LIMIT 10000)",
    .forget =
        "DELETE FROM subjects WHERE name = ?1 AND NOT EXISTS "
        "(SELECT 1 FROM closures WHERE subject = subjects.number)",
    .tidy = "DELETE FROM plans WHERE number NOT IN (SELECT plan FROM closures)"};

// The columns of floating point, in order.
constexpr std::array kNumbers = {&PlanClosure::leak_mm2, &PlanClosure::coaptation_mm,
                                 &PlanClosure::distance_max_mm, &PlanClosure::tension_max_n,
                                 &PlanClosure::leaflet_ratio};

/// As the file has it: its own numbers, which no change of the enumeration moves.
int number_of(ClosureStatus status) {
  switch (status) {
    case ClosureStatus::Converged:
      return 0;
    case ClosureStatus::StepLimit:
      return 1;
    case ClosureStatus::Diverged:
      return 2;
  }
  return -1;
}

/// Diverged, which nobody trusts, if the number is of no status.
ClosureStatus status_at(const Statement& row, int column) {
  const int number = sqlite3_column_int(row.get(), column);
  for (const ClosureStatus status : {ClosureStatus::Converged, ClosureStatus::StepLimit})
    if (number == number_of(status)) return status;
  return ClosureStatus::Diverged;
}

/// To its end, without a row.
bool has_run(const Statement& statement) {
  const bool is_done = sqlite3_step(statement.get()) == SQLITE_DONE;
  sqlite3_reset(statement.get());
  return is_done;
}

}  // namespace

PlanStore::PlanStore(std::unique_ptr<StoreConnection> connection, Statements statements)
    : connection_(std::move(connection)), statements_(std::move(statements)) {}

Expected<PlanStore> PlanStore::open(const std::string& path, int lock_timeout_ms) {
  Expected<StoreDatabase> database = StoreDatabase::open(path, kPlanFormat, lock_timeout_ms);
  if (!database) return database.errors();
  if (Errors errors = add_uses(*database); !errors.empty()) return errors;
  constexpr std::array sql = {kInsertOutcome,    kInsertSubject, kInsertPlan,
                              "BEGIN IMMEDIATE", "COMMIT",       "ROLLBACK"};
  std::array<Statement, sql.size()> prepared;
  for (std::size_t i = 0; i < sql.size(); ++i) {
    prepared[i] = database->prepare(sql[i]);
    if (!prepared[i]) return database->failure("cannot be opened");
  }
  auto& [insert, add_subject, add_plan, begin, commit, rollback] = prepared;
  return PlanStore(std::make_unique<StoreConnection>(*std::move(database)),
                   {std::move(insert), std::move(add_subject), std::move(add_plan),
                    std::move(begin), std::move(commit), std::move(rollback)});
}

Expected<KnownPlans> PlanStore::read(const std::string& subject) const {
  const Statement rows = connection_->database.prepare(kSelectOutcomes);
  KnownPlans known;
  int step = SQLITE_ERROR;
  if (rows) {
    bind_text(rows, 1, subject);
    PlanClosures* closures = nullptr;
    std::int64_t last_plan = 0;
    while ((step = sqlite3_step(rows.get())) == SQLITE_ROW) {
      const std::int64_t plan = sqlite3_column_int64(rows.get(), 0);
      if (closures == nullptr || plan != last_plan) closures = &known[bytes_at(rows, 1)];
      last_plan = plan;
      PlanClosure& closure = (*closures)[sqlite3_column_int(rows.get(), 2)];
      closure.status = status_at(rows, 3);
      closure.crossing = sqlite3_column_int(rows.get(), 4) != 0;
      int column = 5;
      for (const auto number : kNumbers) closure.*number = number_at(rows, column++);
    }
  }
  if (step != SQLITE_DONE) return connection_->database.failure("cannot be read");
  return known;
}

Errors PlanStore::keep(const std::string& subject, const std::string& plan_key, int disturbance,
                       const PlanClosure& closure) {
  sqlite3_stmt* const insert = statements_.insert.get();
  int parameter = 0;
  sqlite3_bind_int(insert, ++parameter, disturbance);
  sqlite3_bind_int(insert, ++parameter, number_of(closure.status));
  sqlite3_bind_int(insert, ++parameter, closure.crossing ? 1 : 0);
  for (const auto number : kNumbers)
    sqlite3_bind_double(insert, ++parameter, closure.*number);  // NaN as NULL
  bind_text(statements_.insert, ++parameter, subject);
  bind_text(statements_.insert, ++parameter, plan_key);
  if (!has_run(statements_.insert))
    return {connection_->database.failure("a closure cannot be kept")};
  if (connection_->database.changed() == 1) return {};
  return keep_with_names(subject, plan_key);
}

/// The closure that is bound already. Names and closure in one transaction, so that no name goes before its closure
/// is there. One that was kept before stays.
Errors PlanStore::keep_with_names(const std::string& subject, const std::string& plan_key) {
  bind_text(statements_.add_subject, 1, subject);
  bind_text(statements_.add_plan, 1, plan_key);
  if (has_run(statements_.begin) && has_run(statements_.add_subject) &&
      has_run(statements_.add_plan) && has_run(statements_.insert) && has_run(statements_.commit))
    return {};
  Errors errors = {connection_->database.failure("a closure cannot be kept")};
  if (connection_->database.in_transaction()) has_run(statements_.rollback);
  return errors;
}

Errors PlanStore::note_use(const std::string& subject, std::int64_t now_ms) {
  return coapt::note_use(*connection_, kPlanTables, subject, now_ms);
}

Errors PlanStore::retain(const ClosureLimits& limits, const SubjectsInUse& in_use,
                         std::int64_t now_ms) {
  return retain_subjects(*connection_, kPlanTables, limits, in_use, now_ms);
}

}  // namespace coapt
