#include "io/json/weights_json.h"

#include "tests/io/json/found.h"

namespace coapt {
namespace {

using enum ErrorCode;

LearnedWeights learned() {
  CostTerms difference;
  difference[CostTerm::Leak] = 1.0;
  difference[CostTerm::Step] = -1.5;
  LearnedWeights weights;
  weights.posterior =
      learn_preferences(std::vector<Comparison>(20, {difference, Preference::Second}));
  weights.weights = learned_weights(weights.posterior);
  return weights;
}

TEST(WeightsJson, WhatWasLearnedComesBackAsItWasWritten) {
  const LearnedWeights before = learned();
  const Json json = to_json(before, {20, 3, 0.5});
  const auto after = read_learned_weights(json.dump());
  ASSERT_TRUE(after);
  EXPECT_LT((after->posterior.mean - before.posterior.mean).cwiseAbs().maxCoeff(), 1e-14);
  EXPECT_EQ(after->posterior.covariance, before.posterior.covariance);
  EXPECT_EQ(after->weights.leak, before.weights.leak);
  EXPECT_EQ(after->weights.untrusted, 1e4);
  EXPECT_EQ(json["consistency"], 0.5);
  EXPECT_EQ(json["unable"], 3);
  EXPECT_EQ(json["informed"], Json::array({"leak"}));
  EXPECT_TRUE(to_json(before, {20, 3, {}})["consistency"].is_null());
}

TEST(WeightsJson, ProblemsAreListedWithTheirPlace) {
  Json json = to_json(learned(), {});
  json["weights"]["leak"] = 0.0;
  json["noise_mm2"] = "low";
  json["covariance"]["matrix"][0][0] = -1.0;
  json["covariance"]["names"][0] = "steps";
  json.erase("tie");
  const auto read = read_learned_weights(json.dump());
  ASSERT_FALSE(read);
  EXPECT_EQ(problems_of(read), (Found{{OutOfRange, "/weights/leak"},
                                      {WrongType, "/noise_mm2"},
                                      {MissingField, "/tie"},
                                      {BadReference, "/covariance/names"},
                                      {OutOfRange, "/covariance/matrix"}}));
}

TEST(WeightsJson, ACovarianceOfAnotherSizeIsRefused) {
  const Json json = to_json(learned(), {});
  for (const char* missing : {"/covariance/matrix/0", "/covariance/matrix/0/0"}) {
    Json smaller = json;
    const Json::json_pointer at(missing);
    smaller[at.parent_pointer()].erase(0);
    EXPECT_EQ(problems_of(read_learned_weights(smaller.dump())),
              (Found{{OutOfRange, "/covariance/matrix"}}))
        << missing;
  }
}

TEST(WeightsJson, EachPlanSaysHowLikelyItIsPreferredToTheNext) {
  Json terms;
  for (const CostTermRow& row : cost_term_rows()) terms[row.name] = 0.0;
  Json result = {{"plans", Json::array()}};
  for (const double leak_mm2 : {0.0, 100.0, 100.0}) {
    terms["leak"] = leak_mm2;
    result["plans"].push_back({{"cost_terms", terms}});
  }
  add_preferred_over_next(result, learned().posterior);
  EXPECT_GT(result["plans"][0]["preferred_over_next"], 0.99);
  EXPECT_NEAR(result["plans"][1]["preferred_over_next"].get<double>(), 0.5, 1e-12);
  EXPECT_TRUE(result["plans"][2]["preferred_over_next"].is_null());
}

}  // namespace
}  // namespace coapt
