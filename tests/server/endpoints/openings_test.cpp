
#include "io/json/opening_json.h"
#include "tests/server/endpoints/service_scene.h"

namespace coapt {
namespace {

class OpeningsTest : public ServiceTest {
 protected:
  Answer open(const Json& more = Json::object()) {
    Json request = {{"valve", small_document()}};
    request.update(more);
    return post("/v1/openings", request);
  }
};

Json asked_with(const Json& step) {
  return {{"plan", {{"schema", "coapt.plan/1"}, {"steps", {step}}}}};
}

TEST_F(OpeningsTest, AnOpeningIsThatOfTheValve) {
  const Answer answer = open({{"pressure_mmhg", 8.0}, {"flow_ml_s", 200.0}, {"exercise", 2.0}});
  ASSERT_EQ(answer.status, 200) << json_of(answer);
  Json json = json_of(answer);
  const OpeningOptions options{8.0, 200.0, 2.0};
  Json same = opening_to_json(*open_valve(small_valve(), options), 0.0);
  ASSERT_EQ(json["warnings"].size(), 1u) << json["warnings"];
  EXPECT_NE(json["warnings"][0].get<std::string>().find("in health"), std::string::npos);
  EXPECT_TRUE(json["opening_area_mm2"].is_number());
  for (const char* of_this_answer : {"warnings", "scene", "seconds"}) json.erase(of_this_answer);
  same.erase("seconds");
  EXPECT_EQ(json, same);
}

TEST_F(OpeningsTest, WhatIsDrawnOfItHasTheFramesAskedFor) {
  const Points::Index vertices = small_valve().rest_mm.rows();
  const Json still = json_of(open())["scene"];
  EXPECT_EQ(still["open_mm"].size(), static_cast<std::size_t>(3 * vertices));
  EXPECT_EQ(still["faces"].size(), static_cast<std::size_t>(small_valve().faces.size()));
  EXPECT_GE(still["leak"][0]["points_mm"].size(), 9u);
  EXPECT_TRUE(still["motion_mm"].empty());
  const Json moving = json_of(open({{"frames", 3}}))["scene"];
  ASSERT_EQ(moving["motion_mm"].size(), 3u);
  const Json& end = moving["motion_mm"].back();
  EXPECT_TRUE(std::equal(still["open_mm"].begin(), still["open_mm"].end(), end.begin()));
}

TEST_F(OpeningsTest, APlanIsAppliedAndWarnedOf) {
  const Json before = json_of(open());
  const Answer answer =
      open(asked_with({{"step", "annuloplasty"}, {"shape", "own"}, {"sizes_below", 6}}));
  ASSERT_EQ(answer.status, 200) << json_of(answer);
  const Json repaired = json_of(answer);
  EXPECT_LT(repaired["opening_area_mm2"], before["opening_area_mm2"]);
  EXPECT_GT(repaired["gradient_mmhg"], before["gradient_mmhg"]);
  EXPECT_EQ(repaired["systole"]["annular_contraction"], 0.0);
  EXPECT_FALSE(repaired["warnings"].empty());
}

TEST_F(OpeningsTest, EveryProblemPointsIntoTheRequest) {
  EXPECT_EQ(refusal(open({{"pressure_mmhg", 0.5},
                          {"flow_ml_s", "much"},
                          {"exercise", 0.9},
                          {"frames", 61},
                          {"surprise", 1}})),
            (Refused{422, {"/pressure_mmhg", "/flow_ml_s", "/exercise", "/frames", "/surprise"}}));
  EXPECT_EQ(refusal(open(asked_with({{"step", "chordal_excision"}, {"chorda", "none"}}))),
            (Refused{422, {"/plan/steps/0/chorda"}}));
  EXPECT_EQ(refusal(open({{"valve", "nobody"}})), (Refused{422, {"/valve"}}));
  EXPECT_EQ(refusal(post("/v1/openings", Json::object())), (Refused{422, {"/valve"}}));
  EXPECT_EQ(ask("POST", "/v1/openings", "{").status, 400);
}

TEST_F(OpeningsTest, AValveMayBeNamed) {
  const Json named = json_of(post("/v1/openings", {{"valve", stored_valve()}}));
  EXPECT_EQ(named["opening_area_mm2"], json_of(open())["opening_area_mm2"]);
}

TEST_F(OpeningsTest, TheLimitsAreThoseOfClosures) {
  {
    const Compute::Turn other(compute());
    EXPECT_EQ(open().status, 503);
  }
  limits_.vertex_steps = 1000.0;
  const Answer long_one = open();
  EXPECT_EQ(long_one.status, 422);
  EXPECT_NE(content_bytes(long_one).find("more than 1000 steps times vertices"), std::string::npos);
  limits_.vertex_steps = 1e9;
  limits_.request_seconds = 1e-9;
  EXPECT_EQ(open().status, 503);
  limits_.vertices = 10;
  EXPECT_EQ(refusal(open()), (Refused{422, {"/valve/vertices_mm"}}));
}

}  // namespace
}  // namespace coapt
