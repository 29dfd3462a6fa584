// The continuous part of the search: the lengths of one strategy, on the lattice of what can be
// tied.
//
// BOBYQA looks for the valley from the best point so far; every point it asks for is moved to the
// lattice first, so that what is compared is what would be done, and asking twice costs nothing.
// Then the neighbours of the best point are tried. What is left of the quota goes to new starts at
// random points that have not been tried. So a quota is spent to the last closure unless every
// point is known.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <vector>

#include "search/evaluator.h"
#include "search/strategies.h"

namespace coapt {

/// A plan that was closed.
struct Trial {
  RepairPlan plan;
  Evaluation evaluation;
  double cost = 0.0;
};

/// Closes the plan at a lattice point; nothing when the search has been stopped.
using TryPoint = std::function<std::optional<Trial>(const Strategy&, const std::vector<int>& at)>;

struct StrategySearch {
  Strategy strategy;
  std::map<std::vector<int>, double> costs;  ///< of every lattice point tried
  std::optional<Trial> best;
  std::vector<int> best_at;
  std::vector<double> history;  ///< costs in the order of trying
  int rounds = 0;               ///< calls of refine()
};

bool is_exhausted(const StrategySearch& search);

/// Tries the strategy's own start.
void try_start(StrategySearch& search, const TryPoint& try_point);

/// Spends `quota` trials. Deterministic for a seed.
void refine(StrategySearch& search, int quota, std::uint64_t seed, const TryPoint& try_point);

}  // namespace coapt
