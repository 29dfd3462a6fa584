// A closed surface as it was measured, and how far a closed model lies from it.
#pragma once

#include <vector>

#include "core/closed/closed_valve.h"

namespace coapt {

/// What of the leaflets the measured points show.
enum class MeasuredSide {
  Atrial,  ///< their atrial surface, half a thickness above the model's mid-surface
  Middle   ///< their mid-surface
};

/// At most about `most` of the points: the first in each cube of a lattice, whose edge is the smallest that leaves so few.
Points thinned(const Points& points_mm, int most);

/// A closed model, to measure distances from.
struct ClosedSurface {
  Points closed_mm;  ///< |V| x 3
  Faces faces;
  std::vector<double> thickness_mm;  ///< |F|
};

ClosedSurface surface_of(const ClosedValve& closed);

/// Per point: how far it is from the model's measured side, mm, > 0 towards the atrium. From a point beyond an edge of the
/// model the distance is positive, whatever the side.
std::vector<double> signed_distances_mm(const Points& points_mm, const ClosedSurface& model,
                                        MeasuredSide side);

}  // namespace coapt
