// The search for a ring's shape and sizing rule over the valves of a population.
//
// Seven numbers: the six terms (ring_terms.h) and the sizing rule. A Latin hypercube of designs, the flat generic ones among them, is
// tried on a few members; the better half goes on to twice as many, until all have been asked (racing by halving). From the one or two
// that lead, as the budget allows, BOBYQA descends on a fixed set of members; its best shape also tries five sizing rules. The best
// designs of both are asked everything on all members, and the best is taken. All designs meet the same members in the same order under
// the same disturbances: common random anatomies. The generic shapes try the same five rules on the same members, so that the comparison
// is with the best of them.
#pragma once

#include <atomic>
#include <cstdint>
#include <optional>

#include "search/rings/ring_cost.h"

namespace coapt {

struct RingSearchProgress {
  const char* stage = "";  ///< "racing", "descent", "sizing", "final", "generic"
  int evaluations = 0, most_evaluations = 0;
  double best_cost = 0.0;  ///< of the stage's present members
};

struct RingSearchOptions {
  /// Closures and openings of the designs; the generic shapes and the verdict take more.
  int evaluations = 20000;
  std::uint64_t seed = 1;
  int threads = 0;  ///< 0: all cores; does not change the result
  /// Under which designs are compared; the first is 0, racing takes the first three.
  std::vector<int> disturbances{};
  RingWeights weights{};
  std::function<void(const RingSearchProgress&)> progress{};
  const std::atomic<bool>* cancelled = nullptr;
};

struct RatedRing {
  RingCandidate candidate;
  double cost = 0.0;  ///< over all members, everything asked
};

struct RingSearchResult {
  RingDesign design;
  double cost = 0.0;
  RatedRing generic;  ///< the best of the catalogue
  std::vector<RatedRing>
      rivals;           ///< all that were asked everything, designs and generic, best first
  int designs = 0;      ///< tried
  int evaluations = 0;  ///< closures and openings spent on designs
};

/// None if it was cancelled. @param name of the design. @pre at least one member; disturbances not empty.
std::optional<RingSearchResult> search_ring(const RingTrial& trial,
                                            const std::vector<RingMember>& members,
                                            const std::string& name,
                                            const RingSearchOptions& options);

}  // namespace coapt
