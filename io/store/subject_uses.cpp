#include "io/store/subject_uses.h"

#include <sqlite3.h>

#include <vector>

namespace coapt {
namespace {

constexpr double kDayMs = 24.0 * 3600.0 * 1000.0;

struct SubjectUse {
  std::string name;
  std::int64_t used_ms = 0, closures = 0;
};

std::int64_t counted(Transaction& change, const SubjectTables& tables, const std::string& subject) {
  std::int64_t closures = 0;
  change.run(tables.count, {subject},
             [&closures](const Statement& row) { closures = sqlite3_column_int64(row.get(), 0); });
  return closures;
}

/// All subjects, the one used least recently first.
Expected<std::vector<SubjectUse>> uses_of(StoreConnection& store, const SubjectTables& tables,
                                          std::int64_t now_ms) {
  Transaction change(store, Transaction::Kind::Write, "uses of closures cannot be kept");
  std::vector<std::string> unknown;
  change.run("SELECT * FROM (" + std::string(tables.subjects) + ") EXCEPT SELECT subject FROM uses",
             {}, [&unknown](const Statement& row) { unknown.push_back(bytes_at(row, 0)); });
  for (const std::string& subject : unknown)
    change.run("INSERT INTO uses VALUES (?, 0, ?, ?)",
               {subject, now_ms, counted(change, tables, subject)});
  std::vector<SubjectUse> uses;
  change.run("SELECT subject, used_ms, closures FROM uses ORDER BY place, subject", {},
             [&uses](const Statement& row) {
               uses.push_back({bytes_at(row, 0), sqlite3_column_int64(row.get(), 1),
                               sqlite3_column_int64(row.get(), 2)});
             });
  return change.end_with(std::move(uses));
}

/// In steps, so that those who keep closures meanwhile wait for one step at most.
Errors remove_subject(StoreConnection& store, const SubjectTables& tables,
                      const std::string& subject) {
  for (int removed = 1; removed > 0;) {
    Transaction change(store, Transaction::Kind::Write, "old closures cannot be removed");
    change.run(tables.remove, {subject});
    removed = change.changed();
    if (removed == 0) {
      change.run("DELETE FROM uses WHERE subject = ?", {subject});
      if (*tables.forget != '\0') change.run(tables.forget, {subject});
    }
    if (Errors errors = change.end(); !errors.empty()) return errors;
  }
  return {};
}

constexpr const char* kMakeUses = R"(CREATE TABLE IF NOT EXISTS uses (
  subject TEXT PRIMARY KEY,
  place INTEGER NOT NULL,    -- in the order of use; 0: before it was noted
  used_ms INTEGER NOT NULL,  -- since 1970, for its age
  closures INTEGER NOT NULL  -- then
) STRICT, WITHOUT ROWID)";

}  // namespace

Errors add_uses(const StoreDatabase& database) {
  const Statement make = database.prepare(kMakeUses);
  if (make && sqlite3_step(make.get()) == SQLITE_DONE) return {};
  return {database.failure("cannot be opened")};
}

Errors note_use(StoreConnection& store, const SubjectTables& tables, const std::string& subject,
                std::int64_t now_ms) {
  Transaction change(store, Transaction::Kind::Write, "a use of closures cannot be kept");
  const std::int64_t closures = counted(change, tables, subject);
  if (closures > 0)
    change.run(
        "INSERT OR REPLACE INTO uses SELECT ?1, coalesce(max(place), 0) + 1, ?2, ?3 FROM uses",
        {subject, now_ms, closures});
  return change.end();
}

Errors retain_subjects(StoreConnection& store, const SubjectTables& tables,
                       const ClosureLimits& limits, const SubjectsInUse& in_use,
                       std::int64_t now_ms) {
  const Expected<std::vector<SubjectUse>> uses = uses_of(store, tables, now_ms);
  if (!uses) return uses.errors();
  std::int64_t closures = 0;
  for (const SubjectUse& use : *uses) closures += use.closures;
  const auto is_old = [&](const SubjectUse& use) {
    return limits.days > 0.0 && static_cast<double>(now_ms - use.used_ms) > limits.days * kDayMs;
  };
  std::set<std::string> staying;
  bool is_asked = false, has_removed = false;
  for (const SubjectUse& use : *uses) {
    if (closures <= limits.closures && !is_old(use)) continue;
    if (!is_asked) {
      Expected<std::set<std::string>> used = in_use();
      if (!used) return used.errors();
      staying = *std::move(used);
      is_asked = true;
    }
    if (staying.contains(use.name)) continue;
    if (Errors errors = remove_subject(store, tables, use.name); !errors.empty()) return errors;
    closures -= use.closures;
    has_removed = true;
  }
  if (!has_removed || *tables.tidy == '\0') return {};
  Transaction change(store, Transaction::Kind::Write, "old closures cannot be removed");
  change.run(tables.tidy);
  return change.end();
}

}  // namespace coapt
