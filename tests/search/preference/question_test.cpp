#include "search/preference/question.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "tests/search/preference/preference_scene.h"

namespace coapt {
namespace {

std::vector<PlanCase> cases_of(std::vector<ComparedPlan> plans) { return {{"case", plans}}; }

PosteriorDraws prior_draws() { return draw(learn_preferences({})); }

/// Six plans, each with one step and one ring size less or more of another.
std::vector<PlanCase> staircase() {
  std::vector<ComparedPlan> plans;
  for (int i = 0; i < 6; ++i)
    plans.push_back(plan_with({{CostTerm::Step, i}, {CostTerm::Undersizing, 9.0 - 2.0 * i}}));
  return cases_of(plans);
}

TEST(PosteriorDraws, TheirLogarithmsHaveTheMeanAndSpreadOfThePosterior) {
  const PosteriorDraws draws = prior_draws();
  const Eigen::ArrayXd log_tie = draws.tie.log();
  EXPECT_NEAR(log_tie.mean(), std::log(0.5), 1e-12) << "in pairs about the mean";
  EXPECT_NEAR(std::sqrt((log_tie - log_tie.mean()).square().mean()), std::log(2.0), 0.1);
}

TEST(PosteriorDraws, PlansWithoutADifferenceArePreferredByHalf) {
  EXPECT_NEAR(preferred({}, prior_draws()), 0.5, 1e-12);
  EXPECT_NEAR(information_bits({}, prior_draws()), 0.0, 0.1) << "of the tie alone";
  const CostTerms step = terms_with({{CostTerm::Step, 1.0}}), less = {-step.amounts};
  EXPECT_LT(preferred(step, prior_draws()), 0.5);
  EXPECT_NEAR(preferred(step, prior_draws()) + preferred(less, prior_draws()), 1.0, 1e-12);
}

TEST(PosteriorDraws, SharesOfTheBestPlanAddUpAndOneThatLosesInAllHasNone) {
  const PlanCase plans =
      cases_of({plan_with({{CostTerm::Step, 1.0}}), plan_with({{CostTerm::Undersizing, 2.0}}),
                plan_with({{CostTerm::Step, 2.0}})})[0];
  const std::vector<double> shares = best_shares(plans, prior_draws());
  EXPECT_NEAR(std::accumulate(shares.begin(), shares.end(), 0.0), 1.0, 1e-12);
  EXPECT_NEAR(shares[0], 0.5, 0.1) << "both cost 1 mm2 by the prior's medians";
  EXPECT_EQ(shares[2], 0.0);
}

// Plan 2 has more of everything than plan 0 and by so much that no noise hides it: whatever the weights, it loses. Plans 0
// and 1 trade steps for sizes at even odds by the prior, and only the weights decide.
TEST(NextQuestion, AsksWhereTheWeightsDecide) {
  const std::vector<PlanCase> cases =
      cases_of({plan_with({{CostTerm::Step, 20.0}}), plan_with({{CostTerm::Undersizing, 40.0}}),
                plan_with({{CostTerm::Step, 220.0}, {CostTerm::Undersizing, 400.0}})});
  const std::optional<Question> question = next_question(cases, {}, prior_draws());
  ASSERT_TRUE(question);
  EXPECT_EQ(in_order({question->pair, {}}).pair, (PlanPair{0, 0, 1}));
  // Even odds on a question that hardly any noise blurs: almost a bit.
  EXPECT_GT(question->information_bits, 0.8);
  EXPECT_LT(question->information_bits, 1.0);
  EXPECT_LT(information_bits(difference({0, 0, 2}, cases), prior_draws()), 0.01);
}

TEST(NextQuestion, DoesNotAskAboutPlansThatDifferByNothing) {
  EXPECT_FALSE(next_question(
      cases_of({plan_with({{CostTerm::Leak, 1.0}}), plan_with({{CostTerm::Leak, 1.0}})}), {},
      prior_draws()));
  EXPECT_FALSE(next_question({}, {}, prior_draws()));
}

TEST(NextQuestion, AsksNoPairTwiceExceptATenthWithSidesSwapped) {
  const std::vector<PlanCase> cases = staircase();
  std::vector<GivenAnswer> given;
  int repeats = 0;
  while (const std::optional<Question> question = next_question(cases, given, prior_draws())) {
    const auto same = [&](const GivenAnswer& earlier) {
      return in_order(earlier).pair == in_order({question->pair, {}}).pair;
    };
    const auto asked = std::count_if(given.begin(), given.end(), same);
    EXPECT_EQ(asked, question->repeats ? 1 : 0);
    if (question->repeats) {
      ++repeats;
      EXPECT_EQ((given.size() + 1) % kRepeatEvery, 0u);
      EXPECT_EQ(question->pair.first, given[static_cast<std::size_t>(repeats - 1)].pair.second);
    }
    given.push_back({question->pair, Preference::First});
  }
  EXPECT_EQ(given.size(), 16u) << "15 pairs of 6 plans and the tenth question";
  EXPECT_EQ(repeats, 1);
}

TEST(NextQuestion, OfACaseWithoutPlansNothingIsAskedOrFirst) {
  EXPECT_FALSE(next_question({{.name = "none", .plans = {}}}, {}, prior_draws()));
  EXPECT_TRUE(best_shares({.name = "none", .plans = {}}, prior_draws()).empty());
}

TEST(NextQuestion, TheSameAnswersGiveTheSameQuestionAndBothSidesComeFirst) {
  const std::vector<PlanCase> cases = staircase();
  std::vector<GivenAnswer> given;
  int in_order_of_rank = 0;
  for (int i = 0; i < 9; ++i) {
    const auto one = next_question(cases, given, prior_draws());
    const auto two = next_question(cases, given, prior_draws());
    EXPECT_EQ(one->pair, two->pair);
    EXPECT_EQ(one->information_bits, two->information_bits);
    in_order_of_rank += one->pair.first < one->pair.second ? 1 : 0;
    given.push_back({one->pair, Preference::Second});
  }
  EXPECT_GT(in_order_of_rank, 0);
  EXPECT_LT(in_order_of_rank, 9);
}

}  // namespace
}  // namespace coapt
