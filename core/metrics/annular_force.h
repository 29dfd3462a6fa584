// What the tissue of a closed valve pulls at its annulus with, and so at the sutures of a ring.
//
// Of a valve at rest every force that the supports do not take is in balance: the pressure on the leaflets is taken by annulus and
// papillary muscles. The pull at an annulus vertex is what membrane, bending, chordae and pressure do to it. Left out: contact of leaflets
// at the annulus itself, and what it takes to draw the annulus itself onto a ring (no stiffness of the muscle behind it is modelled).
#pragma once

#include <vector>

#include "core/closure/closure_result.h"
#include "core/valve/valve.h"

namespace coapt {

struct SupportForces {
  std::vector<Vec3> annulus_n;      ///< |A|, order of Valve::annulus: on what holds it
  Vec3 papillary_n = Vec3::Zero();  ///< on all muscles
  Vec3 pressure_n = Vec3::Zero();   ///< on all leaflets; annulus and muscles take it
};

/// @pre the closure is one of this valve and converged.
SupportForces support_forces(const Valve& valve, const ClosureResult& closure);

/// Pull on each of `count` sutures, evenly placed along the annulus from the saddle peak on: what lies between two is borne by both,
/// the nearer one more. |count|.
std::vector<Vec3> suture_pulls_n(const Valve& valve, const std::vector<Vec3>& annulus_n, int count);

/// The largest pull of a suture and their mean, N.
struct SutureLoad {
  double max_n = 0.0, mean_n = 0.0;
  double out_of_plane_n = 0.0;  ///< the largest part of a pull along the annulus's normal
};
SutureLoad suture_load(const Valve& valve, const ClosureResult& closure, int count);

}  // namespace coapt
