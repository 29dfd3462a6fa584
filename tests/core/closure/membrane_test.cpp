// Both membranes against what is known of them: spring meshes and inflated discs.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/closure/closure.h"
#include "core/closure/model.h"
#include "core/closure/relaxation.h"
#include "core/presets/presets.h"
#include "tests/scenes/sheets.h"

namespace coapt {
namespace {

Tissue isotropic_1_mpa() {
  Tissue tissue;
  tissue.circumferential_pre_kpa = tissue.circumferential_post_kpa = 1000.0;
  tissue.radial_pre_kpa = tissue.radial_post_kpa = 1000.0;
  tissue.bending_n_mm = 0.0;
  return tissue;
}

/// In units of E t.
struct PlaneConstants {
  double modulus = 0.0, poisson = 0.0, shear = 0.0;
};

/// Of a flat mesh of isotropic tissue: its springs' forces under a small uniform strain, by virtual
/// work.
PlaneConstants plane_constants(Valve valve) {
  valve.tissue = isotropic_1_mpa();
  const ClosureModel model = make_closure_model(valve, Membrane::Springs);
  double area = 0.0;
  for (const double a : model.area_mm2) area += a;
  constexpr double kStrain = 1e-7;
  const auto stress = [&](const Eigen::Matrix2d& strain) {
    Points x = model.rest_mm, force = Points::Zero(x.rows(), 3);
    x.leftCols<2>() += kStrain * model.rest_mm.leftCols<2>() * strain;
    add_elastic_forces(model, x, force);
    return Eigen::Matrix2d(-force.leftCols<2>().transpose() * model.rest_mm.leftCols<2>() /
                           (area * kStrain));
  };
  const Eigen::Matrix2d x = stress(Eigen::Matrix2d{{1, 0}, {0, 0}});
  const Eigen::Matrix2d y = stress(Eigen::Matrix2d{{0, 0}, {0, 1}});
  const Eigen::Matrix2d xy = stress(Eigen::Matrix2d{{0, 0.5}, {0.5, 0}});
  return {x(0, 0) - x(1, 1) * y(0, 0) / y(1, 1), x(1, 1) / y(1, 1), xy(0, 1)};
}

/// 4 x 4 cells of 1 mm by `height`; the upper row moved by `lean`. Diagonals alternate like a
/// chessboard, or not.
Valve cells(double height, double lean, bool alternate) {
  Valve valve = grid_sheet({0, 1, 2, 3, 4}, {0, 1, 2, 3, 4}, [](int, int) { return false; });
  for (Eigen::Index i = 0; i < valve.rest_mm.rows(); ++i) {
    const double row = valve.rest_mm(i, 1);
    valve.rest_mm.row(i) << valve.rest_mm(i, 0) + lean * row, height * row, 0.0;
  }
  valve.annulus_mm = valve.rest_mm(valve.annulus, Eigen::all);
  for (int cell = 0; cell < 16; ++cell) {
    if (!alternate || (cell + cell / 4) % 2 == 0) continue;
    const int corner = cell / 4 * 5 + cell % 4;
    valve.faces.row(2 * cell) << corner, corner + 1, corner + 5;
    valve.faces.row(2 * cell + 1) << corner + 1, corner + 6, corner + 5;
  }
  return valve;
}

TEST(Springs, OfVanGelderHaveTheKnownConstantsOnRegularMeshes) {
  // Grid cells have their diagonal from corner to corner: leaning by -1/2 makes them equilateral.
  const PlaneConstants equilateral = plane_constants(cells(0.5 * std::sqrt(3.0), -0.5, false));
  EXPECT_NEAR(equilateral.modulus, 1.0, 1e-6);
  EXPECT_NEAR(equilateral.poisson, 1.0 / 3.0, 1e-6);
  EXPECT_NEAR(equilateral.shear, 0.375, 1e-6);
  const PlaneConstants squares = plane_constants(cells(1.0, 0.0, true));
  EXPECT_NEAR(squares.modulus, 1.2, 1e-6);
  EXPECT_NEAR(squares.poisson, 0.2, 1e-6);
  EXPECT_NEAR(squares.shear, 0.25, 1e-6);
  const PlaneConstants rectangles = plane_constants(cells(1.5, 0.0, true));
  EXPECT_NEAR(rectangles.modulus, 1.064, 5e-4);
  EXPECT_NEAR(rectangles.poisson, 0.144, 5e-4);
  EXPECT_NEAR(rectangles.shear, 0.213, 5e-4);
}

/// A flat disc in rings of six times their number of vertices, held by its rim; fibre along the
/// radius.
Valve disc(double radius_mm, int rings) {
  std::vector<Vec3> points = {Vec3::Zero()};
  std::vector<std::array<int, 3>> faces;
  const auto number = [](int ring, int i) {
    return ring == 0 ? 0 : 1 + 3 * ring * (ring - 1) + i % (6 * ring);
  };
  for (int ring = 1; ring <= rings; ++ring)
    for (int i = 0; i < 6 * ring; ++i) {
      const double angle = std::numbers::pi * i / (3.0 * ring), r = radius_mm * ring / rings;
      points.emplace_back(r * std::cos(angle), r * std::sin(angle), 0.0);
      const int inner = i / ring * (ring - 1) + i % ring;  // the vertex inside, in the same sixth
      faces.push_back({number(ring, i), number(ring, i + 1), number(ring - 1, inner)});
      if (i % ring != ring - 1)
        faces.push_back(
            {number(ring - 1, inner), number(ring, i + 1), number(ring - 1, inner + 1)});
    }
  Valve valve;
  sheets::set_rows(valve.rest_mm, points);
  sheets::set_faces(valve, faces);
  for (Eigen::Index f = 0; f < valve.faces.rows(); ++f)
    valve.fibre.row(f) =
        valve.rest_mm(valve.faces.row(f), Eigen::all).colwise().mean().normalized();
  std::vector<int> rim;
  for (int i = 0; i < 6 * rings; ++i) rim.push_back(number(rings, i));
  sheets::set_annulus(valve, rim);
  valve.tissue = isotropic_1_mpa();
  return valve;
}

/// Height of the inflated disc over its radius; `load` is p a / (E t).
double inflated_height(double load, int rings) {
  constexpr double kRadius_mm = 15.0;
  Valve valve = disc(kRadius_mm, rings);
  valve.pressure_kpa = load * 1000.0 / kRadius_mm;
  RelaxationSettings settings;
  settings.residual_tolerance = 1e-5;
  settings.way_tolerance_mm = 1e-5;
  settings.max_steps = 100000;
  settings.contact.thickness_mm = 0.01;
  const ClosureRun run = relax<double>(make_closure_model(valve, Membrane::Continuum), settings);
  EXPECT_EQ(run.status, ClosureStatus::Converged);
  return run.x_mm(0, 2) / kRadius_mm;
}

TEST(Continuum, InflatedDiscConvergesToItsAxisymmetricSolutionAndThatIsFichters) {
  // Fichter 1997 (NASA TP-3658, nu = 1/3) takes strains as small. `exact` solves the equilibrium of
  // a meridian for this law: (r S1 cos phi)' = S2 - p R l1 sin phi, S1 sin phi = p R^2 / (2 r).
  struct Inflation {
    double load, fichter, exact;
  };
  for (const auto& [load, fichter, exact] :
       {Inflation{0.001, 0.06444, 0.0646299}, {0.01, 0.13854, 0.1404598}}) {
    const double coarse = inflated_height(load, 4) / exact - 1.0;
    const double middle = inflated_height(load, 8) / exact - 1.0;
    const double fine = inflated_height(load, 16) / exact - 1.0;
    EXPECT_LT(std::abs(middle), 0.35 * std::abs(coarse)) << load;
    EXPECT_LT(std::abs(fine), 0.35 * std::abs(middle)) << load;
    EXPECT_LT(std::abs(fine), 1e-3) << load;
    EXPECT_NEAR(exact / fichter, 1.0, 0.015) << load;
  }
}

TEST(Continuum, ClosesEveryPresetWithoutCrossing) {
  for (const std::string& name : preset_names()) {
    ClosureOptions options;
    options.membrane = Membrane::Continuum;
    const ClosureResult closed = close_valve(*make_preset(name), options);
    EXPECT_EQ(closed.status, ClosureStatus::Converged) << name;
    EXPECT_FALSE(closed.crossing) << name;
  }
}

TEST(Continuum, ComesToRestByTheThesisMethodToo) {
  ClosureOptions options;
  options.membrane = Membrane::Continuum;
  options.method = Method::Thesis;
  const Valve valve = *make_preset("human-normal", 300);
  const ClosureResult thesis = close_valve(valve, options);
  EXPECT_EQ(thesis.status, ClosureStatus::Converged);
  EXPECT_FALSE(thesis.crossing);
}

}  // namespace
}  // namespace coapt
