// Lattices that are solved by a glance at their formula.
#pragma once

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "lab/rivals/lattice_table.h"

namespace coapt::rivals {

/// Fills the costs with those of every combination. @param cost of a vector of values
template <class Cost>
LatticeTable solved(LatticeTable table, Cost cost) {
  std::size_t combinations = 1;
  for (const LatticeVariable& v : table.variables)
    combinations *= static_cast<std::size_t>(v.count);
  for (std::size_t i = 0; i < combinations; ++i)
    table.costs.push_back(cost(combination_of(table, i)));
  return table;
}

/// Squares of the distances to (3, 1, 2), summed: 0 there and nowhere else.
inline LatticeTable bowl() {
  return solved({"bowl", {{"x", true, 5}, {"y", true, 5}, {"z", true, 5}}, {}},
                [](const std::vector<int>& at) {
                  const double x = at[0] - 3, y = at[1] - 1, z = at[2] - 2;
                  return x * x + y * y + z * z;
                });
}

/// 10,800 combinations of a ring and two anchors, least at {3, 2, 1, 2, 2, 1, 0} alone. Without a
/// ring (shape 0) its size means nothing, without an anchor (0) its movement does not; the greatest
/// ring with both moved furthest is impossible.
inline LatticeTable ring_and_anchors() {
  const LatticeTable table{"ring and anchors",
                           {{"ring shape", false, 5},
                            {"ring size", true, 5},
                            {"anterolateral anchor", false, 3},
                            {"anterolateral movement", true, 4},
                            {"posteromedial anchor", false, 3},
                            {"posteromedial movement", true, 4},
                            {"chordae", true, 3}},
                           {}};
  return solved(table, [](const std::vector<int>& at) {
    constexpr double shape[] = {40.0, 12.0, 7.0, 0.0, 9.0};
    constexpr double anterolateral[] = {15.0, 0.0, 4.0};
    constexpr double posteromedial[] = {9.0, 6.0, 0.0};
    if (at[0] > 0 && at[1] == 4 && at[2] > 0 && at[3] == 3 && at[4] > 0 && at[5] == 3)
      return std::numeric_limits<double>::infinity();
    const auto bent = [](int value, int best) { return 3.0 * (value - best) * (value - best); };
    double cost = shape[at[0]] + anterolateral[at[2]] + posteromedial[at[4]] + 2.0 * at[6];
    if (at[0] > 0) cost += bent(at[1], 2);
    if (at[2] > 0) cost += bent(at[3], 2);
    if (at[4] > 0) cost += bent(at[5], 1);
    if (at[0] > 0 && at[2] > 0) cost += 2.0 * std::abs(at[1] - at[3]);  // they act together
    return cost;
  });
}

}  // namespace coapt::rivals
