#include "io/exchange/exported_valve.h"

#include <gtest/gtest.h>

#include "still_valve.h"

namespace coapt {
namespace {

TEST(ExportedValve, MotionIsVerticesThenBranchPointsThenHeads) {
  const ClosedValve exported = still_valve();
  const std::vector<ValveShape> states = motion_shapes(exported);
  ASSERT_EQ(states.size(), 2U);
  const ValveShape closed = closed_shape(exported);
  EXPECT_EQ(states[1].vertices_mm, closed.vertices_mm);
  EXPECT_EQ(states[1].heads_mm, closed.heads_mm);
  for (std::size_t c = 0; c < 2; ++c) {
    EXPECT_EQ(states[1].chorda_ends_mm[c], closed.chorda_ends_mm[c]);
    const Points lift = states[0].chorda_ends_mm[c] - closed.chorda_ends_mm[c];
    EXPECT_NEAR(lift.col(2).minCoeff(), 2.0, 1e-12);
    EXPECT_NEAR(lift.col(2).maxCoeff(), 2.0, 1e-12);
  }
}

TEST(ExportedValve, ARealClosuresMotionEndsWhereTheClosureDoes) {
  const ClosedValve exported = close_and_measure(small_valve(), {.motion = true});
  const std::vector<ValveShape> states = motion_shapes(exported);
  ASSERT_GT(states.size(), 2U);
  const ValveShape closed = closed_shape(exported);
  EXPECT_EQ(states.back().vertices_mm, closed.vertices_mm);
  EXPECT_LT((states.back().heads_mm - closed.heads_mm).norm(), 1e-3);
  EXPECT_LT((states.back().chorda_ends_mm[0] - closed.chorda_ends_mm[0]).norm(), 1e-3);
  EXPECT_LT((states.front().vertices_mm - exported.valve.rest_mm).norm(), 1e-3);
}

TEST(ExportedValve, SegmentsBeginAtTheHeadOrAtTheEndOfTheirParent) {
  const ClosedValve exported = still_valve();
  const ValveShape shape = closed_shape(exported);
  const Chorda& chorda = exported.valve.chordae[0];
  EXPECT_EQ(segment_start(shape, chorda, 0, 0), exported.valve.heads[0].tip_mm);
  EXPECT_EQ(segment_start(shape, chorda, 0, 2), chorda.segments[0].branch_point_mm);
}

TEST(ExportedValve, AnInsertionIsAttachedToItsHeaviestVertex) {
  Valve valve = small_valve();
  valve.chordae[1].segments[0].insertion = {0, {0.2, 0.7, 0.1}};
  EXPECT_EQ(attached_vertex(valve, valve.chordae[1].segments[0].insertion), valve.faces(0, 1));
  const ValveShape shape = unstressed_shape(valve), attached = attached_shape(valve, shape);
  const Vec3 vertex = valve.rest_mm.row(valve.faces(0, 1));
  EXPECT_EQ(Vec3(attached.chorda_ends_mm[1].row(0)), vertex);
  EXPECT_EQ(attached.chorda_ends_mm[0], shape.chorda_ends_mm[0]);
  EXPECT_DOUBLE_EQ(attachment_shift_mm(valve, shape),
                   (vertex - Vec3(shape.chorda_ends_mm[1].row(0))).norm());
}

}  // namespace
}  // namespace coapt
