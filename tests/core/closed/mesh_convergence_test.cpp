#include "core/closed/mesh_convergence.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/closure/refined_start.h"
#include "core/presets/presets.h"
#include "core/valve/refine.h"
#include "core/valve/remodel.h"
#include "tests/scenes/small_preset.h"

namespace coapt {
namespace {

// A leaking valve on a mesh that closes in milliseconds.
Valve leaking() { return shared_preset("human-functional-mr", 150); }

double rms_mm(const Points& a, const Points& b) {
  return std::sqrt((a - b).squaredNorm() / static_cast<double>(a.rows()));
}

TEST(MeshLimit, OfThreeMeshesIsRichardsonsWithTheObservedOrder) {
  // 10 + 8 h: order 1, limit 10; Roache's factor of 1.25 on the remaining 2.
  const MeshLimit first = mesh_limit({18.0, 14.0, 12.0});
  EXPECT_NEAR(first.order, 1.0, 1e-12);
  EXPECT_NEAR(first.leak_mm2, 10.0, 1e-12);
  EXPECT_NEAR(first.error_mm2, 2.5, 1e-12);
  EXPECT_TRUE(first.monotonous);
  // 10 + 16 h^2.
  const MeshLimit second = mesh_limit({26.0, 14.0, 11.0});
  EXPECT_NEAR(second.order, 2.0, 1e-12);
  EXPECT_NEAR(second.leak_mm2, 10.0, 1e-12);
  EXPECT_NEAR(second.error_mm2, 1.25, 1e-12);
}

TEST(MeshLimit, BelievesNoOrderAboveTwoOrBelowOneHalf) {
  EXPECT_NEAR(mesh_limit({26.0, 10.0, 9.0}).order, 4.0, 1e-12);
  EXPECT_NEAR(mesh_limit({26.0, 10.0, 9.0}).leak_mm2, 9.0 - 1.0 / 3.0, 1e-12);
  const MeshLimit slow = mesh_limit({12.0, 11.0, 10.1});  // 0.9 / (sqrt 2 - 1) remain at most
  EXPECT_EQ(slow.leak_mm2, 10.1) << "nothing is extrapolated";
  EXPECT_NEAR(slow.error_mm2, 1.25 * 0.9 / (std::sqrt(2.0) - 1.0), 1e-12);
}

TEST(MeshLimit, ASequenceThatSwingsOrGrowsHasNoOrderAndItsLargerChangeAsError) {
  for (const std::vector<double>& leaks :
       {std::vector{10.0, 13.0, 12.0}, std::vector{10.0, 9.0, 12.0},
        std::vector{9.0, 10.0, 13.0}}) {
    const MeshLimit limit = mesh_limit(leaks);
    EXPECT_TRUE(std::isnan(limit.order));
    EXPECT_FALSE(limit.monotonous);
    EXPECT_EQ(limit.leak_mm2, leaks.back());
    EXPECT_EQ(limit.error_mm2, 3.0);
  }
}

TEST(MeshLimit, OfTwoMeshesIsTheirChangeAndOfOneNothing) {
  EXPECT_EQ(mesh_limit({4.0, 3.5}).error_mm2, 0.5);
  EXPECT_TRUE(std::isnan(mesh_limit({4.0, 3.5}).order));
  EXPECT_TRUE(std::isnan(mesh_limit({4.0}).error_mm2));
}

TEST(MeshLimit, ACompetentValveHasNoErrorAndNoNegativeLeak) {
  EXPECT_EQ(mesh_limit({0.0, 0.0, 0.0}).error_mm2, 0.0);
  EXPECT_EQ(mesh_limit({1.0, 0.4, 0.05}).leak_mm2, 0.0);
}

TEST(MeshConvergence, StopsAsSoonAsTheLeakStands) {
  const MeshConvergence wide = close_until_settled(leaking(), {.within_mm2 = 100.0});
  EXPECT_EQ(wide.stop, MeshStop::Settled);
  ASSERT_EQ(wide.levels.size(), 2U);
  EXPECT_TRUE(std::isnan(wide.levels[0].change_mm2));
  EXPECT_EQ(wide.levels[1].triangles, 4 * wide.levels[0].triangles);
  EXPECT_EQ(wide.levels[1].change_mm2, wide.levels[1].leak_mm2 - wide.levels[0].leak_mm2);
  EXPECT_EQ(wide.finest.valve.faces.rows(), wide.levels[1].triangles);
  EXPECT_EQ(wide.finest.measure.leak.area_mm2, wide.levels[1].leak_mm2);
}

TEST(MeshConvergence, TakesAnotherWayToRestIntoTheError) {
  ClosureOptions slow;
  slow.speed = 0.5;
  const Valve valve = shared_preset("barlow", 150);
  const MeshConvergence end = close_until_settled(valve, {.within_mm2 = 100.0});
  EXPECT_EQ(end.other_end_mm2, close_and_measure(valve, slow).measure.leak.area_mm2 -
                                   close_and_measure(valve).measure.leak.area_mm2);
  const double of_mesh = measure(end.finest.valve, end.finest.closure).leak_error_mm2;
  EXPECT_NEAR(end.finest.measure.leak_error_mm2, std::hypot(of_mesh, end.other_end_mm2), 1e-12);
}

TEST(MeshConvergence, StopsBeforeAMeshThatWouldBeTooFineAndTellsEachLevel) {
  std::vector<int> told;
  const MeshConvergence end =
      close_until_settled(leaking(), {.within_mm2 = 0.0, .within_share = 0.0, .most_vertices = 400},
                          [&told](const MeshLevel& level) { told.push_back(level.vertices); });
  EXPECT_EQ(end.stop, MeshStop::VertexLimit);
  ASSERT_EQ(end.levels.size(), 2U);
  EXPECT_LE(end.levels.back().vertices, 400);
  EXPECT_EQ(told, (std::vector{end.levels[0].vertices, end.levels[1].vertices}));
}

TEST(MeshConvergence, StopsWhereAClosureDoesNotConverge) {
  MeshConvergenceOptions options;
  options.closure.max_steps = 15;
  const MeshConvergence end = close_until_settled(leaking(), options);
  EXPECT_EQ(end.stop, MeshStop::NotClosed);
  EXPECT_EQ(end.levels.size(), 1U);
  EXPECT_TRUE(std::isnan(end.limit.error_mm2));
  EXPECT_TRUE(std::isnan(end.other_end_mm2));
}

TEST(RefinedStart, IsTheSamePolyhedronAndLeadsToTheSameEndSooner) {
  const Valve &valve = shared_preset("human-functional-mr", 400), fine = *refine(valve);
  const ClosureResult coarse = close_valve(valve);
  const ClosureResult start = refined_start(valve, coarse);
  EXPECT_EQ(start.closed_mm.rows(), fine.rest_mm.rows());
  EXPECT_EQ(start.closed_mm.topRows(valve.rest_mm.rows()), coarse.closed_mm);
  const ClosureResult warm = close_valve(fine, {}, &start), cold = close_valve(fine);
  EXPECT_EQ(warm.attempts.front().how, "float, from a neighbour");
  EXPECT_EQ(warm.attempts.size(), 1U);
  EXPECT_LT(warm.steps, cold.steps);
  EXPECT_LT(rms_mm(warm.closed_mm, cold.closed_mm), 0.3);
}

TEST(RefinedStart, GuardsThePartsOfTheGuardedFaces) {
  const Valve valve = leaking();
  ClosureResult coarse = close_valve(valve);
  coarse.guarded_faces = {2};
  EXPECT_EQ(refined_start(valve, coarse).guarded_faces, (std::vector{8, 9, 10, 11}));
}

TEST(Refine, PresetsCloseOnTheFinerMesh) {
  for (const std::string& name : preset_names()) {
    const Valve fine = *refine(small_preset(name));
    const ClosureResult closed = close_valve(fine);
    EXPECT_EQ(closed.status, ClosureStatus::Converged) << name;
    EXPECT_FALSE(closed.crossing) << name;
  }
}

}  // namespace
}  // namespace coapt
