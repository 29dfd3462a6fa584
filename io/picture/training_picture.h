// Pictures of the trainer's cases.
#pragma once

#include <array>
#include <string>

#include "search/training/exam_a.h"

namespace coapt {

/// PNG bytes: four closed valves from the atrium in one scale, numbered.
std::string choices_picture_png(const std::array<const ClosedValve*, kChoices>& choices);

/// PNG bytes: a valve without pressure from the atrium, without its chordae, which would tell where it has lesions.
/// @param flaccid_mm |V| x 3
std::string flaccid_picture_png(const Valve& valve, const Points& flaccid_mm);

}  // namespace coapt
