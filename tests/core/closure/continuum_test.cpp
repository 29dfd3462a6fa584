#include "core/closure/continuum.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/scenes/sheets.h"
#include "tests/scenes/small_valve.h"

namespace coapt {
namespace {

struct Patch {
  SheetLaw law;
  std::vector<Sheet> sheets;
  Points rest_mm;

  explicit Patch(const Valve& valve)
      : law(sheet_law(valve.tissue)), sheets(make_sheets(valve)), rest_mm(valve.rest_mm) {}

  double energy(const Points& x) const {
    double sum = 0.0;
    for (const Sheet& sheet : sheets) sum += sheet_energy(law, sheet, x);
    return sum;
  }
  Points force(const Points& x) const {
    Points sum = Points::Zero(x.rows(), 3);
    for (const Sheet& sheet : sheets) add_sheet_forces(law, sheet, x, sum);
    return sum;
  }
};

/// From slack to far beyond transition, with shear, bending and differences from face to face.
Points deformed(const Points& rest, double stretch) {
  Points x = rest;
  for (Eigen::Index i = 0; i < x.rows(); ++i) {
    const Vec3 p = rest.row(i);
    x.row(i) = Vec3(stretch * p.x() + 0.1 * p.y(), stretch * p.y() + 0.02 * p.x() * p.z(),
                    (1.1 * stretch + 0.01 * p.x()) * p.z() + std::sin(p.x() + 2.0 * p.y()));
  }
  return x;
}

/// A flat square of 10 mm, 1 mm thick, fibre at an angle to x, of the tissue of table 2.1.
Valve square(double fibre_angle = 0.0) {
  const std::vector<double> lines = {0.0, 4.0, 10.0};
  Valve valve = grid_sheet(lines, lines, [](int, int) { return false; });
  for (Eigen::Index f = 0; f < valve.fibre.rows(); ++f)
    valve.fibre.row(f) << std::cos(fibre_angle), std::sin(fibre_angle), 0.0;
  return valve;
}

Tissue isotropic(double kpa) {
  Tissue tissue;
  tissue.circumferential_pre_kpa = tissue.circumferential_post_kpa = kpa;
  tissue.radial_pre_kpa = tissue.radial_post_kpa = kpa;
  return tissue;
}

/// Nominal stress, MPa, of the square under the deformation gradient F: column j is the traction on
/// the side whose normal is axis j. By virtual work of the nodal forces.
Eigen::Matrix2d stress(const Valve& valve, const Eigen::Matrix2d& gradient) {
  const Patch membrane(valve);
  Points x = membrane.rest_mm;
  x.leftCols<2>() = (membrane.rest_mm.leftCols<2>() * gradient.transpose()).eval();
  const Points force = membrane.force(x);
  return -force.leftCols<2>().transpose() * membrane.rest_mm.leftCols<2>() / 100.0;
}

TEST(Continuum, ForceIsMinusTheGradientOfTheEnergy) {
  const Patch membrane(small_valve());
  for (const double stretch : {0.3, 0.5, 0.8, 1.1, 1.3, 1.7}) {
    Points x = deformed(membrane.rest_mm, stretch);
    const Points force = membrane.force(x);
    constexpr double kStep = 1e-5;
    for (Eigen::Index i = 0; i < x.size(); ++i) {
      const double at = x.data()[i];
      x.data()[i] = at + kStep;
      const double more = membrane.energy(x);
      x.data()[i] = at - kStep;
      const double less = membrane.energy(x);
      x.data()[i] = at;
      EXPECT_NEAR(force.data()[i], (less - more) / (2.0 * kStep), 1e-6 * force.norm()) << stretch;
    }
  }
}

TEST(Continuum, MovedAsAWholeKeepsStillAndStretchedAddsUpToNothing) {
  const Patch membrane(small_valve());
  const Eigen::AngleAxisd turn(2.0, Vec3(1, -2, 3).normalized());
  Points moved = membrane.rest_mm * turn.toRotationMatrix().transpose();
  moved.rowwise() += Eigen::RowVector3d(5, -7, 11);
  EXPECT_NEAR(membrane.energy(moved), 0.0, 1e-20);
  EXPECT_NEAR(membrane.force(moved).norm(), 0.0, 1e-12);
  const Points x = deformed(membrane.rest_mm, 1.4), force = membrane.force(x);
  Vec3 moment = Vec3::Zero();
  for (Eigen::Index i = 0; i < x.rows(); ++i) moment += Vec3(x.row(i)).cross(Vec3(force.row(i)));
  EXPECT_GT(force.norm(), 1.0);
  EXPECT_NEAR(force.colwise().sum().norm(), 0.0, 1e-11);
  EXPECT_NEAR(moment.norm(), 0.0, 1e-10);
}

TEST(Continuum, StripFollowsTheBilinearLawOfTheThesisAndContractsByPoisson) {
  // Uniaxial: the other direction contracts by nu sqrt(E1 / E2) e, which leaves it without stress.
  const double ratio = std::sqrt(11.0 / 3.3) / 3.0;
  for (const auto& [strain, mpa] : {std::pair{-0.05, -0.00055},
                                    {0.10, 0.0011},
                                    {0.13, 0.00143},
                                    {0.20, 0.00143 + 2.3 * 0.07},
                                    {0.30, 0.00143 + 2.3 * 0.17}}) {
    Eigen::Matrix2d along = Eigen::Vector2d(1.0 + strain, 1.0 - ratio * strain).asDiagonal();
    EXPECT_NEAR((stress(square(), along) - Eigen::Matrix2d{{mpa, 0}, {0, 0}}).norm(), 0.0, 1e-12);
  }
  for (const auto& [strain, mpa] :
       {std::pair{0.20, 0.00066}, {0.33, 0.001089}, {0.50, 0.001089 + 0.76 * 0.17}}) {
    Eigen::Matrix2d across =
        Eigen::Vector2d(1.0 - strain / (9.0 * ratio), 1.0 + strain).asDiagonal();
    EXPECT_NEAR((stress(square(), across) - Eigen::Matrix2d{{0, 0}, {0, mpa}}).norm(), 0.0, 1e-12);
  }
}

TEST(Continuum, ShearedByATenthPullsAsWorkedOutByHand) {
  // f1 = (1, 0), f2 = (.1, 1): all fibres slack. G = sqrt(.011 x .0033) x 3/8 = .00225936 MPa;
  // across: 9/8 x .0033 (|f2| - 1) = .0037125 x .00498756, times .1 / |f2| along x.
  const Eigen::Matrix2d sheared = stress(square(), Eigen::Matrix2d{{1.0, 0.1}, {0.0, 1.0}});
  EXPECT_NEAR(sheared(0, 1), 2.259356e-4 + 1.8424e-6, 1e-10);
  EXPECT_NEAR(stress(square(), Eigen::Matrix2d{{1.0, 1e-6}, {0.0, 1.0}})(0, 1), 2.259356e-9, 1e-14);
}

TEST(Continuum, StretchedByAHalfBothWaysPullsWithAllItsFibres) {
  // Diagonals: (1.712834 - .008121) / 2 = .852357 MPa above .250799; each gives half to either
  // axis.
  const double diagonals = 0.852357 * (0.5 - 0.250799);
  const double coupling = 9.0 / 8.0 / 3.0 * 0.006024948;
  const Eigen::Matrix2d pulled = stress(square(), 1.5 * Eigen::Matrix2d::Identity());
  EXPECT_NEAR(pulled(0, 0), 0.5 * (1.125 * 0.011 + coupling) + 2.289 * 0.37 + diagonals, 1e-6);
  EXPECT_NEAR(pulled(1, 1), 0.5 * (1.125 * 0.0033 + coupling) + 0.7567 * 0.17 + diagonals, 1e-6);
}

TEST(Continuum, SqueezedBelowTwoFifthsOfItsAreaPushesBack) {
  // A quarter is left, 3 MPa x (0.4 - 0.25) = 0.45 MPa per area, half of it on each side.
  const double coupling = 9.0 / 8.0 / 3.0 * 0.006024948;
  const Eigen::Matrix2d squeezed = stress(square(), 0.5 * Eigen::Matrix2d::Identity());
  EXPECT_NEAR(squeezed(0, 0), -0.5 * (1.125 * 0.011 + coupling) - 0.225, 1e-6);
  EXPECT_NEAR(squeezed(1, 1), -0.5 * (1.125 * 0.0033 + coupling) - 0.225, 1e-6);
  // However long: of a strip twice as long and a quarter as wide, half is left.
  const Eigen::Matrix2d strip = Eigen::Vector2d(2.0, 0.25).asDiagonal();
  EXPECT_GT(stress(square(), strip)(1, 1), -0.01);
}

TEST(Continuum, OfEqualModuliIsThePlaneStressMembraneWhateverTheFibre) {
  // E 1 MPa, nu 1/3: stress = E / (1 - nu^2) (e1 + nu e2), G = 3/8.
  for (const double angle : {0.0, 0.5, 1.2}) {
    Valve valve = square(angle);
    valve.tissue = isotropic(1000.0);
    constexpr double kStrain = 1e-7;
    const Eigen::Matrix2d small = Eigen::Matrix2d{{3.0, 1.0}, {0.0, -2.0}} * kStrain;
    const Eigen::Matrix2d pull = stress(valve, Eigen::Matrix2d::Identity() + small) / kStrain;
    EXPECT_NEAR(pull(0, 0), 9.0 / 8.0 * (3.0 - 2.0 / 3.0), 1e-5) << angle;
    EXPECT_NEAR(pull(1, 1), 9.0 / 8.0 * (-2.0 + 3.0 / 3.0), 1e-5) << angle;
    EXPECT_NEAR(pull(0, 1), 3.0 / 8.0, 1e-5) << angle;
  }
}

/// Of a symmetric matrix whose eigenvalues are above -1, by power iteration on it and the identity:
/// an eigensolver takes minutes to compile with the sanitizers.
double largest_eigenvalue(const Eigen::MatrixXd& matrix) {
  Eigen::VectorXd v = Eigen::VectorXd::LinSpaced(matrix.rows(), 1.0, 2.0), image = v;
  for (int i = 0; i < 3000; ++i) {
    v = image / image.norm();
    image = v;
    for (Eigen::Index j = 0; j < v.size(); ++j) image += v(j) * matrix.col(j);
  }
  return v.dot(image) - 1.0;
}

TEST(Continuum, StiffnessIsBelowItsRowSumsAndNotFarBelow) {
  const Patch membrane(small_valve());
  // Squeezed faces push in one direction alone, and the bound adds up two.
  for (const auto& [stretch, least] : {std::pair{0.3, 0.2},
                                       {0.45, 0.2},
                                       {0.6, 0.4},
                                       {1.0, 0.4},
                                       {1.2, 0.4},
                                       {1.4, 0.4},
                                       {2.0, 0.4}}) {
    const Points x = deformed(membrane.rest_mm, stretch);
    Eigen::VectorXd bound = Eigen::VectorXd::Zero(x.size());
    for (const Sheet& sheet : membrane.sheets) {
      const auto sums = row_sums(membrane.law, sheet, x);
      for (std::size_t k = 0; k < 3; ++k) bound.segment<3>(3 * sheet.node[k]).array() += sums[k];
    }
    Eigen::MatrixXd scaled(x.size(), x.size());
    constexpr double kStep = 1e-6;
    for (Eigen::Index i = 0; i < x.size(); ++i) {
      Points more = x, less = x;
      more.data()[i] += kStep;
      less.data()[i] -= kStep;
      const Points slope = (membrane.force(less) - membrane.force(more)) / (2.0 * kStep);
      for (Eigen::Index j = 0; j < x.size(); ++j)
        scaled(j, i) = slope.data()[j] / std::sqrt(bound(j) * bound(i));
    }
    const double largest = largest_eigenvalue(scaled);
    EXPECT_LE(largest, 1.0) << stretch;
    EXPECT_GT(largest, least) << stretch;
  }
}

}  // namespace
}  // namespace coapt
