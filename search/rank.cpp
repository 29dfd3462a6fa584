#include "search/rank.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <set>
#include <span>

#include "core/repair/apply_plan.h"
#include "search/objective.h"
#include "search/parallel.h"
#include "search/perturbation.h"
#include "search/warnings.h"

namespace coapt {
namespace {

constexpr double kClass_mm2 = 0.5;
constexpr int kFirstNodes = 5;

std::string kind(const Choice& choice) {
  const auto anchor = [](const std::optional<Anchor>& a) {
    return std::string(a ? to_string(*a) : "none");
  };
  return (choice.ring ? choice.ring->shape : "none") + ' ' + anchor(choice.anterolateral) + ' ' +
         anchor(choice.posteromedial) + ' ' + std::to_string(choice.neochordae);
}

OrificeStatistics statistics(double nominal, const std::vector<double>& areas) {
  constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
  if (areas.size() < 2) return {nominal, kUnknown, kUnknown, kUnknown};
  OrificeStatistics result;
  result.nominal = result.worst = nominal;
  for (const double area : areas) {
    result.mean += area / static_cast<double>(areas.size());
    result.worst = std::max(result.worst, area);
  }
  double variance = 0.0;
  for (const double area : areas)
    variance += (area - result.mean) * (area - result.mean) / static_cast<double>(areas.size());
  result.sd = std::sqrt(variance);
  return result;
}

/// @param region its first `nodes` are closed; the others do not count.
RankedPlan ranked(const RankRequest& request, const Trial& trial,
                  const std::vector<std::optional<Evaluation>>& region, std::size_t nodes) {
  RankedPlan plan;
  plan.plan = trial.plan;
  plan.description = describe(request.valve, trial.plan);
  plan.cost = trial.cost;
  plan.status = trial.evaluation.status;
  plan.crossing = trial.evaluation.crossing;
  plan.measure = trial.evaluation.measure;
  const Expected<Valve> repaired = apply_plan(request.valve, trial.plan, request.catalogue);
  const Effort asked = effort(request.valve, *repaired, trial.plan);
  plan.ring_sizes_below = asked.sizes_below;
  plan.anterolateral_movement_mm = asked.anterolateral_movement_mm;
  plan.posteromedial_movement_mm = asked.posteromedial_movement_mm;
  std::vector<double> areas, leaks;
  plan.region_closures = static_cast<int>(nodes);
  for (const std::optional<Evaluation>& evaluation : std::span(region).first(nodes)) {
    if (!trusted(*evaluation)) {
      ++plan.region_failures;
      continue;
    }
    areas.push_back(evaluation->measure.orifice.area_mm2);
    leaks.push_back(leak_mm2(evaluation->measure));
  }
  plan.orifice_area_mm2 = statistics(trial.evaluation.measure.orifice.area_mm2, areas);
  plan.leak_mm2 = statistics(leak_mm2(trial.evaluation.measure), leaks);
  plan.warnings = operation_warnings({trial.plan, request.valve, *repaired, request.catalogue});
  for (std::string& line : closure_warnings(plan, request.before))
    plan.warnings.push_back(std::move(line));
  return plan;
}

bool failed(const RankedPlan& plan) { return !trusted({plan.status, plan.crossing, plan.measure}); }

bool is_better(const RankedPlan& a, const RankedPlan& b) {
  const auto leak_class = [](const RankedPlan& plan) {
    const OrificeStatistics& leak = plan.leak_mm2;
    return std::floor((std::isnan(leak.mean) ? leak.nominal : leak.mean + leak.sd) / kClass_mm2);
  };
  if (failed(a) != failed(b)) return failed(b);
  if (failed(a)) return a.cost < b.cost;
  const auto share_a = std::int64_t{a.region_failures} * b.region_closures;
  const auto share_b = std::int64_t{b.region_failures} * a.region_closures;
  if (share_a != share_b) return share_a < share_b;
  if (leak_class(a) != leak_class(b)) return leak_class(a) < leak_class(b);
  return a.cost < b.cost;
}

/// A finalist and what is known of its region; nodes not closed are empty.
struct Finalist {
  Trial trial;
  std::vector<std::optional<Evaluation>> region;
  RankedPlan plan;
};

int finalist_count(const SearchOptions& options) { return 2 * options.plans; }
int first_nodes(const SearchOptions& options) {
  return std::min(kFirstNodes, options.region_points);
}

/// Nodes that all finalists have closed, counted from the first.
std::size_t common_nodes(const std::vector<Finalist>& finalists) {
  std::size_t common = std::numeric_limits<std::size_t>::max();
  for (const Finalist& finalist : finalists) {
    const auto open = std::find(finalist.region.begin(), finalist.region.end(), std::nullopt);
    common = std::min(common, static_cast<std::size_t>(open - finalist.region.begin()));
  }
  return common;
}

/// Closes all finalists at nodes [first, last) and puts them in order. Node by node, so that an
/// early stop leaves as many nodes as possible that all have closed; only those are compared.
void close_nodes(const RankRequest& request, const std::vector<Perturbation>& nodes, int first,
                 int last, std::vector<Finalist>& finalists, Watch& watch) {
  const int count = static_cast<int>(finalists.size());
  for_each_index(count * (last - first), request.options.threads, [&](int index) {
    if (watch.stopped()) return;
    Finalist& finalist = finalists[static_cast<std::size_t>(index % count)];
    const auto n = static_cast<std::size_t>(first + index / count);
    const RepairPlan& plan = finalist.trial.plan;
    const Expected<Valve> repaired = apply_plan(request.valve, plan, request.catalogue);
    finalist.region[n] = request.evaluate(perturb(*repaired, plan, nodes[n]));
    watch.closed(*finalist.region[n], false);
  });
  const std::size_t common = common_nodes(finalists);
  for (Finalist& finalist : finalists)
    finalist.plan = ranked(request, finalist.trial, finalist.region, common);
  std::stable_sort(finalists.begin(), finalists.end(),
                   [](const Finalist& a, const Finalist& b) { return is_better(a.plan, b.plan); });
}

}  // namespace

bool closes_robustly(const RankedPlan& plan) {
  return !failed(plan) && plan.region_failures == 0 && plan.region_closures > 1 &&
         plan.leak_mm2.mean + plan.leak_mm2.sd < kCompetentLeak_mm2;
}

bool closes_robustly(const SearchResult& result) {
  return !result.plans.empty() && closes_robustly(result.plans.front());
}

int ranking_closures(const SearchOptions& options) {
  const int first = first_nodes(options);
  return finalist_count(options) * (first - 1) + options.plans * (options.region_points - first);
}

std::vector<Trial> finalists(const std::vector<StrategySearch>& searches,
                             const SearchOptions& options) {
  std::vector<const StrategySearch*> order;
  for (const StrategySearch& search : searches)
    if (search.best) order.push_back(&search);
  std::stable_sort(order.begin(), order.end(),
                   [](const auto* a, const auto* b) { return a->best->cost < b->best->cost; });
  std::set<std::string> kinds;
  std::stable_partition(order.begin(), order.end(), [&kinds](const StrategySearch* search) {
    return kinds.insert(kind(search->strategy.choice)).second;
  });
  std::vector<Trial> best;
  for (const StrategySearch* search : order)
    if (std::ssize(best) < finalist_count(options)) best.push_back(*search->best);
  return best;
}

std::vector<RankedPlan> rank_plans(const RankRequest& request, const std::vector<Trial>& trials,
                                   Watch& watch) {
  const SearchOptions& options = request.options;
  const std::vector<Perturbation> nodes = region_of_interest();
  std::vector<Finalist> finalists;
  const double most =
      std::max(std::floor(watch.affordable() / std::max(1, first_nodes(options) - 1)),
               static_cast<double>(options.plans));
  for (const Trial& trial : trials) {
    if (static_cast<double>(finalists.size()) >= most) break;
    finalists.push_back({trial, {}, {}});
    finalists.back().region.resize(static_cast<std::size_t>(options.region_points));
    finalists.back().region[0] = trial.evaluation;  // the undisturbed node
  }
  close_nodes(request, nodes, 1, first_nodes(options), finalists, watch);
  if (std::ssize(finalists) > options.plans)
    finalists.erase(finalists.begin() + options.plans, finalists.end());
  close_nodes(request, nodes, first_nodes(options), options.region_points, finalists, watch);
  std::vector<RankedPlan> plans;
  for (const Finalist& finalist : finalists) {
    plans.push_back(finalist.plan);
    plans.back().rank = static_cast<int>(plans.size());
  }
  return plans;
}

}  // namespace coapt
