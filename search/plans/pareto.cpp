#include "search/plans/pareto.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/repair/describe.h"
#include "search/plans/durability.h"
#include "search/plans/trade_off.h"

namespace coapt {
namespace {

/// Of a plan, each less being better: leak, opening, durability; last the price of the operation, which decides where
/// the others are alike.
using Objectives = std::array<double, 4>;

bool beats(const Objectives& a, const Objectives& b) {
  bool better = false;
  for (std::size_t i = 0; i < 3; ++i) {
    if (a[i] > b[i]) return false;
    better = better || a[i] < b[i];
  }
  return better || a[3] < b[3];
}

double tenths(double value) { return std::round(10.0 * value); }

struct Candidate {
  double leak_mm2 = 0.0, price = 0.0;
  std::optional<double> opening_mm2, durability_mm;
};

/// Of each, whether no other beats it.
std::vector<bool> unbeaten(const std::vector<Candidate>& all) {
  const bool opened =
      std::all_of(all.begin(), all.end(), [](const Candidate& one) { return one.opening_mm2; });
  const bool lasts =
      std::all_of(all.begin(), all.end(), [](const Candidate& one) { return one.durability_mm; });
  std::vector<Objectives> objectives;
  for (const Candidate& one : all)
    objectives.push_back({tenths(one.leak_mm2),
                          opened ? -tenths(0.01 * *one.opening_mm2) : one.price,
                          lasts ? -tenths(*one.durability_mm) : 0.0, one.price});
  std::vector<bool> found;
  for (const Objectives& mine : objectives)
    found.push_back(std::none_of(objectives.begin(), objectives.end(),
                                 [&](const Objectives& other) { return beats(other, mine); }));
  return found;
}

std::optional<double> opening_of(const std::optional<PlanOpening>& opening) {
  if (!opening || !trusted(*opening)) return std::nullopt;
  return opening->measure.opening_area_mm2;
}

}  // namespace

void mark_pareto(const CostWeights& weights, std::vector<RankedPlan>& plans) {
  std::vector<RankedPlan*> eligible;
  std::vector<Candidate> candidates;
  for (RankedPlan& plan : plans) {
    plan.pareto = false;
    const double leak = plan.region.leak_mm2.mean + plan.region.leak_mm2.sd;
    if (!trusted(plan) || plan.region.failures > 0 || std::isnan(leak) || is_stenotic(plan.opening))
      continue;
    eligible.push_back(&plan);
    candidates.push_back({leak, effort_price(plan.effort, weights), opening_of(plan.opening), {}});
    if (plan.durability) candidates.back().durability_mm = plan.durability->expected_mm;
  }
  const std::vector<bool> found = unbeaten(candidates);
  for (std::size_t i = 0; i < eligible.size(); ++i) eligible[i]->pareto = found[i];
}

std::vector<ParetoPlan> pareto_front(const PlanEvaluations& evaluations,
                                     const std::vector<const PlanRecord*>& plans, int nodes) {
  const bool traded = std::any_of(plans.begin(), plans.end(), [nodes](const PlanRecord* plan) {
    return trade_off(*plan, nodes).has_value();
  });
  std::vector<ParetoPlan> all, front;
  std::vector<Candidate> candidates;
  const CostWeights& weights = evaluations.context().weights;
  for (const PlanRecord* plan : plans) {
    const double leak = region_leak_mm2(*plan, nodes);
    if (std::isnan(leak) || is_stenotic(plan->opening) || (traded && !trade_off(*plan, nodes)))
      continue;
    const LeakStatistics statistics = leak_statistics(*plan, nodes);
    ParetoPlan made{plan->plan,         describe(evaluations.valve(), plan->plan),
                    statistics.mean,    statistics.sd,
                    plan->effort.steps, plan->effort.sizes_below};
    candidates.push_back({leak, plan->lowest_cost, opening_of(plan->opening), {}});
    made.cost = evaluations.cost(*plan, nodes);
    if (candidates.back().opening_mm2) made.opening_mm2 = *candidates.back().opening_mm2;
    if (const auto lasts = durability(*plan)) {
      candidates.back().durability_mm = made.durability_mm = lasts->expected_mm;
      made.cost += price(durability_terms(*lasts), weights);
    }
    made.nodes = nodes;
    all.push_back(std::move(made));
  }
  const std::vector<bool> found = unbeaten(candidates);
  for (std::size_t i = 0; i < all.size(); ++i)
    if (found[i]) front.push_back(std::move(all[i]));
  std::stable_sort(front.begin(), front.end(),
                   [](const ParetoPlan& a, const ParetoPlan& b) { return a.cost < b.cost; });
  return front;
}

}  // namespace coapt
