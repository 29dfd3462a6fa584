// The repair-plan search: branches made by rules, successive halving, NLopt inside a branch, then
// the best plans re-scored over a region of interest around them (thesis 4.2.3).
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "core/closure/closure.h"
#include "core/metrics/measure.h"
#include "core/repair/plan.h"
#include "search/evaluator.h"

namespace coapt {

/// Closures in all: one of the valve as it is, `evaluations` of the search, and the re-scoring over
/// the region of interest (see ranking_closures() in rank.h): for P plans and R points at most
/// 2 P (min(R, 5) - 1) + P (R - min(R, 5)), 100 by default.
struct SearchOptions {
  int evaluations =
      300;  ///< closures spent on searching, [1, 1e6]; fewer if no plan is left to try
  std::uint64_t seed = 1;
  int threads = 0;         ///< [0, 1024], 0: all cores. Does not change the result
  int plans = 5;           ///< how many ranked plans to report, [1, 50]
  int region_points = 17;  ///< [1, 1089] nodes of the region of interest, for each reported plan
  double seconds = 0.0;  ///< [0, 1e6] stop earlier when this much time is gone, the last 40 % of it
                         ///< spent on ranking; 0: no limit
  ClosureOptions closure;
};

/// Over the region of interest, its undisturbed node included; mm2, leaflets with half thickness.
/// All but `nominal` are NaN if fewer than two nodes closed: that says nothing about a region.
struct OrificeStatistics {
  double nominal = 0.0, mean = 0.0, sd = 0.0, worst = 0.0;
};

struct RankedPlan {
  int rank = 0;
  RepairPlan plan;
  std::vector<std::string> description;  ///< in surgical words, one line a step
  OrificeStatistics orifice_area_mm2;
  OrificeStatistics
      leak_mm2;  ///< of leak_mm2(ValveMeasure): the ranking goes by it, gaps hidden from above included
  double cost = 0.0;
  ClosureStatus status = ClosureStatus::Converged;
  bool crossing = false;
  ValveMeasure measure;
  double ring_sizes_below = 0.0;  ///< of the annulus's area, 0 without a ring (objective.h)
  double anterolateral_movement_mm = 0.0;  ///< of the papillary muscle
  double posteromedial_movement_mm = 0.0;
  int region_closures = 1;  ///< nodes of the region of interest that were closed, the plan's own
                            ///< included; the same for all plans of a result
  int region_failures = 0;  ///< of these: not trusted (evaluator.h), left out of the statistics
  std::vector<std::string> warnings;
};

/// Leak (orifice and hidden gap) below which a closed valve counts as competent.
inline constexpr double kCompetentLeak_mm2 = 1.0;

/// Whether the plan closes the valve also when the surgeon's hand varies: it converges without
/// crossing, so does every closure over its region of interest (region_failures is 0), and mean + sd
/// of the leak, by which plans are ranked, is below kCompetentLeak_mm2. False where nothing of the
/// region but the plan itself was closed: cancelled, out of time, or region_points 1.
bool closes_robustly(const RankedPlan& plan);

enum class SearchStop { EvaluationLimit, TimeLimit, Cancelled };

struct SearchProgress {
  int closures = 0, closures_planned = 0;
  double best_leak_mm2 = 0.0;
};

struct SearchResult {
  ValveMeasure before;
  ClosureStatus before_status = ClosureStatus::Converged;
  bool before_crossing = false;
  std::vector<RankedPlan> plans;          ///< best first
  std::vector<double> best_cost_history;  ///< best cost so far after each evaluation of the search,
                                          ///< in a fixed order
  SearchStop stop = SearchStop::EvaluationLimit;
  int closures = 0;     ///< all of them, the valve as it is and re-scoring included
  int evaluations = 0;  ///< of these: of plans as planned
  int closures_not_converged = 0, closures_crossed = 0;
  double seconds = 0.0;
};

/// Whether the best-ranked plan does; false without plans.
bool closes_robustly(const SearchResult& result);

/// Errors point into the options ("/evaluations").
/// @param progress called now and then, from one thread at a time; may be empty.
/// @param cancelled checked before each closure; the best so far is returned.
Expected<SearchResult> search_plans(const Valve& valve, const SearchOptions& options,
                                    const std::vector<RingShape>& catalogue,
                                    const std::function<void(const SearchProgress&)>& progress = {},
                                    const std::atomic<bool>* cancelled = nullptr);

/// The same with another way to close a valve, called from several threads at once.
Expected<SearchResult> search_plans_with(
    const Evaluator& evaluate, const Valve& valve, const SearchOptions& options,
    const std::vector<RingShape>& catalogue,
    const std::function<void(const SearchProgress&)>& progress = {},
    const std::atomic<bool>* cancelled = nullptr);

}  // namespace coapt
