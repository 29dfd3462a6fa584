// The studies' results as CSV, from which plot.py draws the charts; a line an outcome.
#pragma once

#include <string>
#include <vector>

#include "lab/closures/ablation_study.h"
#include "lab/closures/accuracy_study.h"
#include "lab/closures/stability_study.h"

namespace coapt {

/// Columns: group, change, scene, status, crossing, attempts, compared, full_leak_mm2,
/// leak_change_mm2, rms_mm, seconds, time_ratio.
std::string ablation_csv(const std::vector<AblationOutcome>& outcomes);

/// Columns: scene, method, membrane, triangles, tolerance, status, crossing, seconds, rms_mm, max_mm,
/// leak_error_mm2, own_rms_mm, own_leak_error_mm2.
std::string accuracy_csv(const std::vector<AccuracyPoint>& points);

/// Columns: scene, axis, level, nominal, method, outcome, steps, seconds, residual, crossing_pairs,
/// attempts, from_reference_mm, end_from_reference_mm, leak_difference_mm2. Empty where there is no
/// number.
std::string stability_csv(const std::vector<StabilityCell>& cells);

}  // namespace coapt
