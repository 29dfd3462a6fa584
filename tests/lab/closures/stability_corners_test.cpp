// Where plain methods fail, the closure that everybody gets is right or says that it is not.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ostream>

#include "core/closure/contact.h"
#include "core/closure/crossing.h"
#include "core/closure/relaxation.h"
#include "core/presets/presets.h"
#include "core/valve/validate.h"
#include "lab/closures/stability_scenes.h"
#include "search/evaluator.h"

namespace coapt {
namespace {

using Pairs = std::vector<std::pair<int, int>>;

/// Whether the edge pq and the triangle have a point in common, by Cramer's rule.
bool meets(const Vec3& p, const Vec3& q, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 along = p - q, u = b - a, v = c - a, w = p - a;
  const double d = along.dot(u.cross(v));
  if (d == 0.0) return false;
  const double t = w.dot(u.cross(v)) / d, s = along.dot(w.cross(v)) / d,
               r = along.dot(u.cross(w)) / d;
  return t > 0.0 && t < 1.0 && s > 0.0 && r > 0.0 && s + r < 1.0;
}

/// Every pair of faces, every edge that shares no vertex with the other face.
Pairs brute_crossing_pairs(const Faces& faces, const Points& x) {
  const auto pierces = [&](Eigen::Index f, Eigen::Index g) {
    for (int k = 0; k < 3; ++k) {
      const int i = faces(f, k), j = faces(f, (k + 1) % 3);
      if ((faces.row(g).array() == i).any() || (faces.row(g).array() == j).any()) continue;
      if (meets(x.row(i), x.row(j), x.row(faces(g, 0)), x.row(faces(g, 1)), x.row(faces(g, 2))))
        return true;
    }
    return false;
  };
  Pairs found;
  for (Eigen::Index f = 0; f < faces.rows(); ++f)
    for (Eigen::Index g = f + 1; g < faces.rows(); ++g)
      if (pierces(f, g) || pierces(g, f))
        found.emplace_back(static_cast<int>(f), static_cast<int>(g));
  return found;
}

struct Corner {
  const char* scene;
  Difficulty axis;
  double level;
};

class StabilityCorner : public testing::TestWithParam<Corner> {};

void PrintTo(const Corner& corner, std::ostream* out) {
  *out << corner.scene << ", " << to_string(corner.axis) << ' ' << corner.level;
}

TEST_P(StabilityCorner, IsClosedRightOrReportedNotTo) {
  const Corner& corner = GetParam();
  const StabilityScene scene = make_stability_scene(corner.scene, corner.axis, corner.level);
  for (const Error& error : validate(scene.valve)) FAIL() << error.path << error.message;
  ClosureOptions options;
  options.contact_pressure_mpa *= scene.contact_stiffness;
  const ClosureResult closed = close_valve(scene.valve, options);
  const Pairs crossing = brute_crossing_pairs(scene.valve.faces, closed.closed_mm);
  EXPECT_EQ(closed.crossing_pairs, static_cast<int>(crossing.size()));
  if (!trusted(closed)) {
    EXPECT_TRUE(closed.status != ClosureStatus::Converged || closed.crossing);
    EXPECT_GE(closed.attempts.size(), 4u) << "gave up before the end of the ladder";
    return;
  }
  EXPECT_TRUE(crossing.empty());
  EXPECT_LE(closed.residual, options.residual_tolerance);
  // The annulus is where it should be, and no vertex has gone astray.
  for (std::size_t i = 0; i < scene.valve.annulus.size(); ++i)
    EXPECT_EQ(closed.closed_mm.row(scene.valve.annulus[i]),
              scene.valve.annulus_mm.row(static_cast<Eigen::Index>(i)));
  EXPECT_LT(closed.closed_mm.cwiseAbs().maxCoeff(), 50.0);
}

INSTANTIATE_TEST_SUITE_P(OfTheMap, StabilityCorner,
                         testing::Values(Corner{"human-normal", Difficulty::Slivers, 0.1},
                                         Corner{"human-normal", Difficulty::Slivers, 0.03},
                                         Corner{"human-normal", Difficulty::Slivers, 0.01},
                                         Corner{"porcine-1", Difficulty::Slivers, 0.01},
                                         Corner{"human-normal", Difficulty::Pressure, 100.0},
                                         Corner{"porcine-1", Difficulty::Pressure, 100.0},
                                         Corner{"human-normal", Difficulty::ChordaeModulus, 30.0},
                                         Corner{"human-normal", Difficulty::ChordaeModulus, 100.0},
                                         Corner{"human-normal", Difficulty::ContactStiffness,
                                                100.0},
                                         Corner{"human-normal", Difficulty::ContactStiffness, 0.1},
                                         Corner{"human-normal", Difficulty::Tips, 12.0},
                                         Corner{"porcine-1", Difficulty::Dilation, 40.0},
                                         Corner{kCommissures, Difficulty::Step, 1.0},
                                         Corner{kCommissures, Difficulty::Pressure, 100.0},
                                         Corner{kCommissures, Difficulty::Tips, 12.0}));

TEST(StabilityCommissures, CrossWithVertexFaceContactAloneAndNotInTheEnd) {
  const Valve valve = make_stability_scene(kCommissures, Difficulty::Step, 1.0).valve;
  const ClosureModel model = make_closure_model(valve, Membrane::Springs);
  RelaxationSettings settings;
  settings.guards = false;
  const ClosureRun attempt = relax<float>(model, settings);
  ASSERT_EQ(attempt.status, ClosureStatus::Converged);
  const Pairs found = crossing_pairs(model.faces, attempt.x_mm);
  EXPECT_FALSE(found.empty());
  EXPECT_EQ(found, brute_crossing_pairs(model.faces, attempt.x_mm));
  // All of them beside a commissure, where the orifice shows nothing.
  const Vec3 left = annulus_position_mm(valve, valve.landmarks.anterolateral_commissure),
             right = annulus_position_mm(valve, valve.landmarks.posteromedial_commissure);
  for (const auto& [f, g] : found) {
    const Vec3 at = attempt.x_mm.row(model.faces(f, 0));
    EXPECT_LT(std::min((at - left).norm(), (at - right).norm()), 15.0) << at.transpose();
  }
  const ClosureResult closed = close_valve(valve);
  EXPECT_TRUE(trusted(closed));
  EXPECT_TRUE(brute_crossing_pairs(valve.faces, closed.closed_mm).empty());
}

TEST(Slivers, AreAsShortAsAskedForAndMoveFourVerticesThatCarryNothing) {
  const Valve valve = *make_preset("porcine-1");
  const auto shortest = [](const Valve& of) {
    double least = 1e9;
    for (Eigen::Index f = 0; f < of.faces.rows(); ++f)
      for (int k = 0; k < 3; ++k)
        least = std::min(
            least,
            (of.rest_mm.row(of.faces(f, k)) - of.rest_mm.row(of.faces(f, (k + 1) % 3))).norm());
    return least;
  };
  const Valve changed = with_slivers(valve, 0.1);
  const Points moved = changed.rest_mm - valve.rest_mm;
  EXPECT_EQ((moved.rowwise().norm().array() > 0.0).count(), 4);
  EXPECT_LT(shortest(changed), 0.3);
  EXPECT_NEAR(shortest(with_slivers(valve, 0.05)), 0.5 * shortest(changed), 1e-9);
  EXPECT_EQ((with_slivers(valve, 1.0).rest_mm - valve.rest_mm).norm(), 0.0);
  for (const Chorda& chorda : valve.chordae)
    for (const ChordaSegment& segment : chorda.segments)
      if (segment.inserts) {
        EXPECT_EQ(position(segment.insertion, valve.faces, valve.rest_mm),
                  position(segment.insertion, changed.faces, changed.rest_mm));
      }
}

}  // namespace
}  // namespace coapt
