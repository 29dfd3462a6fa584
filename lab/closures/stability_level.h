// One level of one axis: a scene that methods close and that judges what they made of it.
#pragma once

#include "core/closure/closure.h"
#include "lab/closures/stability_study.h"

namespace coapt {

inline constexpr const char* kLadderName = "coapt";

class StabilityLevel {
 public:
  /// Closes the reference: `fast` carried to residual 1e-6 in double.
  StabilityLevel(const StabilityScene& scene, Membrane membrane);

  /// One attempt; scene, axis and level of the cell are left to the caller.
  StabilityCell close(const StabilityMethod& method) const;

  /// close_valve() with default options, named kLadderName.
  StabilityCell close_with_ladder() const;

 private:
  Points all_nodes(const ClosureResult& closed) const;
  void judge(const ClosureRun& run, const ContactLaw& contact, StabilityCell& cell) const;
  void compare(const ClosureRun& run, const ContactLaw& contact, StabilityCell& cell) const;

  const StabilityScene& scene_;
  ClosureModel model_;
  AttemptSettings attempt_;
  ClosureOptions options_;
  ClosureResult reference_;
};

}  // namespace coapt
