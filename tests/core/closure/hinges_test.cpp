#include "core/closure/hinges.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <random>

#include "core/closure/model.h"
#include "core/closure/relaxation.h"
#include "tests/scenes/sheets.h"

namespace coapt {
namespace {

constexpr double kRigidity_n_mm = 0.03;

/// Two triangles that share the edge from node 0 to node 1.
Valve two_faces() {
  Valve valve;
  sheets::set_rows(valve.rest_mm, {{0, 0, 0}, {0, 2, 0}, {-1.5, 0.8, 0}, {1.7, 1.1, 0}});
  sheets::set_faces(valve, {{0, 1, 2}, {1, 0, 3}});
  return valve;
}

/// n x n cells; every second diagonal turned, or all cells leaning so that triangles are equilateral.
Valve sheet_of(int n, bool equilateral) {
  std::vector<double> lines;
  for (int i = 0; i <= n; ++i) lines.push_back(i);
  Valve valve = grid_sheet(lines, lines, [](int, int) { return false; });
  if (equilateral) {
    for (Index i = 0; i < valve.rest_mm.rows(); ++i)
      valve.rest_mm.row(i) << valve.rest_mm(i, 0) - 0.5 * valve.rest_mm(i, 1),
          0.5 * std::sqrt(3.0) * valve.rest_mm(i, 1), 0.0;
    return valve;
  }
  for (int cell = 0; cell < n * n; ++cell) {
    if ((cell + cell / n) % 2 == 0) continue;
    const int corner = cell / n * (n + 1) + cell % n;
    valve.faces.row(2 * cell) << corner, corner + 1, corner + n + 1;
    valve.faces.row(2 * cell + 1) << corner + 1, corner + n + 2, corner + n + 1;
  }
  return valve;
}

/// Energy per area of a flat sheet rolled up along a direction, over D / (2 R^2).
double cylinder_energy(const Valve& valve, double direction_deg) {
  constexpr double kRadius_mm = 40.0;
  const double angle = direction_deg * M_PI / 180.0;
  Points rolled = valve.rest_mm;
  for (Index i = 0; i < rolled.rows(); ++i) {
    const double u = std::cos(angle) * rolled(i, 0) + std::sin(angle) * rolled(i, 1);
    const double v = std::cos(angle) * rolled(i, 1) - std::sin(angle) * rolled(i, 0);
    rolled.row(i) << kRadius_mm * std::sin(u / kRadius_mm), v,
        kRadius_mm * std::cos(u / kRadius_mm);
  }
  double energy = 0.0, area_mm2 = 0.0;  // a hinge has a third of both faces
  for (const Hinge& hinge : make_hinges(valve)) {
    energy += hinge_energy(hinge, rolled);
    const double length2 =
        (valve.rest_mm.row(hinge.node[0]) - valve.rest_mm.row(hinge.node[1])).squaredNorm();
    area_mm2 += valve.tissue.bending_n_mm * length2 / hinge.stiffness_n_mm / 3.0;
  }
  return energy / area_mm2 * 2.0 * kRadius_mm * kRadius_mm / valve.tissue.bending_n_mm;
}

TEST(Hinges, OfACylinderStoreItsBendingEnergy) {
  const Valve squares = sheet_of(40, false), triangles = sheet_of(40, true);
  EXPECT_NEAR(cylinder_energy(squares, 0.0), 1.0, 0.02);
  EXPECT_NEAR(cylinder_energy(squares, 90.0), 1.0, 0.02);
  for (const double direction : {0.0, 15.0, 40.0})
    EXPECT_NEAR(cylinder_energy(triangles, direction), 1.0, 0.02) << direction;
}

TEST(Hinges, AcrossSquaresOfAlternatingDiagonalsAreHalfAsStiffAgain) {
  EXPECT_NEAR(cylinder_energy(sheet_of(40, false), 45.0), 1.5, 0.03);
}

TEST(Hinge, MakesHalfARightAngleKnownByHand) {
  // Face (1, 0, 3) stands upright on the other, away from the normal: 90 degrees, t = 4 tan 22.5.
  const Valve valve = two_faces();
  const Hinge hinge = make_hinges(valve).front();
  EXPECT_DOUBLE_EQ(hinge.rest, 0.0);
  EXPECT_NEAR(hinge.stiffness_n_mm, kRigidity_n_mm * 4.0 / (1.5 + 1.7), 1e-15);
  Points x = valve.rest_mm;
  x.row(3) << 0.0, 1.1, -1.7;
  EXPECT_NEAR(turn(hinge, x).t, 4.0 * std::tan(M_PI / 8.0), 1e-12);
  x.row(3) << 0.0, 1.1, 1.7;
  EXPECT_NEAR(turn(hinge, x).t, -4.0 * std::tan(M_PI / 8.0), 1e-12);
}

TEST(Hinge, PullsWithTheGradientOfItsEnergy) {
  Valve valve = two_faces();
  valve.rest_mm(3, 2) = -0.4;  // bent at rest
  const Hinge hinge = make_hinges(valve).front();
  std::mt19937 random(7);
  std::uniform_real_distribution<double> move(-0.4, 0.4);
  for (int draw = 0; draw < 20; ++draw) {
    Points x = valve.rest_mm;
    for (double& value : x.reshaped()) value += move(random);
    Points force = Points::Zero(4, 3);
    add_hinge_forces(hinge, x, force);
    for (Index i = 0; i < 4; ++i)
      for (Index k = 0; k < 3; ++k) {
        constexpr double kStep_mm = 1e-5;
        Points more = x, less = x;
        more(i, k) += kStep_mm;
        less(i, k) -= kStep_mm;
        EXPECT_NEAR(force(i, k),
                    (hinge_energy(hinge, less) - hinge_energy(hinge, more)) / (2.0 * kStep_mm),
                    1e-8);
      }
  }
}

TEST(Hinges, AskNothingOfARigidMotionNorOfAStretchInThePlane) {
  Valve valve = two_faces();
  Points stretched = valve.rest_mm;
  stretched.col(0) *= 1.4;
  Points force = Points::Zero(4, 3);
  add_hinge_forces(make_hinges(valve).front(), stretched, force);
  EXPECT_LT(force.norm(), 1e-15);
  valve.rest_mm(3, 2) = 0.9;
  Eigen::Isometry3d motion(Eigen::AngleAxisd(1.1, Vec3(1, 2, -1).normalized()));
  motion.pretranslate(Vec3(3, -4, 5));
  add_hinge_forces(make_hinges(valve).front(), moved(valve, motion).rest_mm, force);
  EXPECT_LT(force.norm(), 1e-14);
}

TEST(Hinges, AreNoneWithoutRigidity) {
  Valve valve = two_faces();
  valve.tissue.bending_n_mm = 0.0;
  EXPECT_TRUE(make_hinges(valve).empty());
}

TEST(Hinges, LetAStripHangUnderItsLoadLikeABeam) {
  // A cantilever of n cells of edge h under the load q: by its discrete moments the tip sinks by
  // q h^4 / (2 D) (n (n + 1) / 2)^2, in the limit of small h by q L^4 / (8 D).
  constexpr int kCells = 8;
  constexpr double kLoad_mpa = 2e-5;
  Valve valve = sheet_of(kCells + 1, false);
  valve.rest_mm.col(0).array() -= 1.0;
  valve.tissue.circumferential_pre_kpa = valve.tissue.radial_pre_kpa = 1000.0;
  valve.tissue.circumferential_post_kpa = valve.tissue.radial_post_kpa = 1000.0;
  valve.pressure_kpa = 1000.0 * kLoad_mpa;
  ClosureModel model = make_closure_model(valve);
  model.target_mm = model.rest_mm;
  for (Index i = 0; i < model.rest_mm.rows(); ++i) model.fixed[i] = model.rest_mm(i, 0) <= 0.0;
  RelaxationSettings settings;
  settings.contact.thickness_mm = 0.01;
  settings.residual_tolerance = 1e-5;
  settings.way_tolerance_mm = 1e-5;
  settings.max_steps = 400000;
  settings.damping = 0.002;
  const ClosureRun run = relax<double>(model, settings);
  ASSERT_EQ(run.status, ClosureStatus::Converged);
  const double discrete = kLoad_mpa / (2.0 * kRigidity_n_mm) * std::pow(36.0, 2);
  const double tip = run.x_mm(Eigen::seqN(kCells + 1, kCells + 2, kCells + 2), 2).mean();
  EXPECT_NEAR(tip, discrete, 0.04 * discrete);  // cells at the free edges fold along diagonals, too
}

}  // namespace
}  // namespace coapt
