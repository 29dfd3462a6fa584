// Looks for the plans between which one may choose: those that no other beats in leak, opening and durability at once.
//
// Plans are measured a few at a time, each time those whose trade-off, a scatter better than expected in all three, would add the largest volume to
// what is dominated (an upper confidence bound of the hypervolume improvement: Emmerich et al. 2011, Ponweiser et al. 2008). What is expected
// comes from the plans measured (place_model.h). A plan is measured by and by, and left as soon as what is known of it says that it adds nothing: most
// that leak cost one closure.
#pragma once

#include <vector>

#include "search/plans/trade_off.h"

namespace coapt {

struct FrontSearchOptions {
  int closures = 1000;  ///< never more
  std::uint64_t seed = 1;
};

/// A plan that was measured, and what had been spent until then.
struct FrontPlan {
  PlanRecord* plan = nullptr;
  int closures = 0, openings = 0;
};

/// @param candidates possible, each once; those whose trade-off is known already come first, for nothing.
std::vector<FrontPlan> search_front(PlanEvaluations& evaluations,
                                    const std::vector<PlanRecord*>& candidates,
                                    const FrontSearchOptions& options);

}  // namespace coapt
