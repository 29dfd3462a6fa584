// Pictures of closed valves, drawn with cairo.
#pragma once

#include <string>

#include "core/closed/closed_valve.h"

namespace coapt {

/// PNG bytes: atrial view with the leak coloured beside a long-axis section, captioned. `diastole`: a line about the open
/// valve (opening_picture.h); empty: none.
std::string closure_picture_png(const ClosedValve& closed, const std::string& diastole = "");

/// PNG bytes: atrial view of before and after side by side with sections below.
std::string comparison_picture_png(const ClosedValve& before, const ClosedValve& after);

/// PNG bytes, for a page that says the figures itself: before and after from the atrium in one scale, with
/// a legend; and the section of after, before behind it in grey.
std::string atrial_pair_png(const ClosedValve& before, const ClosedValve& after);
/// PNG bytes, as wide as atrial_pair_png(): after from the atrium, and its section.
std::string after_pair_png(const ClosedValve& after);
std::string section_change_png(const ClosedValve& before, const ClosedValve& after);

}  // namespace coapt
