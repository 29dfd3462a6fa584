// What the engine answers without a service; clients/web/test/static/engine.test.mjs asks the same of the module for browsers.
#include "clients/engine/engine.h"

#include <gtest/gtest.h>

#include "core/closure/closure.h"
#include "io/json/json.h"
#include "io/json/valve_json.h"
#include "tests/scenes/small_preset.h"

namespace coapt {
namespace {

class EngineTest : public testing::Test {
 protected:
  /// A request on the valve with these members besides.
  std::string on_valve(Json more = Json::object()) const {
    more["valve"] = Json::parse(write_valve(valve_));
    return more.dump();
  }
  static std::vector<std::string> paths(const EngineAnswer& answer) {
    std::vector<std::string> found;
    const Json refusal = Json::parse(answer.body);
    for (const Json& problem : refusal["problems"]) found.push_back(problem["path"]);
    return found;
  }
  const Valve& valve_ = shared_preset("human-functional-mr", 150);
};

TEST_F(EngineTest, AClosureIsCloseValves) {
  const EngineAnswer answered = answer("/v1/closures", on_valve());
  ASSERT_EQ(answered.status, 200) << answered.body;
  const ClosureResult closure = close_valve(valve_, {});
  EXPECT_EQ(answered.closed_mm, closure.closed_mm);
  const Json closed = Json::parse(answered.body);
  EXPECT_EQ(closed["schema"], "coapt.closure/2");
  EXPECT_EQ(closed["steps"], closure.steps);
  EXPECT_TRUE(closed["warnings"].empty());
}

TEST_F(EngineTest, ASceneIsOfTheRepairedValveWithTheWarningsOfItsPlan) {
  const Json ring = {{"schema", "coapt.plan/1"},
                     {"steps", {{{"step", "annuloplasty"}, {"shape", "own"}, {"sizes_below", 4}}}}};
  const Json scene =
      Json::parse(answer("/v1/scenes", on_valve({{"plan", ring}, {"frames", 2}})).body);
  EXPECT_EQ(scene["schema"], "coapt.scene/2");
  EXPECT_LE(scene["motion_mm"].size(), 2u);
  EXPECT_FALSE(scene["motion_mm"].empty());
  const Json bare = Json::parse(answer("/v1/closures", on_valve()).body);
  EXPECT_LT(scene["closure"]["leak_mm2"], bare["leak_mm2"]);
}

TEST_F(EngineTest, AnOpeningHasAreaAndGradient) {
  const Json opening = Json::parse(answer("/v1/openings", on_valve({{"frames", 1}})).body);
  EXPECT_EQ(opening["schema"], "coapt.opening/2");
  EXPECT_GT(opening["opening_area_mm2"], 100.0);
  EXPECT_TRUE(opening.contains("scene"));
}

TEST_F(EngineTest, EveryProblemIsToldWithItsPlace) {
  const EngineAnswer refused =
      answer("/v1/openings", on_valve({{"frames", 61}, {"flow_ml_s", -1}, {"fly", 1}}));
  EXPECT_EQ(refused.status, 422);
  EXPECT_EQ(paths(refused), (std::vector<std::string>{"/flow_ml_s", "/frames", "/fly"}));
  const Json twice = {{"schema", "coapt.plan/1"},
                      {"steps",
                       {{{"step", "annuloplasty"}, {"shape", "own"}, {"sizes_below", 1}},
                        {{"step", "annuloplasty"}, {"shape", "own"}, {"sizes_below", 1}}}}};
  const EngineAnswer rings = answer("/v1/closures", on_valve({{"plan", twice}}));
  EXPECT_EQ(rings.status, 422);
  ASSERT_FALSE(paths(rings).empty());
  EXPECT_EQ(paths(rings).front().substr(0, 5), "/plan");
}

TEST_F(EngineTest, WhatIsNoJsonIsRefused) {
  const EngineAnswer empty = answer("/v1/closures", "");
  EXPECT_EQ(empty.status, 400);
  EXPECT_EQ(Json::parse(empty.body)["title"], "Bad request");
  EXPECT_EQ(answer("/v1/closures", "{").status, 400);
  EXPECT_EQ(answer("/v1/closures", "[]").status, 422);
}

TEST_F(EngineTest, AValveIsJudgedWithoutClosingIt) {
  EXPECT_EQ(Json::parse(answer("/v1/valves:validate", write_valve(valve_)).body)["valid"], true);
  const Json judged = Json::parse(answer("/v1/valves:validate", "{}").body);
  EXPECT_EQ(judged["valid"], false);
  EXPECT_FALSE(judged["problems"].empty());
}

TEST_F(EngineTest, RingsAreThoseOfThePlans) {
  EXPECT_GE(Json::parse(answer("/v1/rings", "").body)["rings"].size(), 3u);
}

TEST_F(EngineTest, WhatNeedsAServiceSaysSo) {
  EXPECT_EQ(answer("/v1/studies", on_valve()).status, 404);
}

TEST(TrainingEngine, MakesTheCaseOfASeedWithItsShapes) {
  const Valve& valve = small_preset("human-normal");
  Json asked = {{"valve", Json::parse(write_valve(valve))}, {"exam", "A"}, {"seed", 5}};
  const EngineAnswer made = answer("/v1/training/cases", asked.dump());
  ASSERT_EQ(made.status, 200) << made.body;
  const Json of_five = Json::parse(made.body);
  EXPECT_EQ(of_five["schema"], "coapt.training_case/1");
  ASSERT_EQ(of_five["choices"].size(), 4u);
  const auto numbers = static_cast<std::size_t>(3 * valve.rest_mm.rows());
  EXPECT_EQ(of_five["choices"][3]["closed_mm"].size(), numbers);
  EXPECT_EQ(of_five["flaccid_mm"].size(), numbers);
  EXPECT_TRUE(valve_from_json(of_five["valve"]));
  EXPECT_EQ(of_five["differences"].size(), 6u);
  EXPECT_EQ(answer("/v1/training/cases", asked.dump()).body, made.body);
}

TEST(TrainingEngine, RefusesWhatIsWrong) {
  const Json asked = {{"valve", Json::object()}, {"exam", "C"}, {"seed", -1}};
  const EngineAnswer refused = answer("/v1/training/cases", asked.dump());
  EXPECT_EQ(refused.status, 422);
  EXPECT_NE(refused.body.find("/exam"), std::string::npos);
  EXPECT_NE(refused.body.find("/seed"), std::string::npos);
  const EngineAnswer table =
      answer("/v1/training/scores", Json({{"trials_csv", "learner\n1\n"}}).dump());
  EXPECT_EQ(table.status, 422);
  EXPECT_NE(table.body.find("/trials_csv/1"), std::string::npos);
}

TEST(TrainingEngine, LaysOutAScheduleForALearner) {
  const Json schedule = {{"schema", "coapt.training_schedule/1"},
                         {"name", "short"},
                         {"title", "Three cases"},
                         {"blocks", {{{"name", "exam"}, {"exam", "B"}, {"cases", 3}}}}};
  const EngineAnswer laid =
      answer("/v1/training/exams", Json({{"schedule", schedule}, {"seed", 2}}).dump());
  ASSERT_EQ(laid.status, 200) << laid.body;
  EXPECT_EQ(Json::parse(laid.body)["blocks"][0]["trials"].size(), 3u);
}

}  // namespace
}  // namespace coapt
