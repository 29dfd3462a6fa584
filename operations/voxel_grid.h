// Voxels of an image, as a document.
#pragma once

#include <functional>

#include "io/image/image_geometry.h"
#include "io/json/json_reader.h"

namespace coapt {

/// {"size": [i, j, k], "to_lps_mm": the affine map of (i, j, k, 1), three rows of four}.
std::function<ImageGeometry(const JsonPlace&)> grid_in(Index most_voxels);

}  // namespace coapt
