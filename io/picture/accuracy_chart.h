// The chart of accuracy against time, and its table.
#pragma once

#include <string>
#include <vector>

#include "search/accuracy_study.h"

namespace coapt {

/// Columns: scene, method, membrane, triangles, tolerance, status, crossing, seconds, rms_mm, max_mm,
/// orifice_error_mm2, own_rms_mm, own_orifice_error_mm2.
std::string accuracy_csv(const std::vector<AccuracyPoint>& points);

/// Milliseconds (decades) against rms distance from the reference; the Pareto front of `fast` and
/// `thesis` together is drawn through, the thesis's own figures are marked.
std::string accuracy_svg(const std::vector<AccuracyPoint>& points);

/// The same against the magnitude of the orifice's error.
std::string orifice_error_svg(const std::vector<AccuracyPoint>& points);

}  // namespace coapt
