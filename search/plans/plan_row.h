// A ranked plan as a row of a table: what a surgeon compares, in words.
#pragma once

#include <string>
#include <vector>

#include "search/plans/search_result.h"

namespace coapt {

/// Beside the operation and the warnings. What was not computed is "not known".
struct PlanRow {
  std::string
      leak;  ///< what is left, and the probability of a leak below kMildLeak_mm2: "none or trace (> 99.9 %)", "7 mm² (62 %)"
  std::string reserve;  ///< against progression: "7.4 mm", "≥ 12 mm"
  std::string opening;  ///< and the mean gradient: "4.0 cm², 2.4 mmHg"
  std::string
      effort;  ///< "2 steps, 1 muscle, 0.5 sizes below": muscles with a suture, undersizing of the ring
};

PlanRow row_of(const RankedPlan& plan);

/// Moves the cells that two rows or more all share out of them: empty in the rows then, and else in the answer.
PlanRow take_shared(std::vector<PlanRow>& rows);

}  // namespace coapt
