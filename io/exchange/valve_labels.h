// A valve as a label map: the leaflets as thick as the tissue is, or as the voxels are where these are larger, so that no hole
// shows; the annulus as a band. It loads beside the images that the valve was made from, and is imported again as any label map.
#pragma once

#include <functional>

#include "io/exchange/exported_valve.h"
#include "io/image/image_geometry.h"

namespace coapt {

/// Of a map: a CT of 512 x 512 x 128.
inline constexpr Index kMostLabelVoxels = Index{1} << 25;

/// Voxels of 0.5 mm about the points.
ImageGeometry label_grid_about(const Points& points_mm);

/// Labels 1 anterior leaflet, 2 posterior leaflet, 3 annulus, with names; where leaflets touch, the nearer one. `exported` and
/// `shape` must be in the axes of the map. Without a grid: label_grid_about() the valve. Errors at "/grid": the valve has no place in the
/// images, or lies outside of them, or takes more than kMostLabelVoxels; Busy: it was cancelled.
/// @param cancelled asked after every hundred thousand voxels
Expected<LabelMap> valve_labels(const ClosedValve& exported, const ValveShape& shape,
                                const ImageGeometry* grid,
                                const std::function<bool()>& cancelled = {});

}  // namespace coapt
