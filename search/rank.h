// The best plans, closed again all over the region of interest around them, and put in order.
#pragma once

#include <vector>

#include "search/refine.h"
#include "search/search.h"
#include "search/watch.h"

namespace coapt {

struct RankRequest {
  const Evaluator& evaluate;
  const Valve& valve;
  const SearchOptions& options;
  const std::vector<RingShape>& catalogue;
  const Evaluation& before;
};

/// Closures that rank_plans() takes at most. Twice as many plans as are reported are closed at the
/// first 5 nodes of the region, because the nominal orifice alone picks badly (a pilot: Spearman
/// 0.68 against 0.89); those that are then best at all nodes asked for.
int ranking_closures(const SearchOptions& options);

/// The best trial of each kind of plan (ring shape, anchors, number of neochordae), cheapest first,
/// at most twice as many as are reported; only if there are fewer kinds, more of the same kind.
std::vector<Trial> finalists(const std::vector<StrategySearch>& searches,
                             const SearchOptions& options);

/// By the share of closures over the region that failed (they have no leak to count), then by mean +
/// sd of the leak over the region in classes of 0.5 mm2 (closer ones cannot be told apart: equilibria
/// of one valve differ by up to 0.25; of its own leak where the region is not known), then by cost,
/// then by the order given. Plans whose own closure failed come last. Stopped early, all plans are
/// compared over the nodes that all of them have closed. Where time is short, fewer than twice as
/// many plans as are reported start: the first.
std::vector<RankedPlan> rank_plans(const RankRequest& request, const std::vector<Trial>& trials,
                                   Watch& watch);

}  // namespace coapt
