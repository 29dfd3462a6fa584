// Algorithms of pagmo with a population of 24. Where they honour integers the variables are integers;
// the others (de1220, sade, cmaes) would relax those silently, and see shares in [0, 1] instead.
// Its many others, NSGA-II among them, want several objectives or have a sibling here.
#pragma once

#include <string>
#include <vector>

#include "lab/rivals/rivals.h"

namespace coapt::rivals {

std::vector<std::string> pagmo_rival_names();

/// Starts again with another population until the cost is nothing. @pre `method` is of the names.
void search_by_pagmo(const std::string& method, const RivalProblem& problem,
                     const SharesCost& cost);

}  // namespace coapt::rivals
