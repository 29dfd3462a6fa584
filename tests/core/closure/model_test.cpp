#include "core/closure/model.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/closure/closure.h"
#include "tests/scenes/small_valve.h"

namespace coapt {
namespace {

/// Two free nodes at the origin and at x, joined by one spring of 10 mm.
ClosureModel one_spring(double length_mm, Points& x) {
  ClosureModel model;
  model.springs.push_back({0, 1, 10.0, 0.2, 0.5, 3.0});
  x.setZero(2, 3);
  x(1, 0) = length_mm;
  return model;
}

double pull(double length_mm) {
  Points x;
  const ClosureModel model = one_spring(length_mm, x);
  Points force = Points::Zero(2, 3);
  add_elastic_forces(model, x, force);
  EXPECT_DOUBLE_EQ(force(0, 0), -force(1, 0));
  return force(0, 0);
}

TEST(Spring, FollowsTheBilinearLawBelowAndAboveItsTransition) {
  EXPECT_DOUBLE_EQ(pull(10.0), 0.0);
  EXPECT_DOUBLE_EQ(pull(11.0), 0.5);        // 0.5 N/mm x 1 mm
  EXPECT_DOUBLE_EQ(pull(12.0), 1.0);        // at the transition: 20 % of 10 mm
  EXPECT_DOUBLE_EQ(pull(13.0), 1.0 + 3.0);  // 1 mm further at 3 N/mm
  EXPECT_DOUBLE_EQ(pull(9.0), -0.5);        // pushes when shorter, as equation 2.4 says
}

TEST(Spring, OfACircumferentialEdgeHasVanGeldersStiffness) {
  const Valve valve = small_valve();
  const ClosureModel model = make_closure_model(valve, Membrane::Springs);
  // Annulus edge 0-1: one face only; k = E t A / l0^2 with E between the radial and circumferential
  // ones.
  const Spring& spring = model.springs.front();
  ASSERT_EQ(spring.a, 0);
  ASSERT_EQ(spring.b, 1);
  double area = 0.0, cos2 = 0.0;
  for (int f = 0; f < valve.faces.rows(); ++f) {
    int shared = 0;
    for (int k = 0; k < 3; ++k) shared += valve.faces(f, k) == 0 || valve.faces(f, k) == 1;
    if (shared < 2) continue;
    const Vec3 a = valve.rest_mm.row(valve.faces(f, 0)), b = valve.rest_mm.row(valve.faces(f, 1)),
               c = valve.rest_mm.row(valve.faces(f, 2));
    area += 0.5 * (b - a).cross(c - a).norm();
    const Vec3 edge = (valve.rest_mm.row(1) - valve.rest_mm.row(0)).normalized();
    cos2 = std::pow(edge.dot(valve.fibre.row(f)), 2);
  }
  const double length = (valve.rest_mm.row(1) - valve.rest_mm.row(0)).norm();
  const double modulus = std::sqrt(2.3 * 2.3 * cos2 + 0.76 * 0.76 * (1.0 - cos2));  // MPa
  EXPECT_NEAR(spring.post_n_per_mm, modulus * 1.0 * area / (length * length), 1e-12);
}

TEST(Cable, PullsOnlyWhenLongerThanItsRestLength) {
  ClosureModel model;
  Cable cable;
  cable.start = 0;
  cable.end = {{1, 1.0}};
  cable.rest_mm = 10.0;
  cable.stiffness_n_per_mm = 2.0;
  model.cables.push_back(cable);
  Points x = Points::Zero(2, 3);
  for (const auto& [length, tension] : {std::pair{9.0, 0.0}, {10.0, 0.0}, {10.5, 1.0}}) {
    x(1, 2) = length;
    Points force = Points::Zero(2, 3);
    add_elastic_forces(model, x, force);
    EXPECT_DOUBLE_EQ(force(0, 2), tension);
    EXPECT_DOUBLE_EQ(tension_n(cable, x), tension);
  }
}

TEST(Cable, TwoInSeriesShareTheirStretchLikeTwoSpringsInSeries) {
  // Stiffness EA/L: 31.4159/10 and 31.4159/20 N/mm. 0.3 mm of stretch in all is 0.1 and 0.2 mm.
  ClosureModel model;
  const double ea = 40.0 * 3.14159265358979 / 4.0;
  for (int i = 0; i < 2; ++i) {
    Cable cable;
    cable.start = i;
    cable.end = {{i + 1, 1.0}};
    cable.rest_mm = 10.0 * (i + 1);
    cable.stiffness_n_per_mm = ea / cable.rest_mm;
    model.cables.push_back(cable);
  }
  Points x = Points::Zero(3, 3);
  x(1, 0) = 10.1;
  x(2, 0) = 30.3;
  Points force = Points::Zero(3, 3);
  add_elastic_forces(model, x, force);
  EXPECT_NEAR(force(1, 0), 0.0, 1e-12);
  EXPECT_NEAR(force(0, 0), ea * 0.01, 1e-12);
}

TEST(Pressure, OnAFlatSquareIsPressureTimesAreaAlongTheAtrialNormal) {
  ClosureModel model;
  model.pressure_mpa = 0.016;
  model.faces.resize(2, 3);
  model.faces << 0, 1, 2, 0, 2, 3;
  Points x(4, 3);
  x << 0, 0, 0, 10, 0, 0, 10, 10, 0, 0, 10, 0;
  Points force = Points::Zero(4, 3);
  add_pressure_forces(model, x, force);
  EXPECT_NEAR(force.col(2).sum(), 0.016 * 100.0, 1e-12);
  EXPECT_NEAR(force.leftCols(2).norm(), 0.0, 1e-15);
  EXPECT_NEAR(force(0, 2), 2.0 * 0.016 * 50.0 / 3.0, 1e-12);  // on both triangles
}

TEST(Pressure, ActsOnEachFaceWithItsShare) {
  ClosureModel model;
  model.pressure_mpa = 0.016;
  model.load_share = {0.25, 0.0};
  model.faces.resize(2, 3);
  model.faces << 0, 1, 2, 0, 2, 3;
  Points x(4, 3);
  x << 0, 0, 0, 10, 0, 0, 10, 10, 0, 0, 10, 0;
  Points force = Points::Zero(4, 3);
  add_pressure_forces(model, x, force);
  EXPECT_NEAR(force(1, 2), 0.25 * 0.016 * 50.0 / 3.0, 1e-12);
  EXPECT_EQ(force(3, 2), 0.0);
}

TEST(ElasticForces, AddUpToNothingInForceAndMoment) {
  const Valve valve = small_valve();
  const ClosureModel model = make_closure_model(valve);
  Points x = model.rest_mm;
  for (Eigen::Index i = 0; i < x.rows(); ++i)  // a smooth stretch and twist
    x.row(i) = Vec3(1.2 * x(i, 0) + 0.1 * x(i, 1), 0.9 * x(i, 1) - 0.05 * x(i, 2), 1.3 * x(i, 2));
  Points force = Points::Zero(x.rows(), 3);
  add_elastic_forces(model, x, force);
  Vec3 moment = Vec3::Zero();
  for (Eigen::Index i = 0; i < x.rows(); ++i) moment += Vec3(x.row(i)).cross(Vec3(force.row(i)));
  EXPECT_GT(force.norm(), 1.0);
  EXPECT_NEAR(force.colwise().sum().norm(), 0.0, 1e-10);
  EXPECT_NEAR(moment.norm(), 0.0, 1e-9);
}

TEST(ClosureModel, MassIsDensityTimesLeafletAndChordaeVolume) {
  const Valve valve = small_valve();
  const ClosureModel model = make_closure_model(valve);
  double area = 0.0, chordae_mm3 = 0.0, mass = 0.0;
  for (int f = 0; f < valve.faces.rows(); ++f) {
    const Vec3 a = valve.rest_mm.row(valve.faces(f, 0)), b = valve.rest_mm.row(valve.faces(f, 1)),
               c = valve.rest_mm.row(valve.faces(f, 2));
    area += 0.5 * (b - a).cross(c - a).norm();
  }
  for (const Chorda& chorda : valve.chordae)
    for (const ChordaSegment& s : chorda.segments)
      chordae_mm3 += s.rest_length_mm * 3.14159265358979 / 4.0 * s.diameter_mm * s.diameter_mm;
  for (const double m : model.mass_g) mass += m;
  EXPECT_NEAR(mass, 1.06e-3 * (area * 1.0 + chordae_mm3), 1e-9);  // 1060 kg/m3
}

}  // namespace
}  // namespace coapt
