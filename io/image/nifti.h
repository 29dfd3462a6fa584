#pragma once

#include <string_view>

#include "io/image/label_map.h"

namespace coapt {

/// One file (.nii, .nii.gz or .nii.bz2), NIfTI-1 or -2, one volume. The frame is that of sform, else of qform, else there is none.
/// Not accepted: intensities that are scaled (scl_slope), numbers that are not whole. Errors name the field ("/dim").
Expected<LabelMap> read_nifti(std::string_view bytes, Index most_voxels = kMostVoxels,
                              int phase = 0);

}  // namespace coapt
