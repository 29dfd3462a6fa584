// A ring as a solid body for 3D printing.
//
// Its section, the same all along, is swept along the ring's contour without twist: a round rigid core, whose middle lies on the contour, and
// outwards of it a flat band for the sutures, as wide as the core's radius. The body is closed: one surface without a border.
#pragma once

#include "io/mesh/mesh_file.h"

namespace coapt {

struct RingSection {
  double core_radius_mm = 1.2;
  double band_width_mm = 1.6;      ///< beyond the core
  double band_thickness_mm = 0.8;  ///< less than the core's diameter
};

/// Corners of the section, counter-clockwise seen along the contour: first outwards, then towards the atrium. |n| x 2
Eigen::Matrix<double, Eigen::Dynamic, 2> section_corners_mm(const RingSection& section);

/// @param contour_mm closed, counter-clockwise seen from the atrium, as ring_contour_mm(); normals point outwards.
TriangleMesh ring_solid(const Points& contour_mm, const RingSection& section = {});

/// Volume within a closed surface, mm3; positive if its normals point outwards.
double enclosed_mm3(const TriangleMesh& mesh);

}  // namespace coapt
