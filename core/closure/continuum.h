// Membrane `continuum`: constant-strain triangles of an orthotropic hyperelastic tissue. What
// springs make of a material depends on the mesh; this one converges to it under refinement.
//
// f1 and f2 are the images of the unit vectors along and across the fibre in the unstressed face.
// Strains: e1 = |f1| - 1, e2 = |f2| - 1, shear g = f1 . f2, e+ = |f1 + f2| / sqrt 2 - 1 and
// e- = |f1 - f2| / sqrt 2 - 1 along the diagonals. Energy per unstressed volume:
//   (E1 e1^2 + 2 nu sqrt(E1 E2) e1 e2 + E2 e2^2) / (2 (1 - nu^2)) + G g^2 / 2
//   + sum over k = 1, 2, +, - of D_k max(0, e_k - t_k)^2 / 2 + B max(0, J0 - J)^2 / 2
// First line, a matrix: plane stress with the moduli before transition (table 2.1 of the thesis),
// nu = 1/3 and G = sqrt(E1 E2) / (2 (1 + nu)) (Huber 1923), as van Gelder's springs have on
// equilateral triangles. It takes compression, like the springs. Second line, fibres that are slack
// until their transition: along the axes D = E_post - E_pre; along the diagonals half of that, with
// moduli and transition of 45 degrees by equation 2.3. These weights, 1, 1, 1/2, 1/2, are those of
// van Gelder's springs on squares with alternating diagonals. Last term: what a face does that is
// squeezed below J0 of its unstressed area, J = |f1 x f2|. Tissue keeps its volume (May-Newman and
// Yin 1998), so it would be 1 / J times as thick; the matrix knows no area and lets a pull of 0.01
// MPa make a face a line, at which hinges have no direction and nothing comes to rest.
//
// So a strip along or across the fibre follows equation 2.4 to the letter until its diagonals are
// straight too (above strains of 0.5 with table 2.1), and equal moduli before and after transition
// are the isotropic membrane E, nu at small strain. Once all fibres are straight, equal moduli
// along and across give 1.2 E_post in a strip, E_post / (1 - nu) in equibiaxial tension and G =
// E_post / 4; table 2.1 gives 1.12 E_post along and 1.48 E_post across.
//
// A Fung-type law (May-Newman and Yin 1998, exponential in the strains) stiffens gradually, and
// strain in one direction stiffens all others. Here each direction stiffens at once, and all of
// them only through the diagonals; what is left out is the curved toe between the two moduli.
#pragma once

#include <array>
#include <vector>

#include "core/valve/valve.h"

namespace coapt {

inline constexpr double kMpaPerKpa = 1e-3;
inline constexpr double kMatrixPoisson = 1.0 / 3.0;
/// J of faces that have less.
inline constexpr double kLeastAreaStretch = 0.01;

/// Parallel fibres: slack up to the stretch `straight`, linear in engineering strain above.
struct Fibres {
  double straight = 1.0;
  double mpa = 0.0;  ///< D above; negative for tissue that softens
};

/// Moduli of the energy above.
struct SheetLaw {
  double along_mpa = 0.0, across_mpa = 0.0;  ///< E / (1 - nu^2)
  double coupling_mpa = 0.0;                 ///< nu sqrt(E1 E2) / (1 - nu^2)
  double shear_mpa = 0.0;
  Fibres along, across, diagonal;
  double squeezed_mpa = 3.0;   ///< B
  double squeezed_area = 0.4;  ///< J0: ordinary closures have hardly a face below
};

/// One face. (f1 f2) = (x1 - x0, x2 - x0) per_mm.
struct Sheet {
  std::array<int, 3> node = {0, 0, 0};
  Eigen::Matrix2d per_mm = Eigen::Matrix2d::Zero();
  double volume_mm3 = 0.0;  ///< unstressed
};

SheetLaw sheet_law(const Tissue& tissue);

/// One per face, in their order. `fibre` |F| x 3: its part in the face's plane counts.
std::vector<Sheet> make_sheets(const Valve& valve);

/// N mm.
double sheet_energy(const SheetLaw& law, const Sheet& sheet, const Points& x);

/// Adds minus the gradient of the energy, N.
void add_sheet_forces(const SheetLaw& law, const Sheet& sheet, const Points& x, Points& force);

/// For each corner, N/mm: the sum of these over its faces bounds the stiffness matrix K of the
/// membrane from above: v . K v <= sum over nodes of it |v|^2 (rows of Gershgorin, for blocks).
std::array<double, 3> row_sums(const SheetLaw& law, const Sheet& sheet, const Points& x);

/// The same at small strain with all fibres straight: the stiffest that the tissue becomes in a
/// valve.
std::array<double, 3> stiffest_row_sums(const SheetLaw& law, const Sheet& sheet);

}  // namespace coapt
