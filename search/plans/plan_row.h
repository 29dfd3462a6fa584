// A ranked plan as a row of a table: what a surgeon compares, in words.
#pragma once

#include <array>
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

/// A head of the table and its cells.
struct PlanColumn {
  const char* name;
  std::string PlanRow::*cell;
};
inline constexpr std::array<PlanColumn, 4> kPlanColumns = {
    {{"residual leak (< 5 mm²)", &PlanRow::leak},
     {"reserve", &PlanRow::reserve},
     {"opening, gradient", &PlanRow::opening},
     {"effort", &PlanRow::effort}}};

PlanRow row_of(const RankedPlan& plan);

/// Moves the cells that two rows or more all share out of them: empty in the rows then, and else in the answer.
PlanRow take_shared(std::vector<PlanRow>& rows);

/// "reserve: 7.4 mm; effort: 1 step": the cells that are not empty.
std::string words_of(const PlanRow& shared);

}  // namespace coapt
