#include "search/plans/pareto.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/repair/describe.h"
#include "search/plans/region_report.h"

namespace coapt {
namespace {

/// Each less being better.
using Objectives = std::array<double, 4>;

bool beats(const Objectives& a, const Objectives& b) {
  bool better = false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i] > b[i]) return false;
    better = better || a[i] < b[i];
  }
  return better;
}

/// Those that none beats.
std::vector<std::size_t> unbeaten(const std::vector<Objectives>& all) {
  std::vector<std::size_t> front;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (std::none_of(all.begin(), all.end(),
                     [&](const auto& other) { return beats(other, all[i]); }))
      front.push_back(i);
  return front;
}

double tenths(double value) { return std::round(10.0 * value); }

/// The price decides between plans that are alike in all three.
bool beats_alike(const Objectives& a, const Objectives& b) {
  const bool alike = std::equal(a.begin(), a.begin() + 3, b.begin());
  return alike ? a[3] < b[3] : beats({a[0], a[1], a[2], 0.0}, {b[0], b[1], b[2], 0.0});
}

}  // namespace

std::vector<ParetoPlan> pareto_front(const PlanEvaluations& evaluations,
                                     const std::vector<const PlanRecord*>& plans, int nodes) {
  std::vector<ParetoPlan> all, front;
  for (const PlanRecord* plan : plans) {
    const RegionReport region = region_report(*plan, nodes);
    if (region.failures > 0 || std::isnan(region.leak_mm2.mean)) continue;
    ParetoPlan made{plan->plan,           describe(evaluations.valve(), plan->plan),
                    region.leak_mm2.mean, region.leak_mm2.sd,
                    plan->effort.steps,   plan->effort.sizes_below};
    if (plan->opening && trusted(*plan->opening))
      made.opening_mm2 = opening_mm2(plan->opening->measure);
    made.nodes = nodes;
    all.push_back(std::move(made));
  }
  const bool opened = std::none_of(
      all.begin(), all.end(), [](const ParetoPlan& plan) { return std::isnan(plan.opening_mm2); });
  std::vector<Objectives> objectives;
  for (const ParetoPlan& plan : all)
    objectives.push_back({plan.mean_mm2, plan.sd_mm2, static_cast<double>(plan.steps),
                          opened ? -plan.opening_mm2 : plan.sizes_below});
  for (const std::size_t i : unbeaten(objectives)) front.push_back(all[i]);
  std::stable_sort(front.begin(), front.end(), [](const ParetoPlan& a, const ParetoPlan& b) {
    return a.steps != b.steps ? a.steps < b.steps : a.mean_mm2 < b.mean_mm2;
  });
  return front;
}

void mark_pareto(const CostWeights& weights, std::vector<RankedPlan>& plans) {
  const auto known = [&](const auto& is_known) {
    return std::all_of(plans.begin(), plans.end(), is_known);
  };
  const bool opened =
      known([](const RankedPlan& plan) { return plan.opening && trusted(*plan.opening); });
  const bool lasts = known([](const RankedPlan& plan) { return plan.durability.has_value(); });
  std::vector<RankedPlan*> eligible;
  std::vector<Objectives> objectives;
  for (RankedPlan& plan : plans) {
    plan.pareto = false;
    const double leak = plan.region.leak_mm2.mean + plan.region.leak_mm2.sd;
    if (!trusted(plan) || plan.region.failures > 0 || std::isnan(leak) || is_stenotic(plan.opening))
      continue;
    eligible.push_back(&plan);
    objectives.push_back({tenths(leak),
                          opened ? -tenths(0.01 * opening_mm2(plan.opening->measure))
                                 : effort_price(plan.effort, weights),
                          lasts ? -tenths(plan.durability->expected_mm) : 0.0,
                          effort_price(plan.effort, weights)});
  }
  for (std::size_t i = 0; i < eligible.size(); ++i)
    eligible[i]->pareto =
        std::none_of(objectives.begin(), objectives.end(),
                     [&](const Objectives& other) { return beats_alike(other, objectives[i]); });
}

}  // namespace coapt
