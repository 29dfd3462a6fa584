#pragma once

#include <string_view>

#include "io/image/label_map.h"

namespace coapt {

/// Attached data (no detached header), encodings raw, gzip and ascii, whole numbers from 0 to 65535 of any type, both byte
/// orders, three axes and at most one of layers, as Slicer writes in .seg.nrrd, or of phases: by its kind or, without names of segments, where
/// a phase is asked for. `most_voxels`: of all layers together.
/// Errors name the field ("/sizes").
Expected<LabelMap> read_nrrd(std::string_view bytes, Index most_voxels = kMostVoxels,
                             int phase = 0);

}  // namespace coapt
