// Bending of the leaflets: every inner edge of the mesh is a hinge between its two faces.
//
// The normals of the faces enclose the angle a, and the hinge answers with the moment
//   M = k (t(a) - t(a0)),  k = D l^2 / (A1 + A2),  t(a) = 4 tan(a / 4)
// with the flexural rigidity D (Tissue::bending_n_mm) and, of the unstressed shape, the edge's
// length l, the areas of the faces A1 and A2, and a0, the angle there. t is the angle within 5 % up
// to 90 degrees and finite in a fold of 180. The energy per hinge, k a^2 / 2 for small angles, has
// the weight of Seung and Nelson (1988, doi 10.1103/PhysRevA.38.1005) and not the threefold one of
// isometric bending (Bergou et al. 2006): so a cylinder of radius R stores its D / (2 R^2) per
// area, on equilateral triangles at any angle, on squares cut by diagonals along both sides. Across
// squares with alternating diagonals, at 45 degrees, it is 1.5 times that.
//
// Gradients of the angle: Bridson et al. 2003 (doi 10.2312/SCA03/028). A face that is squeezed below
// a fifth of its unstressed area counts as a fifth: its angle says little.
#pragma once

#include <array>
#include <vector>

#include "core/valve/valve.h"

namespace coapt {

struct Hinge {
  std::array<int, 4> node = {0, 0, 0, 0};  ///< of the edge two, then what it joins: see gradients()
  double stiffness_n_mm = 0.0;             ///< k
  double rest = 0.0;                       ///< t(a0)
  std::array<double, 2> least_mm4 = {0.0, 0.0};  ///< least_mm4() of both faces
};

/// Least squared cross product of two sides of a face that counts, from its rest shape.
double least_mm4(const Points& rest_mm, const Faces& faces, Index face);

/// Of all inner edges, in ascending order of their vertices; none if D is 0.
std::vector<Hinge> make_hinges(const Valve& valve);

/// t of the present angle and the angle's derivatives by the four nodes, 1/mm. The faces are
/// (0, 1, 2) and (1, 0, 3); the angle is positive where they bend away from their normals.
struct HingeTurn {
  double t = 0.0;
  std::array<Vec3, 4> gradient;
  /// At least the norms of the gradients: those of both faces added up, as if they lay flat.
  std::array<double, 4> size;
};
HingeTurn turn(const Hinge& hinge, const Points& x);

/// N mm.
double hinge_energy(const Hinge& hinge, const Points& x);

/// Adds minus the gradient of the energy, N.
void add_hinge_forces(const Hinge& hinge, const Points& x, Points& force);

/// For each node, N/mm: bounds the hinge's stiffness matrix as row_sums() does a sheet's
/// (continuum.h).
std::array<double, 4> row_sums(const Hinge& hinge, const Points& x);

}  // namespace coapt
