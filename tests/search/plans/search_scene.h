// Stand-ins for closures, on the small valve: its tips are 28.60 mm from their trigones (displaced; up to 27.3
// is normal), its annulus is 36 mm wide, no chorda is ruptured.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <bit>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "search/plans/plan_evaluations.h"
#include "search/plans/plan_key.h"
#include "search/plans/plan_search.h"
#include "tests/scenes/small_preset.h"
#include "tests/scenes/small_valve.h"

namespace coapt::scene {

/// From (12, -2, -26) to (9 sqrt 2, 7 sqrt 2, 0).
inline constexpr double kTipToTrigone_mm = 28.60293429482119;

/// A closure without any slope but its leak.
inline Evaluation leaking(double leak_mm2) {
  Evaluation evaluation;
  evaluation.measure.leak.area_mm2 = leak_mm2;
  for (CoaptationSection& section : evaluation.measure.coaptation.sections) {
    section.height_mm = 8.0;
    section.contact = true;
  }
  return evaluation;
}

/// Of ranking: so many nodes of the region.
inline SearchOptions over_nodes(int region_points) {
  SearchOptions options;
  options.region_points = region_points;
  return options;
}

inline PlanClosure closure_leaking(double leak_mm2) { return plan_closure(leaking(leak_mm2)); }

/// How far a muscle is from where it is in the small valve.
inline double moved_mm(const Valve& valve, Side side) {
  static const Valve before = fitting_valve();
  return (papillary_tip_mm(valve, side) - papillary_tip_mm(before, side)).norm();
}

/// How much stiffer than the small valve's chordae those of this draw are.
inline double stiffness(const Valve& valve) {
  static const Valve own = small_valve();
  return valve.tissue.chordae_kpa / own.tissue.chordae_kpa;
}

inline bool has_ring(const Valve& valve) {
  static const Valve before = fitting_valve();
  return valve.annulus_mm != before.annulus_mm;
}

template <class Leak>
Evaluator leak_of(Leak leak) {
  return [leak](const Valve& valve, const ClosureResult*) -> ClosedPlan {
    return {leaking(leak(valve)), nullptr};
  };
}

/// Leaks 2 mm2 per mm that the posteromedial tip is further than 24 mm from its trigone; less coaptation,
/// too.
inline ClosedPlan needs_suture(const Valve& valve, const ClosureResult*) {
  const Vec3 trigone = annulus_position_mm(valve, valve.landmarks.posteromedial_trigone);
  const double far = (papillary_tip_mm(valve, Side::Posteromedial) - trigone).norm() - 24.0;
  Evaluation evaluation = leaking(2.0 * std::max(0.0, far));
  for (CoaptationSection& section : evaluation.measure.coaptation.sections)
    section.height_mm = 6.0 - 0.1 * far;
  return {evaluation, nullptr};
}

inline Evaluator counted(Evaluator evaluate, std::atomic<int>& calls) {
  return [evaluate = std::move(evaluate), &calls](const Valve& valve, const ClosureResult* from) {
    ++calls;
    return evaluate(valve, from);
  };
}

/// Sets `cancelled` in its call number `last`.
inline Evaluator cancelling(Evaluator evaluate, std::atomic<int>& calls, int last,
                            std::atomic<bool>& cancelled) {
  return [evaluate = std::move(evaluate), &calls, last, &cancelled](const Valve& valve,
                                                                    const ClosureResult* from) {
    if (++calls == last) cancelled = true;
    return evaluate(valve, from);
  };
}

inline RepairPlan suture(Side side, double length_mm) {
  return {{PapillaryApproximation{.side = side, .suture_length_mm = length_mm}}};
}
inline RepairPlan own_ring(int sizes_below) { return {{Annuloplasty{OwnRing{sizes_below}}}}; }
inline RepairPlan both(RepairPlan a, const RepairPlan& b) {
  a.steps.insert(a.steps.end(), b.steps.begin(), b.steps.end());
  return a;
}

inline SearchOptions small_search() {
  SearchOptions options;
  options.evaluations = 90;
  options.threads = 1;  // small stubs: a second one only waits
  options.plans = 3;
  options.region_points = 9;
  options.evidence = false;
  options.fine_levels = 0;
  options.model_draws = 0;
  // Of the catalogue the classic ring alone: fewer branches.
  options.rules.forbidden = {"annuloplasty:generic-etlogix-like",
                             "annuloplasty:generic-geoform-like"};
  return options;
}

inline SearchContext context_of(const Evaluator& evaluate) { return {.evaluate = evaluate}; }

inline SearchResult searched(const SearchOptions& options, const SearchContext& context) {
  const Expected<SearchResult> result = search_plans(fitting_valve(), options, context);
  EXPECT_TRUE(result);
  return result ? *result : SearchResult{};
}

inline SearchResult searched(const Evaluator& evaluate, const SearchOptions& options) {
  return searched(options, context_of(evaluate));
}

inline std::vector<std::string> paths_of(const Expected<SearchResult>& refused) {
  std::vector<std::string> paths;
  if (!refused)
    for (const Error& error : refused.errors()) paths.push_back(error.path);
  return paths;
}

/// Only the leak counts: its mean alone.
inline CostWeights leak_alone() {
  CostWeights weights{};
  weights.sd_share = weights.incompetence = weights.margin = weights.coaptation = weights.gap = 0.0;
  weights.movement = weights.movement_above_10 = weights.step = weights.tension = 0.0;
  weights.undersizing = weights.undersizing_above_4 = 0.0;
  return weights;
}

inline PlanEvaluationOptions on_threads(int threads) {
  PlanEvaluationOptions options;
  options.threads = threads;
  return options;
}

/// Evaluations with what they refer to.
struct EvaluationScene {
  explicit EvaluationScene(Evaluator stub, PlanEvaluationOptions options = on_threads(1),
                           const std::atomic<bool>* cancelled = nullptr)
      : evaluate(std::move(stub)),
        monitor(0.0, cancelled),
        evaluations(evaluate, fitting_valve(), std::move(options), monitor) {}

  PlanRecord& closed(const RepairPlan& plan, int nodes) {
    PlanRecord& record = evaluations.record(plan);
    std::vector<PlanEvaluations::Wanted> wanted;
    for (int d = 0; d < nodes; ++d) wanted.push_back({&record, d});
    EXPECT_TRUE(evaluations.close(wanted, PlanEvaluations::Phase::Ranking));
    return record;
  }

  Evaluator evaluate;
  SearchMonitor monitor;
  PlanEvaluations evaluations;
};

/// NaN equals itself.
inline std::uint64_t bits(double value) { return std::bit_cast<std::uint64_t>(value); }

/// Of real closures: leaks_of(evaluations) gives the same bits with one thread and with two.
template <class LeaksOf>
void expect_same_on_any_threads(const LeaksOf& leaks_of) {
  const Valve& valve = shared_preset("human-functional-mr", 150);
  const Evaluator evaluate = closing_evaluator({});
  std::vector<std::uint64_t> leaks[2];
  for (const int threads : {1, 2}) {
    SearchMonitor monitor(0.0, nullptr);
    PlanEvaluations evaluations(evaluate, valve, on_threads(threads), monitor);
    for (const double leak : leaks_of(evaluations)) leaks[threads - 1].push_back(bits(leak));
  }
  EXPECT_EQ(leaks[0], leaks[1]);
}

inline void expect_same(const std::vector<Progress>& a, const std::vector<Progress>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].closures, b[i].closures);
    EXPECT_EQ(bits(a[i].cost), bits(b[i].cost));
  }
}

/// All but the time and what was known before.
inline void expect_same(const SearchResult& a, const SearchResult& b) {
  EXPECT_EQ(a.closures, b.closures);
  EXPECT_EQ(a.evaluations, b.evaluations);
  EXPECT_EQ(a.plans_tried, b.plans_tried);
  EXPECT_EQ(a.stop, b.stop);
  EXPECT_EQ(a.any_acceptable, b.any_acceptable);
  expect_same(a.progress, b.progress);
  expect_same(a.random_progress, b.random_progress);
  EXPECT_EQ(a.pareto_front.size(), b.pareto_front.size());
  ASSERT_EQ(a.plans.size(), b.plans.size());
  for (std::size_t i = 0; i < a.plans.size(); ++i) {
    const RankedPlan &p = a.plans[i], &q = b.plans[i];
    EXPECT_EQ(plan_key(p.plan), plan_key(q.plan));
    EXPECT_EQ(bits(p.cost), bits(q.cost));
    EXPECT_EQ(bits(p.subset_cost), bits(q.subset_cost));
    EXPECT_EQ(bits(p.probability_outranks_next), bits(q.probability_outranks_next));
    EXPECT_EQ(p.pareto, q.pareto);
    EXPECT_EQ(p.region.closures, q.region.closures);
    const LeakStatistics &s = p.region.leak_mm2, &t = q.region.leak_mm2;
    EXPECT_EQ(bits(s.nominal), bits(t.nominal));
    EXPECT_EQ(bits(s.mean), bits(t.mean));
    EXPECT_EQ(bits(s.sd), bits(t.sd));
    EXPECT_EQ(bits(s.worst), bits(t.worst));
  }
}

}  // namespace coapt::scene
