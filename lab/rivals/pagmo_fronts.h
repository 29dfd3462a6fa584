// Algorithms of pagmo for several objectives: NSGA-II (Deb et al. 2002) with integers, MOEA/D (Zhang and Li 2007) with shares in [0, 1], for it
// takes no integers. All else but the seed and the population is pagmo's own.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "lab/rivals/lattice_table.h"

namespace coapt::rivals {

std::vector<std::string> pagmo_front_names();

struct FrontRivalSettings {
  std::string method;
  std::uint64_t seed = 0;
  int budget = 500;  ///< plans, each once
  /// Told of each plan when it is first asked for, by a combination that is it.
  std::function<void(std::size_t combination)> on_plan;
};

/// @param objectives lattices of the same variables and plans, one for each objective. @pre the method is one of the names.
void search_front_by_pagmo(std::span<const LatticeTable> objectives,
                           const FrontRivalSettings& settings);

}  // namespace coapt::rivals
