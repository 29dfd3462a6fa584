#include "search/plans/ranking.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <set>
#include <string>

#include "core/metrics/area_error.h"
#include "core/repair/approximation.h"
#include "core/repair/describe.h"
#include "core/valve/number_text.h"
#include "search/plans/acceptance.h"
#include "search/plans/closure_gates.h"
#include "search/plans/durability.h"
#include "search/plans/pareto.h"
#include "search/plans/plan_estimates.h"
#include "search/plans/plan_key.h"
#include "search/plans/plan_order.h"
#include "search/plans/simpler_plans.h"
#include "search/plans/strength_gates.h"

namespace coapt {
namespace {

constexpr int kSimpler = 8;             // versions of finalists at most
constexpr double kOftenFailing = 0.05;  // of the region's closures: then its figures mean little

std::vector<double> costs_of(const PlanEvaluations& evaluations,
                             const std::vector<PlanRecord*>& plans, int nodes) {
  std::vector<double> costs;
  for (const PlanRecord* plan : plans) costs.push_back(evaluations.cost(*plan, nodes));
  return costs;
}

/// Node by node, so that an early stop leaves as many nodes as possible that all have.
bool close_up_to(PlanEvaluations& evaluations, const std::vector<PlanRecord*>& plans, int nodes) {
  std::vector<PlanEvaluations::Wanted> wanted;
  for (int d = 0; d < nodes; ++d)
    for (PlanRecord* plan : plans)
      if (!plan->closures.contains(d)) wanted.push_back({plan, d});
  return evaluations.close(wanted, PlanEvaluations::Phase::Ranking);
}

/// Nodes that it has closed, counted from the first; those that all plans have.
int nodes_of(const PlanRecord& plan) {
  int nodes = 0;
  while (nodes < kRegion.count && plan.closures.contains(nodes)) ++nodes;
  return nodes;
}

int common_nodes(const std::vector<PlanRecord*>& plans) {
  int common = kRegion.count;
  for (const PlanRecord* plan : plans) common = std::min(common, nodes_of(*plan));
  return common;
}

/// Else it is no ground to prefer one to another.
bool all_durabilities_known(const std::vector<PlanRecord*>& plans) {
  return std::all_of(plans.begin(), plans.end(),
                     [](const PlanRecord* plan) { return durability(*plan).has_value(); });
}

/// Every rule of practice, and what it says of the plan.
std::vector<Gate> gates_of(const PlanEvaluations& evaluations, const PlanRecord& record,
                           const Valve& repaired, const Evaluation& closed) {
  std::vector<Gate> gates =
      operation_gates({record.plan, evaluations.valve(), repaired, evaluations.untethered()});
  for (const std::vector<Gate>& more :
       {opening_gates(record.opening),
        closure_gates(closed, evaluations.before(), evaluations.tethered()),
        strength_gates(record)})
    gates.insert(gates.end(), more.begin(), more.end());
  return gates;
}

/// The same. @pre closed as planned
std::vector<Gate> known_gates(PlanEvaluations& evaluations, const PlanRecord& record) {
  return gates_of(evaluations, record, evaluations.repaired(record),
                  evaluations.closed(record).evaluation);
}

/// By what is known of it so far. @pre closed as planned
PlanMerits merits_of(const PlanEvaluations& evaluations, const PlanRecord& record, int nodes,
                     const std::vector<Gate>& gates, bool durable, const Acceptance& acceptance) {
  PlanMerits merits;
  int failures = 0;
  for (int node = 0; node < nodes; ++node) failures += !trusted(record.closures.at(node));
  merits.trusted = trusted(record.closures.at(0));
  merits.varied = nodes > 1;
  merits.fails_often = failures > kOftenFailing * nodes;
  merits.rejected = !record.rejected_by.empty();
  merits.stenotic = is_stenotic(record.opening);
  merits.acceptable_probability = acceptance.mean();
  merits.avoidable_warnings = avoidable_warnings(gates);
  if (durable) merits.durability_mm = durability(record)->expected_mm;
  if (record.opening && trusted(*record.opening))
    merits.gradient_mmhg = record.opening->measure.gradient_mmhg;
  merits.steps = record.effort.steps;
  merits.muscles = record.muscles;
  merits.free_anchors = record.free_anchors;
  merits.resections = record.resections;
  merits.sizes_below = record.effort.sizes_below;
  const LeakStatistics leak = leak_statistics(record, nodes);
  merits.leak_mm2 = nodes > 1 ? leak.mean + leak.sd : leak.nominal;
  merits.cost = evaluations.cost(record, nodes);
  if (durable)
    merits.cost += price(durability_terms(*durability(record)), evaluations.context().weights);
  return merits;
}

/// By the rule that ranks, over these nodes. @pre nodes > 0
std::vector<PlanPlace> order_over(PlanEvaluations& evaluations,
                                  const std::vector<PlanRecord*>& plans, int nodes,
                                  const SearchOptions& options) {
  const bool durable = all_durabilities_known(plans);
  std::vector<PlanMerits> merits;
  for (const PlanRecord* plan : plans)
    merits.push_back(merits_of(evaluations, *plan, nodes, known_gates(evaluations, *plan), durable,
                               acceptance_of(evaluations, *plan, nodes, {}, {})));
  return order_of(merits, options.rank_by_price);
}

/// The first compared_plans() by the rule that ranks, as far as there are so many each another operation. @return the others
std::vector<PlanRecord*> keep_best(PlanEvaluations& evaluations, std::vector<PlanRecord*>& plans,
                                   int nodes, const SearchOptions& options) {
  const int kept = compared_plans(options);
  if (std::ssize(plans) <= kept) return {};
  if (nodes > 0) {
    std::vector<PlanRecord*> order;
    for (const PlanPlace& place : order_over(evaluations, plans, nodes, options))
      order.push_back(plans[place.index]);
    plans = order;
  }  // else nothing is known of some: in the order found
  std::set<std::string> seen;
  std::stable_partition(plans.begin(), plans.end(), [&](const PlanRecord* plan) {
    return seen.insert(operation_key(plan->plan)).second;
  });
  std::vector<PlanRecord*> others(plans.begin() + kept, plans.end());
  plans.resize(kept);
  return others;
}

/// Where some are to be dropped: not of plans of one's own.
bool takes_simpler(const SearchOptions& options, const std::vector<PlanRecord*>& finalists) {
  return options.evidence && !options.rank_by_price &&
         std::ssize(finalists) > compared_plans(options);
}

int disease_closures_left(const PlanRecord& plan) {
  int left = kDisease.count;
  for (const auto& [disturbance, closure] : plan.closures)
    left -= kDisease.first <= disturbance && disturbance < kDisease.first + kDisease.count;
  return durability(plan) ? 0 : left;
}

/// Opens plans, closes them at as many nodes and under disease. False if it was stopped.
bool close_for_order(PlanEvaluations& evaluations, const std::vector<PlanRecord*>& plans,
                     int nodes) {
  return evaluations.open(plans, PlanEvaluations::Phase::Ranking) &&
         close_up_to(evaluations, plans, nodes) &&
         close_disease(evaluations, plans, PlanEvaluations::Phase::Ranking);
}

/// Adds simpler versions of plans of the first class, and safer ones of those that are warned of, closed as far as these are. False if it was stopped.
bool add_simpler(PlanEvaluations& evaluations, std::vector<PlanRecord*>& plans, int nodes,
                 const SearchOptions& options) {
  std::vector<PlanRecord*> added;
  for (const auto& [index, of_class] : order_over(evaluations, plans, nodes, options)) {
    if (of_class > 1) break;
    const RepairPlan& plan = plans[index]->plan;
    std::vector<RepairPlan> versions;
    if (avoidable_warnings(known_gates(evaluations, *plans[index])) > 0)
      versions = safer_plans(evaluations.valve(), plan, options.rules);
    for (RepairPlan& simpler : simpler_plans(evaluations.valve(), plan, options.rules))
      versions.push_back(std::move(simpler));
    for (const RepairPlan& version : versions) {
      PlanRecord* const record = &evaluations.record(version);
      const auto has = [record](const std::vector<PlanRecord*>& some) {
        return std::find(some.begin(), some.end(), record) != some.end();
      };
      if (std::ssize(added) < kSimpler && !is_infeasible(*record) && !has(plans) && !has(added))
        added.push_back(record);
    }
  }
  if (added.empty()) return true;
  if (!close_for_order(evaluations, added, nodes)) return false;
  plans.insert(plans.end(), added.begin(), added.end());
  return true;
}

std::vector<DisturbanceSet> evidence_of(const RepairPlan& plan) {
  std::vector<DisturbanceSet> sets = {kRemodelling, kIndependent};
  const bool al = suture_of(plan, Side::Anterolateral) != nullptr;
  const bool pm = suture_of(plan, Side::Posteromedial) != nullptr;
  if (al) sets.push_back(kAnterolateralAlone);
  if (pm) sets.push_back(kPosteromedialAlone);
  return sets;
}

/// What the fine mesh says against a plan whose own mesh does not.
void warn_of_fine(const FineMesh& mesh, RankedPlan& plan) {
  if (!plan.fine || closes_finely(plan) || !trusted(plan) ||
      plan.measure.leak.area_mm2 >= kMildLeak_mm2)
    return;
  const std::string there = "on " + std::to_string(mesh.triangles) + " triangles ";
  plan.warnings.push_back(!trusted(*plan.fine)
                              ? there + "its closure did not converge or its leaflets cross"
                              : there + "it leaks " + with_decimals(plan.fine->leak_mm2, 1) +
                                    " mm², so the plan is not acceptable");
}

/// @param durable the durability of all is known, and counts
RankedPlan ranked(PlanEvaluations& evaluations, const PlanRecord& record, int nodes,
                  const FineClosures& fine, bool durable) {
  RankedPlan plan;
  plan.plan = record.plan;
  plan.description = describe(evaluations.valve(), record.plan);
  const Valve repaired = evaluations.repaired(record);
  const ClosedPlan closed = with_leak_surface(repaired, evaluations.closed(record));
  const Evaluation& evaluation = closed.evaluation;
  plan.status = evaluation.status;
  plan.crossing = evaluation.crossing;
  plan.measure = evaluation.measure;
  plan.effort = record.effort;
  plan.terms = evaluations.terms(record, nodes);
  plan.cost = price(plan.terms, evaluations.context().weights);
  plan.subset_nodes = std::min(nodes, kChosenBy);
  plan.subset_cost = evaluations.cost(record, plan.subset_nodes);
  // More than are compared: the whole map of the first plan.
  const int own = nodes_of(record);
  plan.region = region_report(record, own > kBeforeTheRegion ? own : nodes);
  plan.region.leak_mm2.nominal = plan.region.independent_leak_mm2.nominal =
      plan.measure.leak.area_mm2;
  if (const auto drawn = closed_valve(repaired, closed))
    plan.closed =
        std::make_shared<const ClosedValve>(with_repair(*drawn, evaluations.valve(), record.plan));
  plan.opening = record.opening;
  plan.durability = durability(record);
  if (durable) {
    const CostTerms lost = durability_terms(*plan.durability);
    plan.durability_price = price(lost, evaluations.context().weights);
    plan.terms.amounts += lost.amounts;
  }
  plan.gates = gates_of(evaluations, record, repaired, evaluation);
  plan.warnings = warnings_of(plan.gates);
  if (record.opening && record.opening->two_orifices) plan.warnings.push_back(kUnknownOpening);
  if (!record.plan.steps.empty() && plan.region.leak_mm2.worst > kMildLeak_mm2)
    plan.warnings.push_back("the plan leaks more than " + shown(kMildLeak_mm2) +
                            " mm² with some error of execution");
  if (nodes > 1 && plan.region.failures > 0)
    plan.warnings.push_back(
        std::to_string(plan.region.failures) + " of " + std::to_string(nodes) +
        " closures in the region of interest failed and are excluded from its statistics");
  plan.fine_levels = fine.mesh.levels;
  if (const auto closure = fine.plans.find(&record); closure != fine.plans.end())
    plan.fine = closure->second;
  if (plan.fine && trusted(*plan.fine))
    plan.fine_leak_error_mm2 =
        area_error_mm2(plan.fine->leak_mm2, {.triangles = fine.mesh.triangles});
  warn_of_fine(fine.mesh, plan);
  return plan;
}

}  // namespace

int ranking_closures(const SearchOptions& options) {
  const int before = std::min(kBeforeTheRegion, options.region_points);
  const int compared = compared_plans(options);
  const int finalists = wanted_finalists(options, true) + kFrontFinalists + kSimpler + kReserve;
  int most = finalists * before + compared * (options.region_points - before);
  if (options.evidence)
    most += finalists * kDisease.count +
            options.plans * (kRemodelling.count + kAnterolateralAlone.count +
                             kPosteromedialAlone.count + kIndependent.count);
  return most;
}

int ranking_closures(const SearchOptions& options, const std::vector<PlanRecord*>& finalists) {
  const int before = std::min(kBeforeTheRegion, options.region_points);
  const int staying = std::min(compared_plans(options), static_cast<int>(finalists.size()));
  int most = staying * (options.region_points - before);
  std::vector<int> evidence;
  for (PlanRecord* plan : finalists) {
    most += std::max(0, before - common_nodes({plan}));
    if (options.evidence) most += disease_closures_left(*plan);
    evidence.push_back(evidence_closures(plan->plan) - kDisease.count);
  }
  if (!options.evidence) return most;
  if (takes_simpler(options, finalists)) most += kSimpler * (before + kDisease.count);
  std::sort(evidence.begin(), evidence.end(), std::greater<>());
  return std::accumulate(evidence.begin(), evidence.begin() + std::min(options.plans, staying),
                         most);
}

int evidence_closures(const RepairPlan& plan) {
  int closures = kDisease.count;  // at most: a course ends at its leak
  for (const DisturbanceSet set : evidence_of(plan)) closures += set.count;
  return closures;
}

void close_evidence(PlanEvaluations& evaluations, const std::vector<PlanRecord*>& plans) {
  std::vector<PlanEvaluations::Wanted> wanted;
  for (PlanRecord* plan : plans)
    for (const DisturbanceSet set : evidence_of(plan->plan))
      for (int d = set.first; d < set.first + set.count; ++d) wanted.push_back({plan, d});
  evaluations.close(wanted, PlanEvaluations::Phase::Ranking);
}

Finalists close_finalists(PlanEvaluations& evaluations, std::vector<PlanRecord*> finalists,
                          const SearchOptions& options, std::vector<LadderStep>& ladder) {
  int closed = 0;
  std::vector<PlanRecord*> others;
  for (const int goal : {1, kChosenBy, kBeforeTheRegion, options.region_points}) {
    const int nodes = std::min(goal, options.region_points);
    if (nodes <= closed) continue;
    if (!close_up_to(evaluations, finalists, nodes)) {
      int most = 0;  // what was chosen by more nodes stays, over those that it has
      for (PlanRecord* plan : finalists) most = std::max(most, common_nodes({plan}));
      std::erase_if(finalists, [&](PlanRecord* plan) {
        return common_nodes({plan}) < std::min(most, kChosenBy);
      });
      keep_best(evaluations, finalists, common_nodes(finalists), options);
      return {finalists, {}};
    }
    if (closed > 1)
      ladder.push_back(measure_ladder_step(closed, nodes, costs_of(evaluations, finalists, closed),
                                           costs_of(evaluations, finalists, nodes)));
    closed = nodes;
    const bool last_before = nodes == std::min(kBeforeTheRegion, options.region_points);
    if (last_before && options.evidence) {
      close_disease(evaluations, finalists, PlanEvaluations::Phase::Ranking);
      if (takes_simpler(options, finalists)) add_simpler(evaluations, finalists, nodes, options);
    }
    if (nodes < std::min(kBeforeTheRegion, options.region_points)) continue;
    const std::vector<PlanRecord*> dropped = keep_best(evaluations, finalists, nodes, options);
    if (nodes == options.region_points) others = dropped;
  }
  keep_best(evaluations, finalists, closed, options);
  return {finalists, others};
}

bool close_reserve(PlanEvaluations& evaluations, const std::vector<PlanRecord*>& reserve,
                   const SearchOptions& options) {
  for (const PlanRecord* plan : reserve)
    evaluations.expect_more(options.region_points - nodes_of(*plan) + disease_closures_left(*plan));
  return close_for_order(evaluations, reserve, options.region_points);
}

void close_map(PlanEvaluations& evaluations, PlanRecord& plan, int nodes) {
  close_up_to(evaluations, {&plan}, nodes);
}

int anchor_closures(const SearchOptions& options) {
  constexpr int kBothSides = 2;
  return options.evidence ? kBothSides * std::min(kChosenBy, options.region_points) : 0;
}

std::vector<OtherAnchor> compare_anchors(PlanEvaluations& evaluations, const PlanRecord& plan,
                                         const SearchOptions& options) {
  std::vector<OtherAnchor> compared;
  const int nodes = std::min({kChosenBy, options.region_points, nodes_of(plan)});
  for (const Side side : {Side::Anterolateral, Side::Posteromedial}) {
    const PapillaryApproximation* const suture = suture_of(plan.plan, side);
    if (suture == nullptr) continue;
    const bool at_trigone = suture->anchor == Anchor::IpsilateralTrigone;
    const Anchor anchor = at_trigone ? Anchor::SaddlePeak : Anchor::IpsilateralTrigone;
    PlanRecord& other = evaluations.record(
        with_anchor(evaluations.valve(), plan.plan, side, anchor, options.rules.suture_lattice_mm));
    if (!other.possible || !close_up_to(evaluations, {&other}, nodes)) continue;
    compared.push_back({side, suture->anchor, anchor,
                        leak_statistics(other, nodes).mean - leak_statistics(plan, nodes).mean});
  }
  return compared;
}

std::vector<RankedPlan> rank(PlanEvaluations& evaluations, const std::vector<PlanRecord*>& plans,
                             const SearchOptions& options, const FineClosures& fine,
                             const ModelClosures& model) {
  const int nodes = std::min(options.region_points, common_nodes(plans));
  if (nodes == 0) return {};
  const bool durable = all_durabilities_known(plans);
  const bool finely =
      fine.mesh.levels > 0 && std::all_of(plans.begin(), plans.end(), [&](const PlanRecord* plan) {
        return fine.plans.contains(plan);
      });
  std::vector<RankedPlan> all;
  std::vector<PlanMerits> merits, own_merits;
  std::vector<Acceptance> acceptances;
  for (const PlanRecord* record : plans) {
    RankedPlan& plan = all.emplace_back(ranked(evaluations, *record, nodes, fine, durable));
    own_merits.push_back(merits_of(evaluations, *record, nodes, plan.gates, durable,
                                   acceptance_of(evaluations, *record, nodes, {}, model)));
    if (finely) {
      const CostTerms change = fine_change(evaluations, *record, fine);
      plan.fine_cost_change = price(change, evaluations.context().weights);
      plan.terms.amounts += change.amounts;
    }
    acceptances.push_back(acceptance_of(evaluations, *record, nodes, fine, model));
    merits.push_back(own_merits.back());
    merits.back().acceptable_probability = acceptances.back().mean();
    merits.back().cost += plan.fine_cost_change;
    merits.back().closes_finely = closes_finely(plan);
    plan.acceptable_probability = merits.back().acceptable_probability;
    plan.is_acceptable = is_acceptable(merits.back());
    plan.tier = tier_of(merits.back());
    if (const auto drawn = model.plans.find(record); drawn != model.plans.end()) {
      const auto measured = model.measured.find(record);
      plan.model =
          model_spread(measured == model.measured.end() ? drawn->second : measured->second);
    }
    plan.estimates = plan_estimates(evaluations, *record, plan.measure, nodes, fine, model);
  }
  if (finely) {
    int place = 0;
    for (const PlanPlace& own : order_of(own_merits, options.rank_by_price))
      all[own.index].own_mesh_rank = ++place;
  }
  const std::vector<PlanPlace> order = order_of(merits, options.rank_by_price);
  const std::vector<int> first = times_first(merits);
  const std::size_t reported = std::min(order.size(), static_cast<std::size_t>(options.plans));
  std::vector<RankedPlan> result;
  for (std::size_t i = 0; i < reported; ++i) {
    const auto [index, of_class] = order[i];
    RankedPlan& plan = all[index];
    plan.rank = static_cast<int>(i) + 1;
    plan.of_class = of_class;
    if (!options.rank_by_price) plan.times_first = first[index];
    plan.simplest_of_class = i == 0 || order[i - 1].of_class != of_class;
    const bool last = i + 1 == reported;
    plan.ties_with_next = !last && order[i + 1].of_class == of_class;
    plan.probability_outranks_next =
        last || nodes < 2 ? std::numeric_limits<double>::quiet_NaN()
                          : probability_ahead(acceptances[index], acceptances[order[i + 1].index]);
    result.push_back(std::move(plan));
  }
  mark_pareto(result);
  return result;
}

}  // namespace coapt
