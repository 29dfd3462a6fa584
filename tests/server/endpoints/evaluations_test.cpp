
#include "search/conditioning.h"
#include "tests/server/endpoints/service_scene.h"

namespace coapt {
namespace {

class EvaluationsTest : public ServiceTest {};

const Json kNothing = {{"schema", "coapt.plan/1"}, {"steps", Json::array()}};
const Json kRing = {{"schema", "coapt.plan/1"},
                    {"steps", {{{"step", "annuloplasty"}, {"shape", "own"}, {"sizes_below", 1}}}}};

Json request_of(const std::vector<Json>& plans) {
  return {{"valve", small_document()}, {"plans", plans}};
}

TEST_F(EvaluationsTest, PlansAreAnsweredInTheOrderAskedEachWithItsRank) {
  const Answer answer = post("/v1/evaluations", request_of({kNothing, kRing, kNothing}));
  ASSERT_EQ(answer.status, 200) << json_of(answer);
  const Json json = json_of(answer);
  ASSERT_EQ(json["plans"].size(), 3u);
  for (int i = 0; i < 3; ++i) EXPECT_EQ(json["plans"][static_cast<std::size_t>(i)]["index"], i);
  EXPECT_EQ(json["plans"][0]["rank"], json["plans"][2]["rank"]);
  EXPECT_EQ(json["plans"][0]["plan"], kNothing);
  EXPECT_EQ(json["plans"][1]["plan"]["steps"], kRing["steps"]);
  EXPECT_EQ(json["plans_tried"], 2);
  EXPECT_EQ(json["closures"], 1 + 2);
  EXPECT_FALSE(json.contains("evaluations"));  // nothing was searched
  EXPECT_FALSE(json["plans"][0].contains("name"));
}

TEST_F(EvaluationsTest, RegionPointsAndEvidenceAreClosedToo) {
  Json request = request_of({kNothing});
  request["region_points"] = 2;
  request["evidence"] = true;
  const Answer answer = post("/v1/evaluations", request);
  ASSERT_EQ(answer.status, 200) << json_of(answer);
  EXPECT_EQ(json_of(answer)["plans"][0]["region_closures"], 2);
  // Each of the 8 courses of disease leaks at its first step.
  EXPECT_EQ(json_of(answer)["closures"], 1 + 2 + 88 + 8);
}

TEST_F(EvaluationsTest, DrawsAreWeighedByWhatWasObservedOfTheValve) {
  Json request = request_of({kRing});
  request["model_draws"] = kConditionedDraws;
  const Json drawn = json_of(post("/v1/evaluations", request));
  EXPECT_EQ(drawn["model_draws"]["draws"], kConditionedDraws);
  EXPECT_FALSE(drawn["model_draws"].contains("observed"));
  const Json &before = drawn["before"]["leak"], &after = drawn["plans"][0]["leak"];
  ASSERT_TRUE(before["tissue"].is_array() && after["tissue"].is_array());
  const double leak_mm2 = before["area_mm2"];
  request["valve"]["observed"] = {{"leak_mm2", {{"value", leak_mm2}, {"sd", 0.05 * leak_mm2}}}};
  request["model_draws"] = 8;  // as many as it takes to weigh them
  const Answer answer = post("/v1/evaluations", request);
  ASSERT_EQ(answer.status, 200) << json_of(answer);
  const Json seen = json_of(answer);
  EXPECT_EQ(seen["model_draws"]["draws"], kConditionedDraws);
  EXPECT_EQ(seen["model_draws"]["observed"].dump(), R"(["leak_mm2"])");
  EXPECT_EQ(seen["model_draws"]["contradicts_model"], false);
  EXPECT_EQ(seen["before"]["leak"]["area_mm2"], leak_mm2);
  const auto width = [](const Json& interval) {
    return interval[1].get<double>() - interval[0].get<double>();
  };
  EXPECT_LT(width(seen["before"]["leak"]["tissue"]), 0.5 * width(before["tissue"]));
  EXPECT_LT(width(seen["plans"][0]["leak"]["tissue"]), width(after["tissue"]));
}

TEST_F(EvaluationsTest, WithoutDrawsNothingIsSaidOfTheTissue) {
  const Json answer = json_of(post("/v1/evaluations", request_of({kRing})));
  EXPECT_EQ(answer["model_draws"]["draws"], 0);
  EXPECT_TRUE(answer["before"]["leak"]["tissue"].is_null());
}

TEST_F(EvaluationsTest, TooManyClosuresAtOnceAreRefused) {
  limits_.evaluation_closures = 10;  // of the usual size: some 43 of this one
  Json many = request_of({kNothing, kRing});
  many["region_points"] = 25;
  EXPECT_EQ(refusal(post("/v1/evaluations", many)), (Refused{422, {"/plans"}}));
  Json evidence = request_of({kNothing, kRing});
  evidence["evidence"] = true;
  EXPECT_EQ(refusal(post("/v1/evaluations", evidence)), (Refused{422, {"/plans"}}));
  Json drawn = request_of({kRing});
  drawn["model_draws"] = 60;
  EXPECT_EQ(refusal(post("/v1/evaluations", drawn)), (Refused{422, {"/plans"}}));
}

TEST_F(EvaluationsTest, ProblemsPointIntoTheRequest) {
  for (const char* path : {"/v1/evaluations", "/v1/reports"}) {
    EXPECT_EQ(refusal(post(path, request_of({}))), (Refused{422, {"/plans"}}));
    Json request = request_of({kNothing, kRing});
    request["plans"][1]["steps"][0]["step"] = "fly";
    request["region_points"] = 1090;
    request["evidence"] = "yes";
    request["model_draws"] = 201;
    request["surprise"] = 1;
    EXPECT_EQ(refusal(post(path, request)), (Refused{422,
                                                     {"/plans/1/steps/0/step", "/region_points",
                                                      "/evidence", "/model_draws", "/surprise"}}));
    Json impossible = request_of({kNothing, kRing});
    impossible["plans"][1]["steps"] = {{{"step", "chordal_excision"}, {"chorda", "none"}}};
    EXPECT_EQ(refusal(post(path, impossible)), (Refused{422, {"/plans/1/steps/0/chorda"}}));
    EXPECT_EQ(refusal(post(path, {{"plans", {kNothing}}})), (Refused{422, {"/valve"}}));
    EXPECT_EQ(ask("POST", path, "[").status, 400);
  }
}

TEST_F(EvaluationsTest, WithoutATurnTheyAre503) {
  const Compute::Turn other(compute());
  EXPECT_EQ(post("/v1/evaluations", request_of({kNothing})).status, 503);
  EXPECT_EQ(post("/v1/reports", request_of({kNothing})).status, 503);
}

TEST_F(EvaluationsTest, AReportIsAPageOnTenPlansAtMost) {
  const Answer answer = post("/v1/reports", request_of({kNothing, kRing}));
  ASSERT_EQ(answer.status, 200);
  EXPECT_EQ(std::get<Content>(answer.body).type, kHtmlType);
  EXPECT_TRUE(bytes_of(answer).starts_with("<!DOCTYPE html>"));
  EXPECT_EQ(refusal(post("/v1/reports", request_of(std::vector<Json>(11, kNothing)))),
            (Refused{422, {"/plans"}}));
}

}  // namespace
}  // namespace coapt
