#include "io/store/kept_plans.h"

#include "io/store/list_page.h"

namespace coapt {
namespace {

constexpr const char* kKeptColumns = "SELECT number, id, name, valve, plan FROM kept_plans";

KeptPlan kept_plan_at(const Statement& row) {
  return {bytes_at(row, 1), bytes_at(row, 2), bytes_at(row, 3), bytes_at(row, 4)};
}

}  // namespace

Expected<bool> keep_plan(JobStore& store, const KeptPlan& plan, int most) {
  Transaction change = store.writing("a plan cannot be kept");
  change.run(
      "INSERT INTO kept_plans (id, name, valve, plan) SELECT ?, ?, ?, ? "
      "WHERE (SELECT count(*) FROM kept_plans) < ?",
      {plan.id, plan.name, plan.valve, plan.plan, std::int64_t{most}});
  const bool is_kept = change.changed() == 1;
  return change.end_with(is_kept);
}

Expected<std::optional<KeptPlan>> kept_plan(const JobStore& store, const std::string& id) {
  std::optional<KeptPlan> plan;
  Transaction reads = store.reading();
  reads.run(std::string(kKeptColumns) + " WHERE id = ?", {id},
            [&plan](const Statement& row) { plan = kept_plan_at(row); });
  return reads.end_with(std::move(plan));
}

Expected<KeptPlanPage> kept_plans(const JobStore& store, int size, std::int64_t before,
                                  const std::string& valve) {
  std::string sql = std::string(kKeptColumns) + " WHERE number < ?";
  std::vector<SqlValue> values = {upper_end(before)};
  if (!valve.empty()) {
    sql += " AND valve = ?";
    values.emplace_back(valve);
  }
  KeptPlanPage page;
  Transaction reads = store.reading();
  page.next_before = read_page(reads, sql, std::move(values), size, [&page](const Statement& row) {
    page.plans.push_back(kept_plan_at(row));
  });
  return reads.end_with(std::move(page));
}

Expected<bool> rename_kept_plan(JobStore& store, const std::string& id, const std::string& name) {
  Transaction change = store.writing("a kept plan cannot be renamed");
  change.run("UPDATE kept_plans SET name = ?2 WHERE id = ?1", {id, name});
  const bool was_there = change.changed() == 1;
  return change.end_with(was_there);
}

Expected<bool> remove_kept_plan(JobStore& store, const std::string& id) {
  Transaction change = store.writing("a kept plan cannot be removed");
  change.run("DELETE FROM kept_plans WHERE id = ?", {id});
  const bool was_there = change.changed() == 1;
  return change.end_with(was_there);
}

}  // namespace coapt
