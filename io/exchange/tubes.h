// Lines as thin tubes, so that viewers that draw lines one pixel wide show chordae and sutures.
#pragma once

#include <vector>

#include "core/valve/types.h"

namespace coapt {

/// A straight piece.
struct TubeAxis {
  Vec3 start_mm, end_mm;
  double radius_mm = 0.5;
};

struct Tubes {
  Points vertices_mm;  ///< kTubeSides at the start of each piece, then as many at its end
  Points normals;      ///< unit, outwards
  Faces faces;
};

inline constexpr int kTubeSides = 6;

/// Open tubes. @param shape_of pieces in the state by which each is turned about its axis, so that
/// the same vertex stays at the same side in every state; as many as `axes`
Tubes make_tubes(const std::vector<TubeAxis>& axes, const std::vector<TubeAxis>& shape_of);

}  // namespace coapt
