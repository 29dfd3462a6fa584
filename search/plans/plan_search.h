// The repair-plan search: which plans keep a valve closed also when the surgeon's hand and the ventricle
// vary, and what they cost the patient.
#pragma once

#include <atomic>
#include <cstdint>
#include <string>
#include <vector>

#include "core/closure/closure.h"
#include "search/plans/gates.h"
#include "search/plans/plan_space.h"
#include "search/plans/region_report.h"
#include "search/plans/watch.h"

namespace coapt {

struct SearchOptions {
  int evaluations =
      2000;  ///< closures spent on searching, [1, 1e6]; fewer if nothing is left to try
  std::uint64_t seed = 1;
  int threads = 0;           ///< [0, 1024], 0: all cores. Does not change the result
  int plans = 5;             ///< how many ranked plans to report, [1, 50]
  int region_points = 1089;  ///< [1, 1089] nodes of the region of interest, for each reported plan
  bool evidence =
      true;  ///< close the reported plans also under errors of single sutures and further remodelling
  double seconds = 0.0;  ///< [0, 1e6] stop earlier when this much time is gone, the last 40 % of it
                         ///< spent on ranking; 0: no limit
  int no_improvement =
      0;  ///< [0, 1e6] stop searching after so many closures without a better plan; 0: never
  double target_mm2 =
      -1.0;  ///< [-1, 1e6] stop searching when mean + sd of a plan's leak over 17 nodes is not
             ///< above this; -1: never
  SearchRules rules;
  CostWeights weights;
  ClosureOptions closure;
};

struct RankedPlan {
  int rank = 0;
  std::string name;  ///< of an own plan: its name, or those of all that are the same; else empty
  RepairPlan plan;
  std::vector<std::string> description;  ///< in surgical words, one line a step
  double cost = 0.0;         ///< over the region's nodes that all ranked plans have closed
  double subset_cost = 0.0;  ///< over the nodes by which it was chosen
  int subset_nodes = 0;
  ClosureStatus status = ClosureStatus::Converged;
  bool crossing = false;
  ValveMeasure measure;  ///< as planned
  Effort effort;
  RegionReport region;
  std::vector<Gate> gates;
  std::vector<std::string> warnings;  ///< of gates and region, in words
  /// That it truly comes before the next plan, by robust closing, then by cost: resampling the nodes and the
  /// scatter of closures. NaN for the last. A tie if between 0.05 and 0.95.
  double probability_outranks_next = 0.0;
  bool pareto =
      false;  ///< no other ranked plan is as good in mean, sd, steps and undersizing, and better in one
};

/// A plan that no other one closed at as many nodes beats in mean and sd of the leak, steps and undersizing.
struct ParetoPlan {
  RepairPlan plan;
  std::vector<std::string> description;
  double mean_mm2 = 0.0, sd_mm2 = 0.0;  ///< of the leak
  int steps = 0;
  double sizes_below = 0.0;
  int nodes = 0;
};

/// Whether the plan closes the valve also when the surgeon's hand varies: it converges without
/// crossing, so does every closure over its region of interest, and mean + sd of the leak is below
/// kCompetentLeak_mm2. False where nothing of the region but the plan itself was closed.
bool closes_robustly(const RankedPlan& plan);

/// One step of the ladder from few closures a plan to many.
struct LadderStep {
  int from = 0, to = 0;   ///< nodes; from 0: geometry alone
  int plans = 0;          ///< over which the correlation was measured
  double spearman = 0.0;  ///< of costs; NaN if not measured
  bool skipped =
      false;  ///< below 0.8: geometry alone is then no reason to leave a plan out; from few
              ///< nodes plans climb more freely, from 17 more of them
};

/// The best cost known after so many closures.
struct Progress {
  int closures = 0;
  double cost = 0.0;
};

struct SearchResult {
  Evaluation before;
  std::vector<RankedPlan> plans;   ///< best first, distinct in surgical terms
  bool any_competent = false;      ///< whether a ranked plan closes the valve robustly
  std::vector<Progress> progress;  ///< of the search, at one closure a plan
  std::vector<Progress>
      random_progress;  ///< what trying plans at random is expected to reach, likewise
  std::vector<ParetoPlan> pareto_front;  ///< of all plans that were closed at 17 nodes, by steps
  std::vector<LadderStep> ladder;
  std::vector<CutBranches> cut;
  int branches = 0;
  std::int64_t plans_possible = 0;  ///< points of all lattices
  int plans_tried = 0;
  SearchStop stop = SearchStop::EvaluationLimit;
  int closures = 0;        ///< all of them: known ones, the valve as it is and ranking included
  int evaluations = 0;     ///< of these: of the search
  int closures_known = 0;  ///< of all: from an earlier run
  int closures_not_converged = 0, closures_crossed = 0;
  double seconds = 0.0;
};

/// Whether the best-ranked plan does; false without plans.
bool closes_robustly(const SearchResult& result);

/// What a search needs beside its options.
struct SearchContext {
  std::vector<RingShape> catalogue;
  Watch::Report progress{};  ///< may be empty
  const std::atomic<bool>* cancelled =
      nullptr;         ///< checked before each closure; the best so far is returned
  KnownPlans known{};  ///< of this valve and these closure options
  std::function<void(const std::string& key, int disturbance, const PlanClosure&)> keep{};
  Evaluator evaluate{};  ///< empty: closing_evaluator(); called from several threads at once
};

/// What speaks against a search, without closing anything: options out of range, rules that the valve does not allow
/// or that leave no plan to try. Errors point into the options ("/evaluations", "/rules/forbidden/0").
Errors check_search(const Valve& valve, const SearchOptions& options,
                    const std::vector<RingShape>& catalogue);

/// Errors are those of check_search().
Expected<SearchResult> search_plans(const Valve& valve, const SearchOptions& options,
                                    const SearchContext& context);

struct NamedPlan {
  std::string name;
  RepairPlan plan;
};

/// Own plans, scored and ranked as a search ranks its finalists; options for searching are not used. Errors point to
/// "/plans/I/steps/...".
Expected<SearchResult> evaluate_plans(const Valve& valve, const std::vector<NamedPlan>& plans,
                                      const SearchOptions& options, const SearchContext& context);

}  // namespace coapt
