#include "core/live/nearest_hold.h"

#include <gtest/gtest.h>

#include "tests/scenes/small_valve.h"

namespace coapt {
namespace {

TEST(NearestHold, IsAVertexAtTheLeafletAndAShareOfAChordaBesideIt) {
  const LiveValve live(small_valve());
  for (int v = 0; v < live.vertices(); ++v) {
    const Hold hold = nearest_hold(live, live.vertices_mm().row(v).transpose());
    EXPECT_EQ(hold.vertex, v);
    EXPECT_EQ(hold.cable, -1);
  }
  const std::vector<LiveCable> cables = live.cables();
  for (std::size_t c = 0; c < cables.size(); ++c) {
    const Vec3 place = 0.7 * cables[c].start_mm + 0.3 * cables[c].end_mm;
    const Hold hold = nearest_hold(live, place);
    EXPECT_EQ(hold.vertex, -1);
    EXPECT_EQ(hold.cable, static_cast<int>(c));
    EXPECT_NEAR(hold.share, 0.3, 1e-6);
    EXPECT_LT((hold.spot_mm - place).norm(), 1e-6);
  }
}

TEST(NearestHold, TakesHoldOfItsSpot) {
  LiveValve live(small_valve());
  const LiveCable cable = live.cables().front();
  const Hold hold = nearest_hold(live, 0.5 * (cable.start_mm + cable.end_mm));
  grab(live, 0, hold);
  EXPECT_LT((live.spot_mm(0) - hold.spot_mm).norm(), 1e-6);
  EXPECT_EQ(live.force_n(0).norm(), 0.0);
}

}  // namespace
}  // namespace coapt
