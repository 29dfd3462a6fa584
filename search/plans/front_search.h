// Looks for the plans between which one may choose: those that no other beats in leak, opening and durability at once.
//
// Plans are measured a few at a time, each time those whose trade-off, two scatters better than expected in all three, would add the largest volume to
// what is dominated (an upper confidence bound of the hypervolume improvement: Emmerich et al. 2011, Ponweiser et al. 2008). What is expected
// comes from the plans measured (place_model.h). A plan is measured by and by, and left as soon as what is known of it says that it adds nothing: most
// that leak cost one closure.
#pragma once

#include <vector>

#include "search/plans/ladder.h"
#include "search/plans/trade_off.h"

namespace coapt {

/// A round of the search takes at most so many, the first one, of plans that nothing is known of, twice as many.
inline constexpr int kLeastFrontClosures = 2 * (kChosenBy + kDisease.count);

struct FrontSearchOptions {
  int closures = 1000;  ///< never more; below kLeastFrontClosures nothing is asked for
  std::uint64_t seed = 1;
};

/// A plan that was asked for, and what had been spent until then. Its trade-off is known unless it was left.
struct FrontPlan {
  PlanRecord* plan = nullptr;
  int closures = 0, openings = 0;
};

/// @param candidates possible, each once; those whose trade-off is known already come first, for nothing. @return in order.
std::vector<FrontPlan> search_front(PlanEvaluations& evaluations,
                                    const std::vector<PlanRecord*>& candidates,
                                    const FrontSearchOptions& options);

}  // namespace coapt
