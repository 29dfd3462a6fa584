// One ring, sewn into one valve: what it leaves under disturbances. The expensive part of designing a ring, and the part that tests
// replace.
#pragma once

#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "core/repair/ring_design.h"
#include "search/evaluator.h"

namespace coapt {

/// A valve that rings are tried in.
struct RingMember {
  std::string name, aetiology;  ///< aetiology: may be empty
  Valve valve;
  /// Closed as it is: where its closures with rings start, whatever ring it is, so that none of them depends on another.
  std::shared_ptr<const ClosureResult> before{};
};

/// A generic or a designed shape with its sizing rule; the rule is of the ring's true width for both.
struct RingCandidate {
  std::variant<std::string, DesignedShape> shape;  ///< std::string: name in the catalogue
  double width_over_transverse = 0.9;

  bool operator==(const RingCandidate&) const = default;
};

Annuloplasty sized_ring(const RingCandidate& candidate, const Valve& valve);

/// What is asked of a ring in one valve.
struct RingQuestion {
  std::vector<int> disturbances = {0};  ///< indices into disturbances(), the first 0: as planned
  bool opening = false;                 ///< how it opens in diastole
  bool durability = false;              ///< how far disease may go on (durability.h)
};

struct RingOutcome {
  bool is_possible = false;  ///< a plan with this ring can be done; nothing else is known otherwise
  double size_mm = 0.0;      ///< labelled
  double sizes_below = 0.0;  ///< ring_sizes_below()
  std::vector<double> leaks_mm2;  ///< by disturbance; NaN where the closure cannot be trusted
  double tenting_mm = std::numeric_limits<double>::quiet_NaN();    ///< as planned
  double suture_max_n = std::numeric_limits<double>::quiet_NaN();  ///< SutureLoad, as planned
  double suture_mean_n = std::numeric_limits<double>::quiet_NaN();
  double suture_normal_n =
      std::numeric_limits<double>::quiet_NaN();                     ///< SutureLoad::out_of_plane_n
  double gradient_mmhg = std::numeric_limits<double>::quiet_NaN();  ///< if asked and trusted
  double durability_mm = std::numeric_limits<double>::quiet_NaN();  ///< if asked
};

/// Closures and openings of one answer, at most.
int price_of(const RingQuestion& question);

/// Called from several threads at once.
using RingTrial =
    std::function<RingOutcome(const RingMember&, const Annuloplasty&, const RingQuestion&)>;

/// By closing and opening the valve. All closures are warm: as planned from the valve as it is, disturbed from as planned.
RingTrial closing_trial(const ClosureOptions& options);

/// Closes the members as they are. Those that do not close uncrossed are left out.
std::vector<RingMember> prepare_members(std::vector<RingMember> members,
                                        const ClosureOptions& options, int threads);

/// Of each member, in order; on `threads` threads, the same for any number of them.
std::vector<RingOutcome> try_ring(const RingTrial& trial, const std::vector<RingMember>& members,
                                  const RingCandidate& candidate, const RingQuestion& question,
                                  int threads);

}  // namespace coapt
