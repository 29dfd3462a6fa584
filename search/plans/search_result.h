// What a search for repair plans finds.
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/closed/diagnosis.h"
#include "search/plans/durability.h"
#include "search/plans/fine_closures.h"
#include "search/plans/gates.h"
#include "search/plans/ladder.h"
#include "search/plans/model_closures.h"
#include "search/plans/plan_estimates.h"
#include "search/plans/plan_order.h"
#include "search/plans/plan_space.h"
#include "search/plans/region_report.h"
#include "search/plans/search_progress.h"
#include "search/plans/start_check.h"
#include "search/plans/tolerance.h"

namespace coapt {

/// What another anchor of a papillary suture would change.
struct OtherAnchor {
  Side side = Side::Posteromedial;
  Anchor anchor = Anchor::IpsilateralTrigone;  ///< the plan's
  Anchor other = Anchor::SaddlePeak;
  double more_mm2 = 0.0;  ///< mean leak, more than with the plan's
};

struct RankedPlan {
  int rank = 0;
  std::string name;  ///< of an own plan: its name, or those of all that are the same; else empty
  RepairPlan plan;
  std::vector<std::string> description;  ///< in surgical words, one line a step
  double cost = 0.0;  ///< over the region's nodes that all ranked plans have closed
  /// By which it is ranked: of cost, fine_cost_change and durability_price.
  CostTerms terms;
  double subset_cost = 0.0;  ///< over the nodes by which it was chosen
  int subset_nodes = 0;
  ClosureStatus status = ClosureStatus::Converged;
  bool crossing = false;
  ValveMeasure measure;  ///< as planned
  /// As planned, with its closure; null if the evaluator kept none.
  std::shared_ptr<const ClosedValve> closed;
  Effort effort;
  RegionReport region;
  PlanEstimates estimates{};               ///< as planned
  std::optional<PlanOpening> opening{};    ///< none if openings were not asked for
  std::optional<Durability> durability{};  ///< with the evidence, or from the front
  double durability_price =
      0.0;  ///< in mm2, by which it is ranked besides its cost; 0 unless all plans have a durability
  /// Whose verdict counts besides that of its own mesh: see FineMesh::levels.
  int fine_levels = 0;
  /// As planned, on the refined mesh; none without levels, or if the search was cancelled before.
  std::optional<PlanClosure> fine;
  double fine_leak_error_mm2 = std::numeric_limits<double>::quiet_NaN();  ///< see area_error.h
  double fine_cost_change = 0.0;  ///< of its cost, by which it is ranked (fine_closures.h)
  /// Its place by its own mesh alone; 0 where the finer one does not count.
  int own_mesh_rank = 0;
  /// As planned, under draws of the model; none without draws, or if the search was cancelled before.
  std::optional<ModelSpread> model;
  /// With the evidence; else none.
  std::optional<StartCheck> starts{};
  std::vector<OtherAnchor> other_anchors{};  ///< with the evidence, of the first plan
  std::vector<ToleranceCurve> tolerance{};   ///< likewise
  std::vector<Gate> gates;
  std::vector<std::string> warnings;  ///< of gates and region, in words
  /// That the valve leaks less than kMildLeak_mm2, over errors of execution, tissue and mesh (acceptance.h).
  double acceptable_probability = 0.0;
  bool is_acceptable = false;  ///< plan_order.h
  PlanTier tier = PlanTier::NotAcceptable;
  int of_class = 0;  ///< from 1: plans of one class cannot be told apart
  bool simplest_of_class = false;
  bool ties_with_next = false;  ///< of one class
  /// That it is rightly before the next plan (acceptance.h). NaN for the last, and where one node was closed.
  double probability_outranks_next = 0.0;
  /// In how many of threshold_settings() it comes first (plan_order.h); 0 where the price ranks.
  int times_first = 0;
  /// No other ranked plan is as good in mean + sd of the leak, opening and durability, and better in one (pareto.h).
  bool pareto = false;
  /// Rank of a plan that is, and in what it is better: "leak", "opening", "reserve" or "effort"; 0 where none is.
  int beaten_by = 0;
  std::vector<std::string> beaten_in;
};

/// A plan that no other one known as well beats: in mean + sd of the leak, opening and durability (pareto.h).
struct ParetoPlan {
  RepairPlan plan;
  std::vector<std::string> description;
  double mean_mm2 = 0.0, sd_mm2 = 0.0;  ///< of the leak
  int steps = 0;
  double sizes_below = 0.0;
  double opening_mm2 = std::numeric_limits<double>::quiet_NaN();    ///< NaN: not opened
  double durability_mm = std::numeric_limits<double>::quiet_NaN();  ///< NaN: not known
  double cost = 0.0;  ///< with the price of what it does not last
  int nodes = 0;
};

/// A plan that was closed at least as planned.
struct TriedPlan {
  RepairPlan plan;
  PlanClosure planned;           ///< its closure as planned
  double cost_as_planned = 0.0;  ///< over that closure alone
  double cost = 0.0;             ///< over its nodes
  int nodes = 0;                 ///< of the region, closed one after the other from the first
  LeakStatistics leak_mm2;       ///< over its nodes
  int failures = 0;              ///< of its nodes
  int rank = 0;                  ///< among the ranked plans; 0: it is none of them
};

struct SearchResult {
  Evaluation before;
  std::optional<PlanOpening> opening_before{};
  /// The valve as it is, with its closure; null if the evaluator kept none.
  std::shared_ptr<const ClosedValve> closed_before;
  /// Of the valve as it is; none if it does not close, or the evaluator kept no closure.
  std::optional<Diagnosis> diagnosis;
  /// Best first, distinct in surgical terms.
  std::vector<RankedPlan> plans;
  /// What RankedPlan::fine is of.
  FineMesh fine_mesh;
  /// Draws of the model that RankedPlan::model is of, and the valve as it is under them.
  int model_draws = 0;
  bool draws_chordae = false;  ///< each with chordae of its own: the valve's were never seen
  bool draws_fit = false;      ///< each with other values of what a fit left uncertain
  std::optional<ModelSpread> before_under_draws;
  std::vector<Observation> observed{};  ///< that the draws were weighed by
  double effective_draws = 0.0;         ///< see ModelClosures::effective
  bool observed_contradicts = false;    ///< the model: the draws are not weighed
  PlanEstimates before_estimates{};     ///< of the valve as it is
  /// Which measurement would say most of the leak that the first plan leaves; of kConditionedDraws draws or more.
  std::vector<InformationRow> information{};
  int model_closures = 0;  ///< made for these draws; `closures` does not count them
  /// Whether a ranked plan is acceptable.
  bool any_acceptable = false;
  /// Of the search, at one closure a plan.
  std::vector<Progress> progress;
  /// What trying plans at random is expected to reach, likewise.
  std::vector<Progress> random_progress;
  /// Cheapest first, of those whose trade-off is known; if none's is, of all closed at 17 nodes.
  std::vector<ParetoPlan> pareto_front;
  /// In the order of trying.
  std::vector<TriedPlan> tried;
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
  double seconds = 0.0;  ///< NaN: not to be told
};

/// Converged, not crossed, its leak a number: as planned.
bool trusted(const RankedPlan& plan);

/// Whether nothing on the refined mesh speaks against the plan: it converges there without crossing and leaks less than
/// kMildLeak_mm2, or no refinement was asked for.
bool closes_finely(const RankedPlan& plan);

/// Whether the best-ranked plan is acceptable; false without plans.
bool is_acceptable(const SearchResult& result);

}  // namespace coapt
