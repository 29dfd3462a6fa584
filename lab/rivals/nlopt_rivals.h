// Algorithms of NLopt, each alone on relaxed integers: every variable, categories as well, is a
// share in [0, 1] of its range. All settings but the first step and the tolerance are NLopt's own.
#pragma once

#include <string>
#include <vector>

#include "lab/rivals/rivals.h"

namespace coapt::rivals {

/// To direct, direct_l and ags the seed is nothing. COBYLA is not among them: it can hang inside, past every limit of calls (NLopt issues 118, 370).
/// StoGO is not either: it needs a gradient, and that of steps is zero.
std::vector<std::string> nlopt_rival_names();

/// Local algorithms and those that gather start again from random points until the cost is nothing. @pre `method` is one of the names, or
/// "cobyla" where something outlives the process. Throws what NLopt throws for a bug of ours.
void search_by_nlopt(const std::string& method, const RivalProblem& problem,
                     const SharesCost& cost);

}  // namespace coapt::rivals
