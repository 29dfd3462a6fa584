#include "search/plans/pareto.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>

#include "core/repair/approximation.h"
#include "core/repair/describe.h"
#include "search/plans/durability.h"
#include "search/plans/plan_order.h"
#include "search/plans/trade_off.h"

namespace coapt {
namespace {

/// Of a plan, each less being better: leak, opening, durability; last the effort of the operation, which decides where
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

struct Candidate {
  double leak_mm2 = 0.0, effort = 0.0;
  std::optional<double> opening_mm2, durability_mm;
};

/// Of one plan, the first that beats it, and in what.
struct Beaten {
  std::optional<std::size_t> by;
  std::vector<std::string> in;
};

std::vector<Beaten> beaten(const std::vector<Candidate>& all) {
  const bool opened =
      std::all_of(all.begin(), all.end(), [](const Candidate& one) { return one.opening_mm2; });
  const bool lasts =
      std::all_of(all.begin(), all.end(), [](const Candidate& one) { return one.durability_mm; });
  std::vector<Objectives> objectives;
  for (const Candidate& one : all)
    objectives.push_back({tenths(one.leak_mm2),
                          opened ? -tenths(0.01 * *one.opening_mm2) : one.effort,
                          lasts ? -tenths(*one.durability_mm) : 0.0, one.effort});
  const std::array<const char*, 4> names = {"leak", opened ? "opening" : "effort", "reserve",
                                            "effort"};
  std::vector<Beaten> found(all.size());
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t other = 0; other < all.size() && !found[i].by; ++other) {
      if (!beats(objectives[other], objectives[i])) continue;
      found[i].by = other;
      for (std::size_t k = 0; k < names.size(); ++k)
        if (objectives[other][k] < objectives[i][k] && (k < 3 || found[i].in.empty()))
          found[i].in.emplace_back(names[k]);
    }
  return found;
}

std::optional<double> opening_of(const std::optional<PlanOpening>& opening) {
  if (!opening || !trusted(*opening)) return std::nullopt;
  return opening->measure.opening_area_mm2;
}

/// Less is simpler, as where the rule ranks (plan_order.h): steps, then muscles, then whole sizes.
double simplicity_of(const RankedPlan& plan) {
  constexpr double kPerStep = 1e4, kPerMuscle = 1e2;
  return kPerStep * plan.effort.steps + kPerMuscle * sutured_muscles(plan.plan) +
         std::round(plan.effort.sizes_below);
}

}  // namespace

void mark_pareto(std::vector<RankedPlan>& plans) {
  std::vector<RankedPlan*> eligible;
  std::vector<Candidate> candidates;
  for (RankedPlan& plan : plans) {
    plan.pareto = false;
    const double leak = plan.region.leak_mm2.mean + plan.region.leak_mm2.sd;
    if (!trusted(plan) || plan.region.failures > 0 || std::isnan(leak) || is_stenotic(plan.opening))
      continue;
    eligible.push_back(&plan);
    candidates.push_back({leak, simplicity_of(plan), opening_of(plan.opening), {}});
    if (plan.durability) candidates.back().durability_mm = plan.durability->expected_mm;
  }
  const std::vector<Beaten> found = beaten(candidates);
  for (std::size_t i = 0; i < eligible.size(); ++i) {
    eligible[i]->pareto = !found[i].by;
    if (!found[i].by) continue;
    eligible[i]->beaten_by = eligible[*found[i].by]->rank;
    eligible[i]->beaten_in = found[i].in;
  }
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
  const std::vector<Beaten> found = beaten(candidates);
  for (std::size_t i = 0; i < all.size(); ++i)
    if (!found[i].by) front.push_back(std::move(all[i]));
  std::stable_sort(front.begin(), front.end(),
                   [](const ParetoPlan& a, const ParetoPlan& b) { return a.cost < b.cost; });
  return front;
}

}  // namespace coapt
