// How far other figures than areas of a leak (area_error.h) may be off by the mesh.
//
// Measured on the 15 presets, as they are and with a ring of 32 mm, against the same valves refined once (2,600 triangles): nine of ten
// differ by less (27 of 30 coaptations, 28 of 30 tensions, 27 of 30 strains, 18 of 20 ratios; openings of six valves as they are). Five of them, refined twice, were 0.06 to 0.2 mm
// and 0 to 1 % from that: the error goes with the size of a triangle (docs/researcher/accuracy.md).
#pragma once

#include <optional>

#include "core/metrics/estimate.h"

namespace coapt {

enum class Figure {
  Coaptation,             ///< height of A2 with P2, mm
  Tension,                ///< the largest of a chorda, N
  Opening,                ///< in diastole, mm2
  Gradient,               ///< mean, in diastole, mmHg
  LeafletRatio,           ///< anterior over posterior length, annulus to coaptation
  CircumferentialStrain,  ///< 99th percentile over faces
  RadialStrain
};

/// From 5 to 95 %; none of a value that is not finite. @param triangles of the leaflets, >= 1
std::optional<Interval> figure_interval(Figure figure, double value, int triangles);

}  // namespace coapt
