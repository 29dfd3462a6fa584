// The best plans, closed again all over the region of interest around them, and put in order.
#pragma once

#include <vector>

#include "search/plans/fine_closures.h"
#include "search/plans/model_closures.h"
#include "search/plans/plan_evaluations.h"
#include "search/plans/search_options.h"
#include "search/plans/search_result.h"

namespace coapt {

/// Finalists for each reported plan, where 17 nodes rank badly; else one less. One more each may come from the front (pareto.h).
inline constexpr int kFinalists = 3;

/// Closures that close_finalists() takes at most: of any finalists, and of these, which have some already.
int ranking_closures(const SearchOptions& options);
int ranking_closures(const SearchOptions& options, const std::vector<PlanRecord*>& finalists);

/// Closures that the evidence for a plan takes: further remodelling and disease, errors of each suture
/// alone, and of both by themselves.
int evidence_closures(const RepairPlan& plan);

/// Closes the finalists at as many nodes as the ladder goes, dropping the dearest on the way down
/// to options.plans; the evidence, if asked for: disease before the first are dropped, whose price then counts; for those that stay single sutures,
/// independent errors, remodelling. Out of time or cancelled it leaves fewer nodes, but all plans that stay have equal
/// ones.
std::vector<PlanRecord*> close_finalists(PlanEvaluations& evaluations,
                                         std::vector<PlanRecord*> finalists,
                                         const SearchOptions& options,
                                         std::vector<LadderStep>& ladder);

/// Plans in order: those whose own closure failed come last, before them those with more than a
/// twentieth of the region's closures failed, then those that open too little (is_stenotic());
/// robustly closing ones first; then by cost, which counts failures, too, and the price of what they do not last. Over the nodes that all of them have closed, at most so many. Whether a
/// plan closes robustly is asked of the fine closures, too; the cost is of its own mesh. Draws of
/// the model change no rank: they say whether it holds.
std::vector<RankedPlan> rank(PlanEvaluations& evaluations, const std::vector<PlanRecord*>& plans,
                             int most_nodes, const FineClosures& fine = {},
                             const ModelClosures& model = {});

}  // namespace coapt
