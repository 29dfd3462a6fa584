// The valve that moves as the page has it; clients/web/test/static/engine.test.mjs compares the module for browsers with it.
#include "clients/engine/live.h"

#include <gtest/gtest.h>

#include "io/json/json.h"
#include "io/json/valve_json.h"
#include "tests/scenes/small_preset.h"

namespace coapt {
namespace {

constexpr int kState = 5, kHook = 10;  // numbers of a picture

class LiveEngineTest : public testing::Test {
 protected:
  std::string on_valve(Json more = Json::object()) const {
    more["valve"] = Json::parse(write_valve(valve_));
    return more.dump();
  }
  const Valve& valve_ = shared_preset("human-functional-mr", 150);
  const Json ring_ = {
      {"schema", "coapt.plan/1"},
      {"steps", {{{"step", "annuloplasty"}, {"shape", "own"}, {"sizes_below", 4}}}}};
  LiveEngine live_;
};

TEST_F(LiveEngineTest, StartsUnderThePressureOfSystoleWithWhatIsDrawn) {
  const EngineAnswer started = live_.start(on_valve());
  ASSERT_EQ(started.status, 200) << started.body;
  const Json said = Json::parse(started.body);
  EXPECT_NEAR(said["systole_mmhg"], valve_.pressure_kpa / 0.133322, 0.01);
  EXPECT_NEAR(live_.valve()->pressure_mmhg(), said["systole_mmhg"], 1e-9);
  EXPECT_EQ(said["scene"]["faces"].size(), static_cast<std::size_t>(valve_.faces.size()));
  EXPECT_TRUE(said["scene"]["closed_mm"].is_null());
  EXPECT_EQ(said["cables"].size(), live_.valve()->cables().size());
  EXPECT_EQ(said["cables"][0], Json({0, 0}));
}

TEST_F(LiveEngineTest, StartsUnderAnyPressureThatIsSaid) {
  ASSERT_EQ(live_.start(on_valve({{"pressure_mmhg", 0}})).status, 200);
  EXPECT_EQ(live_.valve()->pressure_mmhg(), 0.0);
}

TEST_F(LiveEngineTest, WhatCannotBeReadLeavesTheValveBefore) {
  EXPECT_EQ(live_.start("{").status, 400);
  EXPECT_EQ(live_.valve(), nullptr);
  ASSERT_EQ(live_.start(on_valve()).status, 200);
  const EngineAnswer refused = live_.start(on_valve({{"pressure_mmhg", 300}, {"fly", 1}}));
  EXPECT_EQ(refused.status, 422);
  EXPECT_EQ(Json::parse(refused.body)["problems"].size(), 2u);
  EXPECT_EQ(live_.change(on_valve({{"plan", {{"steps", 3}}}})).status, 422);
  EXPECT_NE(live_.valve(), nullptr);
}

TEST_F(LiveEngineTest, APictureHasStateHooksNodesAndCables) {
  ASSERT_EQ(live_.start(on_valve()).status, 200);
  const int vertex = 7;
  live_.valve()->grab(1, vertex);
  live_.valve()->move_to(1, valve_.rest_mm.row(vertex).transpose() + Vec3(0, 0, 20));
  live_.valve()->advance(60);
  const std::vector<float>& picture = live_.take_picture();
  Index branches = 0;
  for (const Chorda& chorda : valve_.chordae)
    for (const ChordaSegment& segment : chorda.segments) branches += segment.inserts ? 0 : 1;
  const Index nodes = valve_.rest_mm.rows() + branches + std::ssize(valve_.heads);
  EXPECT_EQ(std::ssize(picture), kState + kHooks * kHook + 3 * nodes + 2 * live_.cables());
  EXPECT_NEAR(picture[0], live_.valve()->pressure_mmhg(), 1e-3);
  EXPECT_EQ(picture[kState], 0.0f);
  const float* hook = &picture[kState + kHook];
  EXPECT_EQ(hook[0], 1.0f);
  EXPECT_FLOAT_EQ(hook[6], static_cast<float>(valve_.rest_mm(vertex, 2) + 20));
  EXPECT_GT(hook[9], 0.0f);  // upwards
  EXPECT_FLOAT_EQ(picture[kState + kHooks * kHook + 3 * vertex],
                  static_cast<float>(live_.valve()->vertices_mm()(vertex, 0)));
}

TEST_F(LiveEngineTest, ARingIsPutInWhereTheLeafletsAre) {
  ASSERT_EQ(live_.start(on_valve()).status, 200);
  live_.valve()->advance(1500);
  const Points before = live_.valve()->vertices_mm();
  ASSERT_EQ(live_.change(on_valve({{"plan", ring_}})).status, 200);
  EXPECT_LT((live_.valve()->vertices_mm() - before).cwiseAbs().maxCoeff(), 1e-3);
  live_.valve()->advance(1500);
  EXPECT_GT((live_.valve()->vertices_mm() - before).cwiseAbs().maxCoeff(), 1.0);
}

}  // namespace
}  // namespace coapt
