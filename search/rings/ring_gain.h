// What a designed ring gains over another on members that its search never saw.
#pragma once

#include "search/population/bootstrap.h"
#include "search/rings/ring_trial.h"

namespace coapt {

/// One ring over the units of a verdict: means.
struct RingFigures {
  double below_percent = 0.0;  ///< closures that leak less than 5 mm2
  double leak_mm2 = 0.0;       ///< each counted up to kMostLeak_mm2
  double gradient_mmhg = 0.0, durability_mm = 0.0, tenting_mm = 0.0;  ///< over those that are known
  double suture_max_n = 0.0, suture_normal_n = 0.0;                   ///< likewise
  double stenotic_percent = 0.0;    ///< members with a mean gradient above 5 mmHg
  double undersized_percent = 0.0;  ///< members with more than four sizes taken
  double size_mm = 0.0;
};
RingFigures figures_of(const std::vector<RingOutcome>& outcomes);

/// Of one aetiology, or of all ("").
struct RingVerdict {
  std::string aetiology;
  int members = 0;
  RingFigures design, generic;
  MeanInterval below_percent{};  ///< percentage points, design less generic
  MeanInterval leak_mm2{};       ///< generic less design: positive is better
};

/// All members first, then each aetiology in the order met. @param design, generic of the same members in the same order. Of one
/// member the units are its disturbances, else the members.
std::vector<RingVerdict> verdicts_of(const std::vector<RingMember>& members,
                                     const std::vector<RingOutcome>& design,
                                     const std::vector<RingOutcome>& generic);

}  // namespace coapt
