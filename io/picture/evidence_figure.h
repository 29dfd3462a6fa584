#pragma once

#include <string>

#include "search/plans/plan_search.h"

namespace coapt {

/// As panels of one SVG: leak over suture length and angle (of both muscles, of each sutured one), further
/// remodelling, which axis decides, coaptation before and after, leak over the error of each step. What is not known has no panel.
std::string evidence_svg(const RankedPlan& plan, const ValveMeasure& before);

/// The same in smaller panels, three a row, maps without numbers in their cells.
std::string brief_evidence_svg(const RankedPlan& plan, const ValveMeasure& before);

}  // namespace coapt
