// Lists of valves, and the plans that people keep.
#include <sqlite3.h>

#include <limits>

#include "io/store/job_store.h"

namespace coapt {
namespace {

constexpr const char* kKeptColumns = "SELECT number, id, name, valve, plan FROM kept_plans";

KeptPlan kept_plan_at(const Statement& row) {
  return {bytes_at(row, 1), bytes_at(row, 2), bytes_at(row, 3), bytes_at(row, 4)};
}

std::int64_t upper_end(std::int64_t before) {
  return before == 0 ? std::numeric_limits<std::int64_t>::max() : before;
}

/// Rows of a list, the first column its number: `size` of them go to `take`. Where the next page starts; 0: nowhere.
std::int64_t read_page(Transaction& reads, const std::string& sql, std::vector<SqlValue> values,
                       int size, const Transaction::OnRow& take) {
  values.emplace_back(std::int64_t{size} + 1);  // the last tells whether there are more
  int taken = 0;
  std::int64_t last = 0, next = 0;
  reads.run(sql + " ORDER BY number DESC LIMIT ?", values, [&](const Statement& row) {
    if (++taken > size) {
      next = last;
      return;
    }
    last = sqlite3_column_int64(row.get(), 0);
    take(row);
  });
  return next;
}

}  // namespace

Expected<ValvePage> JobStore::valves(int size, std::int64_t before) const {
  ValvePage page;
  Transaction reads = reading();
  page.next_before = read_page(
      reads,
      "SELECT number, id, name, vertices, triangles FROM valves JOIN valve_summaries ON "
      "valve = number WHERE number < ?",
      {upper_end(before)}, size, [&page](const Statement& row) {
        page.valves.push_back({bytes_at(row, 1), bytes_at(row, 2), sqlite3_column_int(row.get(), 3),
                               sqlite3_column_int(row.get(), 4)});
      });
  return reads.end_with(std::move(page));
}

Expected<bool> JobStore::keep_plan(const KeptPlan& plan, int most) {
  Transaction change = writing("a plan cannot be kept");
  change.run(
      "INSERT INTO kept_plans (id, name, valve, plan) SELECT ?, ?, ?, ? "
      "WHERE (SELECT count(*) FROM kept_plans) < ?",
      {plan.id, plan.name, plan.valve, plan.plan, std::int64_t{most}});
  const bool is_kept = change.changed() == 1;
  return change.end_with(is_kept);
}

Expected<std::optional<KeptPlan>> JobStore::kept_plan(const std::string& id) const {
  std::optional<KeptPlan> plan;
  Transaction reads = reading();
  reads.run(std::string(kKeptColumns) + " WHERE id = ?", {id},
            [&plan](const Statement& row) { plan = kept_plan_at(row); });
  return reads.end_with(std::move(plan));
}

Expected<KeptPlanPage> JobStore::kept_plans(int size, std::int64_t before,
                                            const std::string& valve) const {
  std::string sql = std::string(kKeptColumns) + " WHERE number < ?";
  std::vector<SqlValue> values = {upper_end(before)};
  if (!valve.empty()) {
    sql += " AND valve = ?";
    values.emplace_back(valve);
  }
  KeptPlanPage page;
  Transaction reads = reading();
  page.next_before = read_page(reads, sql, std::move(values), size, [&page](const Statement& row) {
    page.plans.push_back(kept_plan_at(row));
  });
  return reads.end_with(std::move(page));
}

Expected<bool> JobStore::rename_kept_plan(const std::string& id, const std::string& name) {
  Transaction change = writing("a kept plan cannot be renamed");
  change.run("UPDATE kept_plans SET name = ?2 WHERE id = ?1", {id, name});
  const bool was_there = change.changed() == 1;
  return change.end_with(was_there);
}

Expected<bool> JobStore::remove_kept_plan(const std::string& id) {
  Transaction change = writing("a kept plan cannot be removed");
  change.run("DELETE FROM kept_plans WHERE id = ?", {id});
  const bool was_there = change.changed() == 1;
  return change.end_with(was_there);
}

}  // namespace coapt
