
#include "search/plans/cost_terms.h"
#include "tests/server/endpoints/service_scene.h"

namespace coapt {
namespace {

/// A plan of one step that leaks so much, its ring so many sizes below.
Json plan_of(double leak_mm2, double sizes_below) {
  Json terms;
  for (const CostTermRow& row : cost_term_rows()) terms[row.name] = 0.0;
  terms["step"] = 1.0;
  terms["leak"] = leak_mm2;
  terms["undersizing"] = sizes_below;
  return {{"cost_terms", terms}, {"description", {"a ring"}}, {"leak_mm2", {{"mean", leak_mm2}}}};
}

class PreferencesTest : public ServiceTest {
 protected:
  static Json request_of(const Json& answers) {
    const Json plans = {plan_of(0.0, 4.0), plan_of(2.0, 0.0), plan_of(0.5, 2.0)};
    return {{"cases", {{{"schema", "coapt.plans/2"}, {"name", "a case"}, {"plans", plans}}}},
            {"answers", answers}};
  }
  static Json answer(int first, int second, const char* which) {
    return {{"case", "a case"}, {"first", first}, {"second", second}, {"answer", which}};
  }
};

TEST_F(PreferencesTest, WithoutAnswersItAsksAndKnowsNothing) {
  const Answer reply = post("/v1/preferences", request_of(Json::array()));
  ASSERT_EQ(reply.status, 200) << json_of(reply);
  const Json json = json_of(reply);
  EXPECT_EQ(json["learned"]["answers"], 0);
  EXPECT_TRUE(json["learned"]["informed"].empty());
  EXPECT_NEAR(json["learned"]["weights"]["undersizing"].get<double>(), 0.5, 1e-9);
  EXPECT_EQ(json["question"]["case"], "a case");
  EXPECT_EQ(json["question"]["plans"].size(), 2u);
  EXPECT_TRUE(json["question"]["plans"][0].contains("leak_mm2"));
  EXPECT_EQ(json["first_places"].size(), 1u);
}

TEST_F(PreferencesTest, WhoTakesTheLeakFindsUndersizingDear) {
  Json request = request_of({answer(1, 2, "second"), answer(3, 1, "first"), answer(2, 3, "first")});
  request["hide_figures"] = true;
  const Json json = json_of(post("/v1/preferences", request));
  EXPECT_GT(json["learned"]["weights"]["undersizing"], 0.5);
  EXPECT_LT(json["learned"]["weights"]["leak"], 1.0);
  EXPECT_EQ(json["first_places"][0]["rank"], 2);
  EXPECT_TRUE(json["question"].is_null()) << "all three pairs were asked for";
}

TEST_F(PreferencesTest, ACaseWithoutPlansHasNoFirstPlace) {
  Json request = request_of(Json::array());
  request["cases"][0]["plans"] = Json::array();
  const Json json = json_of(post("/v1/preferences", request));
  EXPECT_TRUE(json["question"].is_null());
  EXPECT_TRUE(json["first_places"].empty());
}

TEST_F(PreferencesTest, EachProblemIsNamed) {
  const auto refused = [this](const Json& request) {
    return refusal(post("/v1/preferences", request));
  };
  EXPECT_EQ(refused(request_of({answer(1, 4, "first"), answer(2, 2, "unable")})),
            (Refused{422, {"/answers/0/second", "/answers/1"}}));
  Json twice = request_of(Json::array());
  twice["cases"].push_back(twice["cases"][0]);
  EXPECT_EQ(refused(twice), (Refused{422, {"/cases"}}));
  Json none = request_of(Json::array());
  none["cases"] = Json::array();
  EXPECT_EQ(refused(none), (Refused{422, {"/cases"}}));
  Json nameless = request_of(Json::array());
  nameless["cases"][0].erase("name");
  nameless["cases"][0]["plans"][1].erase("cost_terms");
  EXPECT_EQ(refused(nameless), (Refused{422, {"/cases/0/plans/1/cost_terms", "/cases/0/name"}}));
}

}  // namespace
}  // namespace coapt
