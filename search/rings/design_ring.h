// A ring designed for a population, or for one patient, and judged where its search did not look.
//
// Of a population every second member, from the first on, is searched on; the others are never seen by the search and judge the design
// against the best generic ring, which was chosen on the first half, too. Of one patient disturbances take the members' place: the search
// sees some, others judge.
#pragma once

#include "search/rings/ring_claims.h"
#include "search/rings/ring_search.h"

namespace coapt {

struct RingDesignOptions {
  int evaluations = 20000;  ///< see RingSearchOptions
  std::uint64_t seed = 1;
  int threads = 0;  ///< 0: all cores; does not change the result
  RingWeights weights{};
  std::function<void(const RingSearchProgress&)> progress{};
  const std::atomic<bool>* cancelled = nullptr;
};
inline constexpr Range kRingEvaluations{100, 10'000'000};

struct RingDesignResult {
  RingSearchResult search;
  int searched_members = 0, held_out_members = 0;
  int untrusted_members = 0;  ///< left out: as they are they do not close uncrossed
  int searched_disturbances = 0, held_out_disturbances = 0;
  std::vector<RingVerdict> verdicts;  ///< all held-out members, then each aetiology
  RingClaims claims;                  ///< of the held-out members
};

/// None if it was cancelled. Errors: fewer than two members to search on and judge by (of a population).
/// @param members one: for this patient. @param name of the design.
Expected<std::optional<RingDesignResult>> design_ring(std::vector<RingMember> members,
                                                      const std::string& name,
                                                      const RingDesignOptions& options);
/// With a trial of one's own; @pre the members are prepared.
Expected<std::optional<RingDesignResult>> design_ring_by(const RingTrial& trial,
                                                         const std::vector<RingMember>& members,
                                                         const std::string& name,
                                                         const RingDesignOptions& options);

}  // namespace coapt
