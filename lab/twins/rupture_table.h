#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "lab/twins/twin_study.h"

namespace coapt {

/// Fits with FitOptions::ruptures: a line a hypothesis of a twin. Columns: twin, lesion (the twin's), hypothesis, taken, refitted,
/// probability, objective, rms_mm (of the points), leak_mm2, twin_leak_mm2, surface_rms_mm (of the taken one, from the twin's surface).
std::string ruptures_csv(const std::vector<Twin>& twins);

/// In words: how many lesions were found, distances and leaks, of even and odd twins apart.
void print_ruptures(std::ostream& out, const std::vector<Twin>& twins);

}  // namespace coapt
