// What a person should know of a label map, whatever its labels are.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "io/image/label_map.h"
#include "io/image/label_voxels.h"
#include "io/mesh/import_valve.h"

namespace coapt {

/// Of a leaflet that seems to go on beyond its voxels.
std::optional<ImportDecision> cut_off(const LabelVoxels& voxels, const std::string& leaflet);

/// Half the width of a band about its middle line, where leaflets begin at its rim nearly all around, as they do where the band was drawn
/// over their beginning; else 0. @param line label_curve() of the band
double band_over_leaflets_mm(const LabelVoxels& band, const Points& line_mm, const LabelMap& map,
                             const std::vector<LabelVoxels>& leaflets);

/// On its phase, masks and frame.
std::vector<ImportDecision> map_decisions(const LabelMap& map, bool phase_given);

}  // namespace coapt
