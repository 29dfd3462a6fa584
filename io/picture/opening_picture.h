// Pictures of valves in diastole.
#pragma once

#include <string>
#include <vector>

#include "core/opened/opened_valve.h"
#include "core/repair/plan.h"

namespace coapt {

/// What was measured, a line each: the first names the opening, the second the gradient. None where the valve did not come to rest.
std::vector<std::string> opening_words(const OpeningMeasure& measure);

/// One line: "Opening 4.5 cm², mean gradient 1.0 mmHg at 155 ml/s in diastole", or what speaks against that.
std::string opening_line(const OpenedValve& opened);

/// PNG bytes: the open valve from the atrium, with its opening, beside a long-axis section. `before`: the
/// valve before `plan` repaired it; without steps the valve itself.
std::string opening_picture_png(const OpenedValve& opened, const Valve& before,
                                const RepairPlan& plan);

}  // namespace coapt
