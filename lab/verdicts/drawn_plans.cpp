#include "lab/verdicts/drawn_plans.h"

#include <random>
#include <set>
#include <string>

#include "core/repair/apply_plan.h"
#include "search/plans/gates.h"
#include "search/plans/plan_key.h"
#include "search/plans/plan_space.h"
#include "search/random_share.h"

namespace coapt {
namespace {

constexpr int kMostDrawnFactor = 50;  // gives up after so many times the count

}  // namespace

std::vector<RepairPlan> draw_plans(const Valve& valve, int count, std::uint64_t seed) {
  const PlanSpace space(valve, {});
  std::mt19937_64 engine(seed);
  const auto below = [&engine](std::int64_t upto) {
    return static_cast<std::int64_t>(random_share(engine) * static_cast<double>(upto));
  };
  std::vector<RepairPlan> plans;
  std::set<std::string> keys;
  const auto branches = static_cast<std::int64_t>(space.branches().size());
  for (int drawn = 0; drawn < kMostDrawnFactor * count && std::ssize(plans) < count; ++drawn) {
    const Branch& branch = space.branches()[static_cast<std::size_t>(below(branches))];
    const RepairPlan plan = space.plan(branch, point_at(branch, below(point_count(branch))));
    const Expected<Valve> repaired = apply_plan(valve, plan);
    if (!repaired || is_rejected(operation_gates({plan, valve, *repaired}))) continue;
    if (keys.insert(plan_key(plan)).second) plans.push_back(plan);
  }
  return plans;
}

}  // namespace coapt
