// Membrane of leaflets with an exponential tissue (leaflets.h): constant-strain triangles of an
// isotropic, incompressible sheet in plane stress.
//
// f1 and f2 are the images of two orthogonal unit vectors of the unstressed face, as in continuum.h.
// The thickness gives way until nothing pulls across it, so that lambda_3 = 1 / |f1 x f2| and
//   I1 = |f1|^2 + |f2|^2 + 1 / |f1 x f2|^2.
// W grows by c0 / 2 + c1 c2 (I1 - 3) exp(c2 (I1 - 3)^2) =: W' for each unit of I1, and the forces
// are W' times the gradient of I1. Cauchy stress along a principal direction: 2 W' (lambda^2 -
// lambda_3^2).
//
// Incompressible, although the material subroutine that Mathur 2022 hands to Abaqus has a soft
// volumetric part (2/D = 0.1 MPa): in the frames of the Texas TriValve, V11 V22 V33 = 1.000 and the
// stresses follow the line above within 1 % where strains are printed in principal axes
// (docs/researcher/texas-trivalve.md).
//
// Where c2 (I1 - 3)^2 exceeds kSteepest, W' goes on along its tangent: five times the largest
// stress in a closed valve, and numbers stay finite on the way there.
#pragma once

#include <array>

#include "core/closure/continuum.h"
#include "core/valve/leaflets.h"

namespace coapt {

struct ExponentialLaw {
  double c0_mpa = 0.0, c1_mpa = 0.0, c2 = 1.0;
};

/// One face; per_mm is that of any two orthogonal directions of it.
struct ExponentialSheet {
  Sheet sheet;
  ExponentialLaw law;
};

/// Above, exp(c2 (I1 - 3)^2) is left along its tangent.
inline constexpr double kSteepest = 6.0;

/// Smallest (present area / unstressed area)^2 that counts: a face that is turned inside out on the
/// way still has a finite force.
inline constexpr double kLeastAreaStretch2 = 0.02;

ExponentialLaw exponential_law(const ExponentialTissue& tissue);

/// W' and W'' by I1, at I1 - 3 = `over`, MPa.
struct ExponentialSlope {
  double first = 0.0, second = 0.0;
};
ExponentialSlope slope(const ExponentialLaw& law, double over);

/// N mm.
double sheet_energy(const ExponentialSheet& sheet, const Points& x);

/// Adds minus the gradient of the energy, N.
void add_sheet_forces(const ExponentialSheet& sheet, const Points& x, Points& force);

/// As row_sums of continuum.h, N/mm.
std::array<double, 3> row_sums(const ExponentialSheet& sheet, const Points& x);

/// Its bound at small strain but with the stiffest W'' (at kSteepest).
std::array<double, 3> stiffest_row_sums(const ExponentialSheet& sheet);

}  // namespace coapt
