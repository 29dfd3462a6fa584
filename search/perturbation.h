// The region of interest around a repaired valve (thesis 4.2.3): how the papillary tips may come to
// lie after all, as the ventricle goes on remodelling or a suture is tied a little long or short.
//
// A tip sits on a sphere about its anchor. Grid: 9 suture lengths (+-1 mm in 0.25 mm) x 11 x 11
// angles (+-5 degrees in 1 degree about both axes perpendicular to the suture) = 1,089 nodes. A
// muscle without a suture swings about its ipsilateral trigone, so that every plan faces the same
// perturbations. Both muscles take the same node, mirrored: remodelling is global, both go outwards
// together; and the grid stays at 1,089 nodes instead of their square.
#pragma once

#include <vector>

#include "core/valve/types.h"

namespace coapt {

struct Perturbation {
  double length_mm = 0.0;      ///< added to the distance between tip and anchor
  double outwards_deg = 0.0;   ///< swing to the own side
  double posterior_deg = 0.0;  ///< swing backwards
};

inline constexpr double kLengthStep_mm = 0.25;

/// All 1,089 nodes, so ordered that the first n stand for all of them: the undisturbed node, then
/// pairs of opposite nodes, each the pair that brings the set's energy distance to the full grid
/// (Szekely and Rizzo 2013) lowest. An odd n keeps the mean exactly undisturbed; 5, 17 and 65 are
/// good sizes.
std::vector<Perturbation> region_of_interest();

/// Where a tip goes on, or a little off, the sphere about its anchor. @param outwards_sign 1 for
/// the posteromedial muscle, -1 for the anterolateral one: the sign of x that is outwards.
Vec3 disturbed_tip(const Vec3& tip, const Vec3& anchor, double outwards_sign,
                   const Perturbation& node);

}  // namespace coapt
