// The optimisers that the search for plans is measured against, on lattices solved exhaustively.
// Each sees the problem as its user would write it down: shares in [0, 1] that a combination is
// rounded from, a budget of simulations, and a cache before the simulator.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "lab/rivals/budgeted_cost.h"
#include "lab/rivals/lattice_table.h"

namespace coapt::rivals {

/// What a rival knows of a lattice.
struct RivalProblem {
  std::vector<int> counts;  ///< of each variable's values
  std::uint64_t seed = 0;
  int most_calls = 0;           ///< the cost is nothing by then
  int most_calls_of_start = 0;  ///< after so many it has stalled: start again from elsewhere
};

/// Cost of what the shares are rounded to, one share for each variable, or nothing: stop.
using SharesCost = std::function<std::optional<double>(const std::vector<double>& shares)>;
/// Searches until the cost is nothing, or gives up before.
using Rival = std::function<void(const RivalProblem&, const SharesCost&)>;

struct RivalSettings {
  std::string method;
  std::uint64_t seed = 0;
  int budget = 500;  ///< evaluations of combinations not asked before, 0 to kMostCombinations
  std::function<void(const Improvement&)> on_improvement;  ///< at once; may be empty
};

struct RivalRun {
  std::string method;
  std::uint64_t seed = 0;
  std::vector<Improvement> improvements;  ///< costs fall; empty if all it met was impossible
  int evaluations = 0;  ///< fewer than the budget if it stalled or met all combinations
  int calls = 0;        ///< the free ones too

  bool operator==(const RivalRun&) const = default;
};

/// Those that run in this process: random (of plans, each with the same chance), random_variables (of the
/// variables' values, so that plans with few steps come often) and sobol, then NLopt's.
std::vector<std::string> rival_names();

/// The same table and settings give the same run. @pre the method is one of rival_names().
RivalRun run_rival(const LatticeTable& table, const RivalSettings& settings);
/// With a rival from elsewhere.
RivalRun run_rival(const LatticeTable& table, const RivalSettings& settings, const Rival& rival);

/// In [0, 1), uniform: the same numbers with every standard library, whose distributions differ.
inline double random_share(std::mt19937_64& engine) {
  return static_cast<double>(engine() >> 11) * 0x1p-53;
}

}  // namespace coapt::rivals
