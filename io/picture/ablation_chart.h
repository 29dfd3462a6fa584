// The chart of what each ingredient of the model buys and costs, and its table.
#pragma once

#include <string>
#include <vector>

#include "search/ablation_study.h"

namespace coapt {

/// Columns: group, change, scene, status, crossing, attempts, compared, full_orifice_mm2,
/// orifice_change_mm2, leak_change_mm2, rms_mm, seconds, time_ratio.
std::string ablation_csv(const std::vector<AblationOutcome>& outcomes);

/// A row for each change: bars for the median |change| of the orifice, the median rms change of the
/// leaflets and the median time, with the largest of the scenes as a tick.
std::string ablation_svg(const std::vector<AblationOutcome>& outcomes);

}  // namespace coapt
