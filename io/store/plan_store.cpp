#include "io/store/plan_store.h"

#include <sqlite3.h>

#include <array>
#include <utility>

namespace coapt {
namespace {

// The numbers are ANY, because REAL would make 0.0 of -0.0.
constexpr StoreFormat kPlanFormat = {.application = 0x636f706c,  // "copl"
                                     .schema = 1,
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
  orifice_mm2 ANY,        -- floating point; NULL is NaN
  gap_mm2 ANY,            -- likewise, as all below
  coaptation_mm ANY,
  distance_max_mm ANY,
  tension_max_n ANY,
  PRIMARY KEY (subject, plan, disturbance)
) STRICT, WITHOUT ROWID;
)",
                                     // 16 MB: a third faster than 1,000 where every plan is new
                                     .log_pages = 4000};

// Not INSERT OR IGNORE, which would pass over every constraint and not only over the key's.
constexpr const char* kInsertOutcome =
    "INSERT INTO closures VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?) ON CONFLICT DO NOTHING";
constexpr const char* kInsertSubject =
    "INSERT INTO subjects (name) VALUES (?) ON CONFLICT DO NOTHING";
constexpr const char* kInsertPlan = "INSERT INTO plans (name) VALUES (?) ON CONFLICT DO NOTHING";
constexpr const char* kSelectSubject = "SELECT number FROM subjects WHERE name = ?";
constexpr const char* kSelectPlan = "SELECT number FROM plans WHERE name = ?";

// CROSS JOIN: closures outside, plans inside. In the order of the key, so nothing is sorted.
constexpr const char* kSelectOutcomes =
    "SELECT plan, name, disturbance, status, crossing, orifice_mm2, gap_mm2, coaptation_mm, "
    "distance_max_mm, tension_max_n FROM closures CROSS JOIN plans ON plans.number = plan "
    "WHERE subject = (SELECT number FROM subjects WHERE name = ?) ORDER BY plan, disturbance";

// The columns of floating point, in order.
constexpr std::array kNumbers = {&PlanClosure::orifice_mm2, &PlanClosure::gap_mm2,
                                 &PlanClosure::coaptation_mm, &PlanClosure::distance_max_mm,
                                 &PlanClosure::tension_max_n};

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

}  // namespace

std::optional<std::int64_t> PlanStore::Names::find(const std::string& name) const {
  std::optional<std::int64_t> number;
  bind_text(select, 1, name);
  if (sqlite3_step(select.get()) == SQLITE_ROW) number = sqlite3_column_int64(select.get(), 0);
  sqlite3_reset(select.get());
  return number;
}

std::optional<std::int64_t> PlanStore::Names::number_of(const std::string& name) {
  if (const auto asked = numbers.find(name); asked != numbers.end()) return asked->second;
  std::optional<std::int64_t> number = find(name);
  if (!number) {
    bind_text(insert, 1, name);
    const bool is_there = sqlite3_step(insert.get()) == SQLITE_DONE;
    sqlite3_reset(insert.get());
    if (is_there) number = find(name);
  }
  if (number) numbers.emplace(name, *number);
  return number;
}

PlanStore::PlanStore(StoreDatabase database, Names subjects, Names plans, Statement insert)
    : database_(std::move(database)),
      subjects_(std::move(subjects)),
      plans_(std::move(plans)),
      insert_(std::move(insert)) {}

Expected<PlanStore> PlanStore::open(const std::string& path, int lock_timeout_ms) {
  Expected<StoreDatabase> database = StoreDatabase::open(path, kPlanFormat, lock_timeout_ms);
  if (!database) return database.errors();
  constexpr std::array sql = {kSelectSubject, kInsertSubject, kSelectPlan, kInsertPlan,
                              kInsertOutcome};
  std::array<Statement, sql.size()> statements;
  for (std::size_t i = 0; i < sql.size(); ++i) {
    statements[i] = database->prepare(sql[i]);
    if (!statements[i]) return database->failure("cannot be opened");
  }
  auto& [select_subject, insert_subject, select_plan, insert_plan, insert] = statements;
  return PlanStore(*std::move(database), {std::move(select_subject), std::move(insert_subject), {}},
                   {std::move(select_plan), std::move(insert_plan), {}}, std::move(insert));
}

Expected<KnownPlans> PlanStore::read(const std::string& subject) const {
  const Statement rows = database_.prepare(kSelectOutcomes);
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
  if (step != SQLITE_DONE) return database_.failure("cannot be read");
  return known;
}

Errors PlanStore::keep(const std::string& subject, const std::string& plan_key, int disturbance,
                       const PlanClosure& closure) {
  const auto refused = [this] { return Errors{database_.failure("a closure cannot be kept")}; };
  const std::optional<std::int64_t> subject_number = subjects_.number_of(subject);
  if (!subject_number) return refused();
  const std::optional<std::int64_t> plan_number = plans_.number_of(plan_key);
  if (!plan_number) return refused();

  sqlite3_stmt* const insert = insert_.get();
  int parameter = 0;
  sqlite3_bind_int64(insert, ++parameter, *subject_number);
  sqlite3_bind_int64(insert, ++parameter, *plan_number);
  sqlite3_bind_int(insert, ++parameter, disturbance);
  sqlite3_bind_int(insert, ++parameter, number_of(closure.status));
  sqlite3_bind_int(insert, ++parameter, closure.crossing ? 1 : 0);
  for (const auto number : kNumbers)
    sqlite3_bind_double(insert, ++parameter, closure.*number);  // NaN as NULL

  const bool is_kept = sqlite3_step(insert) == SQLITE_DONE;
  sqlite3_reset(insert);
  return is_kept ? Errors{} : refused();
}

}  // namespace coapt
