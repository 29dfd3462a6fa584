#include "search/preference/posterior.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

#include "search/random_share.h"
#include "tests/search/preference/preference_scene.h"

namespace coapt {
namespace {

constexpr double kSame = 1e-12;

int index_of(CostTerm term) { return static_cast<int>(term); }

/// Differences of all learned terms, uniform from -2 to 2; untrusted alike.
CostTerms random_difference(std::mt19937_64& engine) {
  CostTerms terms;
  for (int term = 0; term < kLearnedTerms; ++term)
    terms.amounts[term] = 4.0 * random_share(engine) - 2.0;
  return terms;
}

std::vector<Comparison> random_comparisons(int count) {
  std::mt19937_64 engine(7);
  std::vector<Comparison> all;
  for (int i = 0; i < count; ++i)
    all.push_back({random_difference(engine), static_cast<Preference>(i % 3)});
  return all;
}

TEST(PreferencePosterior, DerivativesAreThoseOfDifferences) {
  const std::vector<Comparison> answers = random_comparisons(12);
  std::mt19937_64 engine(3);
  Unknowns at = prior_mean({});
  for (double& value : at) value += random_share(engine) - 0.5;
  const LogPosterior here = log_posterior(answers, {}, at);
  constexpr double kStep = 1e-5;
  for (int i = 0; i < kUnknowns; ++i) {
    const Unknowns step = kStep * Unknowns::Unit(i);
    const LogPosterior more = log_posterior(answers, {}, at + step);
    const LogPosterior less = log_posterior(answers, {}, at - step);
    EXPECT_NEAR(here.gradient[i], (more.value - less.value) / (2 * kStep), 1e-6) << i;
    const Unknowns column = (more.gradient - less.gradient) / (2 * kStep);
    EXPECT_LT((here.hessian.col(i) - column).cwiseAbs().maxCoeff(), 1e-6) << i;
  }
  EXPECT_LT((here.hessian - here.hessian.transpose()).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(PreferencePosterior, WithoutAnswersItIsThePrior) {
  const PreferencePosterior posterior = learn_preferences({});
  EXPECT_LT((posterior.mean - prior_mean({})).cwiseAbs().maxCoeff(), kSame);
  EXPECT_LT((log_sd(posterior) - prior_sd({})).cwiseAbs().maxCoeff(), kSame);
  const CostWeights weights = learned_weights(posterior);
  for (const CostTermRow& row : cost_term_rows())
    EXPECT_NEAR(weights.*row.weight, CostWeights{}.*row.weight, kSame * CostWeights{}.*row.weight);
}

TEST(PreferencePosterior, TheMeanIsWhereTheGradientVanishes) {
  const std::vector<Comparison> answers = random_comparisons(60);
  const PreferencePosterior posterior = learn_preferences(answers);
  const LogPosterior there = log_posterior(answers, {}, posterior.mean);
  EXPECT_LT(there.gradient.cwiseAbs().maxCoeff(), 1e-8);
}

TEST(PreferencePosterior, ManyNoiselessAnswersGiveTheRatiosOfTheWeights) {
  CostWeights expert;
  expert.leak = 2.0;
  expert.step = 0.4;
  expert.undersizing = 1.1;
  expert.movement = 0.5;
  std::mt19937_64 engine(11);
  std::vector<Comparison> answers;
  const std::array<CostTerm, 4> used = {CostTerm::Leak, CostTerm::Step, CostTerm::Undersizing,
                                        CostTerm::Movement};
  for (int i = 0; i < 2000; ++i) {
    CostTerms difference;
    for (const CostTerm term : used) difference[term] = 4.0 * random_share(engine) - 2.0;
    answers.push_back(
        {difference, price(difference, expert) < 0.0 ? Preference::First : Preference::Second});
  }
  const PreferencePosterior posterior = learn_preferences(answers);
  const CostWeights learned = learned_weights(posterior);
  EXPECT_NEAR(learned.step / learned.leak, 0.2, 0.02);
  EXPECT_NEAR(learned.undersizing / learned.leak, 0.55, 0.03);
  EXPECT_NEAR(learned.movement / learned.leak, 0.25, 0.02);
}

TEST(PreferencePosterior, WhatNoPairTellsApartStaysAtItsPriorAndIsSaid) {
  const std::vector<Comparison> answers(
      20, {terms_with({{CostTerm::Leak, 1.0}, {CostTerm::Step, -1.5}}), Preference::First});
  const PreferencePosterior posterior = learn_preferences(answers);
  const std::vector<bool> said = informed(posterior);
  for (int term = 0; term < kLearnedTerms; ++term) {
    if (term == index_of(CostTerm::Leak) || term == index_of(CostTerm::Step)) continue;
    EXPECT_FALSE(said[static_cast<std::size_t>(term)]);
    EXPECT_NEAR(posterior.mean[term], prior_mean({})[term], kSame);
    EXPECT_NEAR(log_sd(posterior)[term], prior_sd({})[term], kSame);
  }
  EXPECT_GT(learned_weights(posterior).step, 1.2) << "1.5 steps always count more than 1 mm2";
  EXPECT_LT(learned_weights(posterior).leak, 0.9);
  EXPECT_TRUE(said[static_cast<std::size_t>(index_of(CostTerm::Step))]);
}

TEST(PreferencePosterior, TiesMakeATermCheapAndTiesMoreLikely) {
  const CostTerms step = terms_with({{CostTerm::Step, 2.0}});
  const std::vector<Comparison> unable(20, {step, Preference::Unable});
  const PreferencePosterior posterior = learn_preferences(unable);
  EXPECT_LT(std::abs(advantage(step, posterior.mean)), std::abs(advantage(step, prior_mean({}))));
  EXPECT_GT(posterior.mean[kTie], prior_mean({})[kTie]);
}

TEST(PreferencePosterior, AnswersAgainstAllReasonLeaveAFinitePosterior) {
  const std::vector<Comparison> answers(
      40, {terms_with({{CostTerm::Leak, 300.0}, {CostTerm::Untrusted, 0.5}}), Preference::First});
  const PreferencePosterior posterior = learn_preferences(answers);
  EXPECT_TRUE(posterior.mean.allFinite());
  EXPECT_GT(log_sd(posterior).minCoeff(), 0.0);
}

TEST(PreferencePosterior, TheSameAnswersGiveTheSameBits) {
  const std::vector<Comparison> answers = random_comparisons(30);
  const PreferencePosterior one = learn_preferences(answers), two = learn_preferences(answers);
  EXPECT_EQ(one.mean, two.mean);
  EXPECT_EQ(one.covariance, two.covariance);
}

}  // namespace
}  // namespace coapt
