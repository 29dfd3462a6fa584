// The continuous part of the search: sizes, lengths and places within one branch, on its lattice.
//
// A local optimiser looks for the valley from the best point so far; every point it asks for is
// moved to the lattice first, so that what is compared is what would be done, and asking twice
// costs nothing. Then the neighbours of the best point are tried. What is left of the quota goes to
// new starts at random points that have not been tried. Rounds take turns among the optimisers:
// BOBYQA is quickest where the cost is smooth, the others do not mind its kinks.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <optional>

#include "search/plans/plan_space.h"

namespace coapt {

struct PointCost {
  double cost = 0.0;
  int closures = 0;       ///< spent on it
  bool is_bound = false;  ///< not closed, because it cannot cost less than this, which is too much
};

/// Nothing when the search has been stopped.
using TryPoint = std::function<std::optional<PointCost>(const Branch&, const LatticePoint&)>;

struct BranchSearch {
  const Branch* branch = nullptr;
  std::map<LatticePoint, double> costs;  ///< of every point tried, bounds of those not closed
  LatticePoint best;                     ///< of those closed; empty before
  double best_cost = std::numeric_limits<double>::infinity();
  int rounds = 0;  ///< calls of refine()
};

bool is_exhausted(const BranchSearch& search);

/// Takes a point's cost, tried elsewhere.
void add_point(BranchSearch& search, const LatticePoint& at, const PointCost& cost);

/// Spends up to `quota` closures. Deterministic for a seed and the rounds before.
void refine(BranchSearch& search, int quota, std::uint64_t seed, const TryPoint& try_point);

}  // namespace coapt
