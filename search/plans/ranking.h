// The best plans, closed again all over the region of interest around them, and put in order.
#pragma once

#include <vector>

#include "search/plans/fine_closures.h"
#include "search/plans/model_closures.h"
#include "search/plans/plan_evaluations.h"
#include "search/plans/search_options.h"
#include "search/plans/search_result.h"

namespace coapt {

/// Nodes over which reported plans are taken from the finalists, and ordered.
inline constexpr int kBeforeTheRegion = 65;

/// Finalists of a search that compares kFewestCompared plans: where 17 nodes rank badly and where they rank well.
inline constexpr int kFinalists = 9, kFewerFinalists = 6;

/// As many, and one more for each plan more that is compared.
inline int wanted_finalists(const SearchOptions& options, bool nodes_rank_badly) {
  return (nodes_rank_badly ? kFinalists : kFewerFinalists) + compared_plans(options) -
         kFewestCompared;
}

/// Finalists that may come from the front (pareto.h) besides.
inline constexpr int kFrontFinalists = 3;

/// Finalists more, where none of those ranks first without reproach: acceptable, without an avoidable warning.
inline constexpr int kReserve = 8;

/// Closures that close_finalists() and close_evidence() take at most: of any finalists, and of these, which have some already.
int ranking_closures(const SearchOptions& options);
int ranking_closures(const SearchOptions& options, const std::vector<PlanRecord*>& finalists);

/// Closures that the evidence for a plan takes: further remodelling and disease, errors of each suture
/// alone, and of both by themselves.
int evidence_closures(const RepairPlan& plan);

struct Finalists {
  std::vector<PlanRecord*> kept;
  std::vector<PlanRecord*> others;  ///< dropped, closed at as many nodes, in order
};

/// Closes the finalists at as many nodes as the ladder goes, joined by simpler and safer versions of the first class (simpler_plans.h), dropping the last on the
/// way down to compared_plans(), of two that are the same in surgical terms the later one first; if evidence is asked for, the course of disease before the first are
/// dropped, whose price then counts. Out of time or cancelled it leaves fewer nodes, but all plans that stay have equal ones.
Finalists close_finalists(PlanEvaluations& evaluations, std::vector<PlanRecord*> finalists,
                          const SearchOptions& options, std::vector<LadderStep>& ladder);

/// Opens further plans and closes them as finalists that stay are: at options.region_points nodes and under disease. False if it
/// was stopped.
bool close_reserve(PlanEvaluations& evaluations, const std::vector<PlanRecord*>& reserve,
                   const SearchOptions& options);

/// Further remodelling, errors of each suture alone, and all errors at once: what evidence_closures() counts, less disease.
void close_evidence(PlanEvaluations& evaluations, const std::vector<PlanRecord*>& plans);

/// Closes a plan at so many nodes: its map.
void close_map(PlanEvaluations& evaluations, PlanRecord& plan, int nodes);

/// That compare_anchors() takes, at most.
int anchor_closures(const SearchOptions& options);

/// Of each of a plan's papillary sutures the saddle peak in place of its trigone, or the trigone in place of any other anchor, moved as far: over kChosenBy
/// nodes, at most options.region_points. None if it was stopped, or is not possible.
std::vector<OtherAnchor> compare_anchors(PlanEvaluations& evaluations, const PlanRecord& plan,
                                         const SearchOptions& options);

/// Plans in the order of plan_order.h, over the nodes that all of them have closed, at most options.region_points. Whether a plan is
/// acceptable is asked of the fine closures and of draws of the model, too; the cost is of its own mesh. @return the first options.plans
std::vector<RankedPlan> rank(PlanEvaluations& evaluations, const std::vector<PlanRecord*>& plans,
                             const SearchOptions& options, const FineClosures& fine = {},
                             const ModelClosures& model = {});

}  // namespace coapt
