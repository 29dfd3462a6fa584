// Both comparators on models so small that their rest is known by hand.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "core/closure/crossing.h"
#include "core/closure/thesis.h"
#include "core/presets/presets.h"
#include "lab/comparators/newton.h"
#include "lab/comparators/xpbd.h"

namespace coapt::comparators {
namespace {

struct Comparator {
  const char* name;
  std::function<ClosureRun(const ClosureModel&, double tolerance, int max_steps)> close;
};

std::vector<Comparator> comparators(const ContactLaw& contact = {}) {
  return {{"newton",
           [contact](const ClosureModel& model, double tolerance, int max_steps) {
             NewtonSettings settings;
             settings.residual_tolerance = tolerance;
             settings.max_steps = max_steps;
             settings.contact = contact;
             return run_newton(model, settings);
           }},
          {"xpbd", [contact](const ClosureModel& model, double tolerance, int max_steps) {
             XpbdSettings settings;
             settings.residual_tolerance = tolerance;
             settings.max_steps = max_steps;
             settings.contact = contact;
             return run_xpbd(model, settings);
           }}};
}

/// Nodes without forces; those of `fixed` stay.
ClosureModel model_of(const std::vector<Vec3>& points, const std::vector<int>& fixed) {
  ClosureModel model;
  model.vertices = static_cast<int>(points.size());
  model.rest_mm.resize(model.vertices, 3);
  for (int i = 0; i < model.vertices; ++i)
    model.rest_mm.row(i) = points[static_cast<std::size_t>(i)];
  model.target_mm = model.rest_mm;
  model.fixed.assign(points.size(), false);
  for (const int i : fixed) model.fixed[static_cast<std::size_t>(i)] = true;
  model.mass_g.assign(points.size(), 1e-3);
  model.area_mm2.assign(points.size(), 0.0);
  model.faces.resize(0, 3);
  return model;
}

Spring linear(int a, int b, double rest_mm, double n_per_mm) {
  return {a, b, rest_mm, 10.0, n_per_mm, n_per_mm};
}

TEST(Comparators, ShareAStretchBetweenTwoSpringsInSeries) {
  // 24 mm between the ends. Left: 0.1 N/mm up to 11 mm, 2 N/mm above; right: 1 N/mm from 10 mm.
  // 0.1 + 2 (l - 11) = 24 - l - 10, so l = 35.9 / 3.
  ClosureModel model = model_of({{0, 0, 0}, {10, 0, 0}, {20, 0, 0}}, {0, 2});
  model.target_mm(2, 0) = 24.0;
  model.springs = {{0, 1, 10.0, 0.1, 0.1, 2.0}, linear(1, 2, 10.0, 1.0)};
  for (const Comparator& comparator : comparators()) {
    const ClosureRun run = comparator.close(model, 1e-3, 20000);
    EXPECT_EQ(run.status, ClosureStatus::Converged) << comparator.name;
    EXPECT_NEAR(run.x_mm(1, 0), 35.9 / 3.0, 1e-3) << comparator.name;
    EXPECT_EQ(run.x_mm(2, 0), 24.0) << comparator.name;
  }
}

TEST(Comparators, LeaveASlackChordaOutAndHangOnATautOne) {
  // A spring of 1 N/mm pulls down to z = -10; above, one chorda is taut beyond 4 mm with 3 N/mm, one is
  // slack up to 20 mm. 3 (10 - h - 4) = h - 0 - 5 at height h over the spring's foot: h = 23 / 4.
  ClosureModel model = model_of({{0, 0, 0}, {0, 0, 5}, {0, 0, 10}}, {0, 2});
  model.springs = {linear(0, 1, 5.0, 1.0)};
  const auto cable = [](double rest_mm) {
    Cable made;
    made.start = 2;
    made.end = {{1, 1.0}};
    made.rest_mm = rest_mm;
    made.stiffness_n_per_mm = 3.0;
    return made;
  };
  model.cables = {cable(4.0), cable(20.0)};
  for (const Comparator& comparator : comparators()) {
    const ClosureRun run = comparator.close(model, 1e-3, 20000);
    EXPECT_EQ(run.status, ClosureStatus::Converged) << comparator.name;
    EXPECT_NEAR(run.x_mm(1, 2), 23.0 / 4.0, 1e-3) << comparator.name;
  }
}

TEST(Comparators, LiftTheMiddleOfAPressurisedSquareStraightUp) {
  // Edge 10 mm, four spokes of 0.5 N/mm, 0.01 MPa: a third of the load on 100 mm2 goes to the middle.
  ClosureModel model =
      model_of({{-5, -5, 0}, {5, -5, 0}, {5, 5, 0}, {-5, 5, 0}, {0, 0, 0}}, {0, 1, 2, 3});
  model.faces.resize(4, 3);
  model.faces << 0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4;
  model.pressure_mpa = 0.01;
  const double spoke = std::sqrt(50.0), load = 0.01 * 100.0 / 3.0;
  for (int i = 0; i < 4; ++i) model.springs.push_back(linear(i, 4, spoke, 0.5));
  double low = 0.0, high = 10.0;  // bisection of 4 T(l) z / l = load
  for (int i = 0; i < 60; ++i) {
    const double z = 0.5 * (low + high), l = std::sqrt(50.0 + z * z);
    (4.0 * 0.5 * (l - spoke) * z / l < load ? low : high) = z;
  }
  for (const Comparator& comparator : comparators()) {
    const ClosureRun run = comparator.close(model, 1e-3, 20000);
    EXPECT_EQ(run.status, ClosureStatus::Converged) << comparator.name;
    // xpbd takes the spokes in turn, which leaves it a little aside.
    EXPECT_LT(run.x_mm.row(4).head<2>().norm(), 1e-3) << comparator.name;
    EXPECT_NEAR(run.x_mm(4, 2), low, 2e-3) << comparator.name;
  }
}

TEST(Comparators, PressAVertexOnATriangleUntilContactBalancesTheSpring) {
  // Contact 0.74 x 2 mm2 x (1 - d)^2; a spring of 0.148 N/mm, 8 mm at rest, from 10 mm below the
  // triangle: both are 0.37 N at d = 0.5 mm.
  ClosureModel model =
      model_of({{-5, -5, 0}, {5, -5, 0}, {0, 5, 0}, {0, 0, 5}, {0, 0, -10}}, {0, 1, 2, 4});
  model.faces.resize(1, 3);
  model.faces << 0, 1, 2;
  model.vertices = 4;
  model.area_mm2 = {10.0, 10.0, 10.0, 2.0};
  model.springs = {linear(3, 4, 8.0, 0.148)};
  for (const Comparator& comparator : comparators({1.0, 0.74, false})) {
    const ClosureRun run = comparator.close(model, 1e-4, 20000);
    EXPECT_EQ(run.status, ClosureStatus::Converged) << comparator.name;
    EXPECT_NEAR(run.x_mm(3, 2), 0.5, 1e-3) << comparator.name;
  }
}

/// What the comparators know: springs that bend freely.
ClosureModel spring_model() {
  Valve valve = *make_preset("porcine-thesis", 300);
  valve.tissue.bending_n_mm = 0.0;
  return make_closure_model(valve, Membrane::Springs);
}

TEST(Comparators, CloseAValveWhereTheThesisDoes) {
  const ClosureModel model = spring_model();
  ThesisSettings settings;
  settings.residual_tolerance = 0.01;
  const ClosureRun thesis = run_thesis(model, settings);
  for (const Comparator& comparator : comparators()) {
    const ClosureRun run = comparator.close(model, 0.01, 6000);
    EXPECT_EQ(run.status, ClosureStatus::Converged) << comparator.name;
    EXPECT_TRUE(crossing_pairs(model.faces, run.x_mm).empty()) << comparator.name;
    // Slack tissue may come to rest elsewhere.
    const Points apart = run.samples_mm.front() - thesis.samples_mm.front();
    EXPECT_LT(std::sqrt(apart.squaredNorm() / model.vertices), 1.0) << comparator.name;
  }
}

TEST(Comparators, SayWhenTheyRunOutOfStepsOrLoseANode) {
  const ClosureModel model = spring_model();
  for (const Comparator& comparator : comparators())
    EXPECT_EQ(comparator.close(model, 0.01, 30).status, ClosureStatus::StepLimit)
        << comparator.name;
  const ContactLaw overflowing{1.0, std::numeric_limits<double>::max(), false};
  for (const Comparator& comparator : comparators(overflowing))
    EXPECT_EQ(comparator.close(model, 0.01, 1000).status, ClosureStatus::Diverged)
        << comparator.name;
}

}  // namespace
}  // namespace coapt::comparators
