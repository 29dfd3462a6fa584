#include "search/preference/answer_model.h"

#include <gtest/gtest.h>

#include <cmath>

namespace coapt {
namespace {

TEST(AnswerModel, EqualPlansAreToldApartByChance) {
  const AnswerShares shares = answer_shares(0.0, 0.5);
  EXPECT_DOUBLE_EQ(shares.unable, 0.2) << "tie / (2 + tie)";
  EXPECT_DOUBLE_EQ(shares.first, 0.4);
  EXPECT_DOUBLE_EQ(shares.second, 0.4);
}

TEST(AnswerModel, BetweenTheTwoPlansItIsThatOfBradleyAndTerry) {
  const AnswerShares shares = answer_shares(std::log(3.0), 0.7);
  EXPECT_NEAR(shares.first / shares.second, 3.0, 1e-14);
  EXPECT_NEAR(shares.unable / std::sqrt(shares.first * shares.second), 0.7, 1e-14) << "Davidson";
}

TEST(AnswerModel, SharesAddUpHoweverFarApartPlansAre) {
  for (const double advantage : {-1e5, -30.0, 0.0, 2.0, 1e5}) {
    const AnswerShares shares = answer_shares(advantage, 0.5);
    EXPECT_DOUBLE_EQ(shares.first + shares.second + shares.unable, 1.0);
    for (const Preference answer : {Preference::First, Preference::Second, Preference::Unable})
      EXPECT_TRUE(std::isfinite(log_share(answer, advantage, 0.5).value)) << advantage;
  }
}

TEST(AnswerModel, DerivativesAreThoseOfDifferences) {
  constexpr double kStep = 1e-5;
  for (const Preference answer : {Preference::First, Preference::Second, Preference::Unable})
    for (const double a : {-2.5, 0.3, 4.0}) {
      const double t = std::log(0.4);
      const auto at = [&](double da, double dt) {
        return log_share(answer, a + da, std::exp(t + dt));
      };
      const LogShare here = at(0.0, 0.0), right = at(kStep, 0.0), left = at(-kStep, 0.0);
      const LogShare up = at(0.0, kStep), down = at(0.0, -kStep);
      EXPECT_NEAR(here.by_a, (right.value - left.value) / (2 * kStep), 1e-8);
      EXPECT_NEAR(here.by_t, (up.value - down.value) / (2 * kStep), 1e-8);
      EXPECT_NEAR(here.by_aa, (right.by_a - left.by_a) / (2 * kStep), 1e-8);
      EXPECT_NEAR(here.by_at, (up.by_a - down.by_a) / (2 * kStep), 1e-8);
      EXPECT_NEAR(here.by_tt, (up.by_t - down.by_t) / (2 * kStep), 1e-8);
    }
}

TEST(AnswerModel, ASwappedAnswerIsAsLikelyWithTheOppositeAdvantage) {
  for (const Preference answer : {Preference::First, Preference::Second, Preference::Unable})
    EXPECT_EQ(log_share(answer, 1.3, 0.5).value, log_share(swapped(answer), -1.3, 0.5).value);
}

}  // namespace
}  // namespace coapt
