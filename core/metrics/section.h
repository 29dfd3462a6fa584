// Cutting the leaflets with a plane.
#pragma once

#include "core/metrics/annulus.h"

namespace coapt {

struct SectionPlane {
  Vec3 point_mm = Vec3::Zero();
  Vec3 normal = Vec3::UnitX();
};

/// A connected line of the cut. Piece i, from points_mm[i] to points_mm[i + 1], lies in face
/// faces[i].
struct SectionLine {
  std::vector<Vec3> points_mm;
  std::vector<int> faces;
};

/// Open lines first, then closed ones. A vertex on the plane counts as being in front of it, so
/// that every cut face gives exactly one piece.
std::vector<SectionLine> cut(const Faces& faces, const Points& points_mm,
                             const SectionPlane& plane);

/// The long-axis plane through the saddle peak and mid-posterior, along the annular normal; its
/// normal points posteromedially.
SectionPlane mid_valve_plane(const Valve& valve);

/// The plane across the line that joins the commissures under pressure, at `along` (0 to 1) of its
/// length from the anterolateral one; its normal points posteromedially.
SectionPlane coaptation_plane(const Valve& valve, double along);

}  // namespace coapt
