// Leaflets that were imaged closed: how tall they are in the unpressurised heart, and how they hang there.
//
// The exposed part of a leaflet, from the annulus to the line of coaptation, is measured along its section by the plane through the
// annulus point that is parallel to the long axis and at right angles to the line of the commissures. In the closed valve it is longer than
// unpressurised; below it, unseen, the leaflet goes on. So
//   height = exposed length / kClosedStretch + hidden height, the latter where the section ends within kMeet_mm of the other sheet.
// Within kNearCommissure of the commissures such planes graze the leaflets: heights run from there to those of a human valve's
// commissures, in proportion to the annulus (parametric.h).
#pragma once

#include <optional>

#include "io/mesh/mesh_file.h"

namespace coapt {

/// Closed leaflets of presets are 6 to 14 % taller than unpressurised, where they do not prolapse: A2 and P2 of six, median 8.
inline constexpr double kClosedStretch = 1.08;
/// Of hanging leaflets from the vertical, inwards, as of parametric valves.
inline constexpr double kHangingInclination_deg = 20.0;

inline constexpr double kMeet_mm = 2.0;  // leaflets of 1 mm, and as much for noise

/// The section of a closed sheet, from the annulus point on.
struct ExposedLeaflet {
  double length_mm = 0.0;
  Vec3 end_mm = Vec3::Zero();  ///< where it goes out of sight, or ends
};

/// None where no line of the section begins within `reach_mm`.
/// @param annulus_mm in the frame of import_frame.h.
std::optional<ExposedLeaflet> exposed_leaflet(const TriangleMesh& sheet, const Vec3& annulus_mm,
                                              double reach_mm);

}  // namespace coapt
