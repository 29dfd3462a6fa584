#include "search/plans/ranking.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>

#include "core/metrics/area_error.h"
#include "core/repair/apply_plan.h"
#include "core/repair/approximation.h"
#include "core/repair/describe.h"
#include "core/valve/number_text.h"
#include "search/plans/closure_gates.h"
#include "search/plans/durability.h"
#include "search/plans/outranking.h"
#include "search/plans/pareto.h"
#include "search/plans/strength_gates.h"

namespace coapt {
namespace {

constexpr int kBeforeTheRegion = 65;  // nodes by which reported plans are taken from the finalists
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

/// Nodes that all plans have closed, counted from the first.
int common_nodes(const std::vector<PlanRecord*>& plans) {
  int common = kRegion.count;
  for (const PlanRecord* plan : plans) {
    int nodes = 0;
    while (nodes < common && plan->closures.contains(nodes)) ++nodes;
    common = nodes;
  }
  return common;
}

/// Else it is no ground to prefer one to another.
bool all_durabilities_known(const std::vector<PlanRecord*>& plans) {
  return std::all_of(plans.begin(), plans.end(),
                     [](const PlanRecord* plan) { return durability(*plan).has_value(); });
}

void keep_cheapest(const PlanEvaluations& evaluations, std::vector<PlanRecord*>& plans, int nodes,
                   int count) {
  if (nodes == 0) {  // nothing is known of some: in the order found
    if (std::ssize(plans) > count) plans.resize(count);
    return;
  }
  const bool durable = all_durabilities_known(plans);
  const auto cost = [&](const PlanRecord& plan) {
    return evaluations.cost(plan, nodes) +
           (durable ? price(durability_terms(*durability(plan)), evaluations.context().weights)
                    : 0.0);
  };
  std::stable_sort(plans.begin(), plans.end(),
                   [&](const PlanRecord* a, const PlanRecord* b) { return cost(*a) < cost(*b); });
  if (std::ssize(plans) > count) plans.resize(count);
}

std::vector<DisturbanceSet> evidence_of(const RepairPlan& plan) {
  std::vector<DisturbanceSet> sets = {kRemodelling, kIndependent};
  const bool al = suture_of(plan, Side::Anterolateral) != nullptr;
  const bool pm = suture_of(plan, Side::Posteromedial) != nullptr;
  if (al) sets.push_back(kAnterolateralAlone);
  if (pm) sets.push_back(kPosteromedialAlone);
  return sets;
}

void close_evidence(PlanEvaluations& evaluations, const std::vector<PlanRecord*>& plans) {
  std::vector<PlanEvaluations::Wanted> wanted;
  for (PlanRecord* plan : plans)
    for (const DisturbanceSet set : evidence_of(plan->plan))
      for (int d = set.first; d < set.first + set.count; ++d) wanted.push_back({plan, d});
  evaluations.close(wanted, PlanEvaluations::Phase::Ranking);
}

int disease_closures_left(const PlanRecord& plan) {
  int left = kDisease.count;
  for (const auto& [disturbance, closure] : plan.closures)
    left -= kDisease.first <= disturbance && disturbance < kDisease.first + kDisease.count;
  return durability(plan) ? 0 : left;
}

bool fails_often(const RankedPlan& plan) {
  return plan.region.failures > kOftenFailing * plan.region.closures;
}

/// What decides between two plans.
struct Standing {
  bool trusted = true, fails_often = false, stenotic = false, robust = false;
  double cost = 0.0;
};

/// `leak_mm2` and `cost`: more than on its own material.
Standing standing(const RankedPlan& plan, double leak_mm2, double cost) {
  return {trusted(plan), fails_often(plan), is_stenotic(plan.opening),
          closes_robustly(plan, leak_mm2),
          plan.cost + plan.fine_cost_change + plan.durability_price + cost};
}

bool is_better(const Standing& a, const Standing& b) {
  if (a.trusted != b.trusted) return a.trusted;
  if (a.fails_often != b.fails_often) return b.fails_often;
  if (a.stenotic != b.stenotic) return b.stenotic;
  if (a.robust != b.robust) return a.robust;
  return a.cost < b.cost;
}

using Ranked = std::pair<RankedPlan, const PlanRecord*>;

/// By their own mesh, then by the finer one if all are closed there; keeps both places.
void sort_plans(const PlanEvaluations& evaluations, const FineClosures& fine,
                std::vector<Ranked>& order) {
  const auto sort = [&] {
    std::stable_sort(order.begin(), order.end(), [](const Ranked& a, const Ranked& b) {
      return is_better(standing(a.first, 0.0, 0.0), standing(b.first, 0.0, 0.0));
    });
  };
  sort();
  if (fine.plans.size() == order.size()) {
    int place = 0;
    for (auto& [plan, record] : order) {
      plan.own_mesh_rank = ++place;
      const CostTerms change = fine_change(evaluations, *record, fine);
      plan.fine_cost_change = price(change, evaluations.context().weights);
      plan.terms.amounts += change.amounts;
    }
    sort();
  }
  int place = 0;
  for (auto& [plan, record] : order) plan.rank = ++place;
}

/// The share of draws in which the plan is ahead of the next; equals count half. NaN where no draw
/// has both closed and trusted.
double share_ahead(const PlanEvaluations& evaluations, const ModelClosures& model, const Ranked& a,
                   const Ranked& b) {
  double ahead = 0.0;
  int compared = 0;
  for (int draw = 0; draw < std::ssize(model.before); ++draw) {
    const DrawnChange of_a = change_in_draw(evaluations, *a.second, model, draw);
    const DrawnChange of_b = change_in_draw(evaluations, *b.second, model, draw);
    if (!of_a.trusted || !of_b.trusted) continue;
    ++compared;
    const Standing there_a = standing(a.first, of_a.leak_mm2, of_a.cost);
    const Standing there_b = standing(b.first, of_b.leak_mm2, of_b.cost);
    ahead += is_better(there_a, there_b) ? 1.0 : is_better(there_b, there_a) ? 0.0 : 0.5;
  }
  return compared > 0 ? ahead / compared : std::numeric_limits<double>::quiet_NaN();
}

JudgedRecord judged(const PlanEvaluations& evaluations, const Ranked& ranked) {
  const RankedPlan& plan = ranked.first;
  const double opening =
      plan.opening ? price(opening_terms(*plan.opening), evaluations.context().weights) : 0.0;
  return {ranked.second, closes_finely(plan),
          plan.fine_cost_change + plan.durability_price + opening};
}

/// What the fine mesh says against a plan whose own mesh does not.
void warn_of_fine(const FineMesh& mesh, RankedPlan& plan) {
  if (!plan.fine || closes_finely(plan) || !trusted(plan) ||
      plan.measure.leak.area_mm2 >= kCompetentLeak_mm2)
    return;
  const std::string there = "on " + std::to_string(mesh.triangles) + " triangles ";
  plan.warnings.push_back(!trusted(*plan.fine)
                              ? there + "its closure did not converge uncrossed"
                              : there + "it leaks " + with_decimals(plan.fine->leak_mm2, 1) +
                                    " mm2: not called competent");
}

/// @param durable the durability of all is known, and counts
RankedPlan ranked(PlanEvaluations& evaluations, const PlanRecord& record, int nodes,
                  const FineClosures& fine, bool durable) {
  RankedPlan plan;
  plan.plan = record.plan;
  plan.description = describe(evaluations.valve(), record.plan);
  const Expected<Valve> repaired = apply_plan(evaluations.valve(), record.plan);
  const ClosedPlan closed = with_leak_surface(*repaired, evaluations.closed(record));
  const Evaluation& evaluation = closed.evaluation;
  plan.status = evaluation.status;
  plan.crossing = evaluation.crossing;
  plan.measure = evaluation.measure;
  plan.effort = record.effort;
  plan.terms = evaluations.terms(record, nodes);
  plan.cost = price(plan.terms, evaluations.context().weights);
  plan.subset_nodes = std::min(nodes, kChosenBy);
  plan.subset_cost = evaluations.cost(record, plan.subset_nodes);
  plan.region = region_report(record, nodes);
  plan.region.leak_mm2.nominal = plan.region.independent_leak_mm2.nominal =
      plan.measure.leak.area_mm2;
  if (const auto drawn = closed_valve(*repaired, closed))
    plan.closed =
        std::make_shared<const ClosedValve>(with_repair(*drawn, evaluations.valve(), record.plan));
  plan.opening = record.opening;
  plan.durability = durability(record);
  if (durable) {
    const CostTerms lost = durability_terms(*plan.durability);
    plan.durability_price = price(lost, evaluations.context().weights);
    plan.terms.amounts += lost.amounts;
  }
  plan.gates = operation_gates({record.plan, evaluations.valve(), *repaired});
  for (const std::vector<Gate>& gates :
       {opening_gates(record.opening), closure_gates(evaluation, evaluations.before()),
        strength_gates(record)})
    plan.gates.insert(plan.gates.end(), gates.begin(), gates.end());
  plan.warnings = warnings_of(plan.gates);
  if (record.opening && record.opening->behind_clip) plan.warnings.push_back(kUnknownBehindClip);
  if (plan.region.leak_mm2.worst > kGoodRepair_mm2)
    plan.warnings.push_back("leaks more than " + shown(kGoodRepair_mm2) +
                            " mm2 somewhere in the region of interest");
  if (nodes > 1 && plan.region.failures > 0)
    plan.warnings.push_back(std::to_string(plan.region.failures) + " of " + std::to_string(nodes) +
                            " closures in the region of interest failed and are left out of its "
                            "figures");
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
  const int finalists = (kFinalists + 1) * options.plans;
  int most = finalists * before + options.plans * (options.region_points - before);
  if (options.evidence)
    most += finalists * kDisease.count +
            options.plans * (kRemodelling.count + kAnterolateralAlone.count +
                             kPosteromedialAlone.count + kIndependent.count);
  return most;
}

int ranking_closures(const SearchOptions& options, const std::vector<PlanRecord*>& finalists) {
  const int before = std::min(kBeforeTheRegion, options.region_points);
  const int staying = std::min(options.plans, static_cast<int>(finalists.size()));
  int most = staying * (options.region_points - before);
  std::vector<int> evidence;
  for (PlanRecord* plan : finalists) {
    most += std::max(0, before - common_nodes({plan}));
    if (options.evidence) most += disease_closures_left(*plan);
    evidence.push_back(evidence_closures(plan->plan) - kDisease.count);
  }
  if (!options.evidence) return most;
  std::sort(evidence.begin(), evidence.end(), std::greater<>());
  return std::accumulate(evidence.begin(), evidence.begin() + staying, most);
}

int evidence_closures(const RepairPlan& plan) {
  int closures = kDisease.count;  // at most: a course ends at its leak
  for (const DisturbanceSet set : evidence_of(plan)) closures += set.count;
  return closures;
}

std::vector<PlanRecord*> close_finalists(PlanEvaluations& evaluations,
                                         std::vector<PlanRecord*> finalists,
                                         const SearchOptions& options,
                                         std::vector<LadderStep>& ladder) {
  int closed = 0;
  for (const int goal : {1, kChosenBy, kBeforeTheRegion, options.region_points}) {
    const int nodes = std::min(goal, options.region_points);
    if (nodes <= closed) continue;
    if (!close_up_to(evaluations, finalists, nodes)) {
      int most = 0;  // what was chosen by more nodes stays, over those that it has
      for (PlanRecord* plan : finalists) most = std::max(most, common_nodes({plan}));
      std::erase_if(finalists, [&](PlanRecord* plan) {
        return common_nodes({plan}) < std::min(most, kChosenBy);
      });
      keep_cheapest(evaluations, finalists, common_nodes(finalists), options.plans);
      return finalists;
    }
    if (closed > 1)
      ladder.push_back(measure_ladder_step(closed, nodes, costs_of(evaluations, finalists, closed),
                                           costs_of(evaluations, finalists, nodes)));
    closed = nodes;
    const bool last_before = nodes == std::min(kBeforeTheRegion, options.region_points);
    if (last_before && options.evidence)
      close_disease(evaluations, finalists, PlanEvaluations::Phase::Ranking);
    if (nodes >= std::min(kBeforeTheRegion, options.region_points))
      keep_cheapest(evaluations, finalists, nodes, options.plans);
  }
  keep_cheapest(evaluations, finalists, closed, options.plans);
  if (options.evidence) close_evidence(evaluations, finalists);
  return finalists;
}

std::vector<RankedPlan> rank(PlanEvaluations& evaluations, const std::vector<PlanRecord*>& plans,
                             int most_nodes, const FineClosures& fine, const ModelClosures& model) {
  const int nodes = std::min(most_nodes, common_nodes(plans));
  if (nodes == 0) return {};
  const bool durable = all_durabilities_known(plans);
  std::vector<Ranked> order;
  for (const PlanRecord* plan : plans)
    order.emplace_back(ranked(evaluations, *plan, nodes, fine, durable), plan);
  sort_plans(evaluations, fine, order);
  std::vector<const PlanRecord*> records;
  for (const auto& [plan, record] : order) records.push_back(record);
  std::vector<RankedPlan> result;
  for (std::size_t i = 0; i < order.size(); ++i) {
    RankedPlan& plan = order[i].first;
    if (const auto drawn = model.plans.find(records[i]); drawn != model.plans.end())
      plan.model = model_spread(drawn->second);
    if (i + 1 < order.size())
      plan.share_of_draws_ahead = share_ahead(evaluations, model, order[i], order[i + 1]);
    plan.probability_outranks_next =
        i + 1 < order.size() ? probability_ahead(evaluations, judged(evaluations, order[i]),
                                                 judged(evaluations, order[i + 1]), nodes)
                             : std::numeric_limits<double>::quiet_NaN();
  }
  for (auto& [plan, record] : order) result.push_back(std::move(plan));
  mark_pareto(evaluations.context().weights, result);
  return result;
}

}  // namespace coapt
