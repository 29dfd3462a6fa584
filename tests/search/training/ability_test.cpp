#include "search/training/ability.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "search/random_share.h"

namespace coapt {
namespace {

TEST(Ability, AtItsDifficultyACaseIsRightHalfwayBetweenChanceAndOne) {
  EXPECT_DOUBLE_EQ(probability_right(0.7, {true, 0.7, 0.25}), 0.625);
  EXPECT_NEAR(probability_right(-50.0, {true, 0.0, 0.25}), 0.25, 1e-12);
  EXPECT_NEAR(probability_right(50.0, {true, 0.0, 0.25}), 1.0, 1e-12);
}

TEST(Ability, WithoutAnswersItIsThePrior) {
  const Ability none = ability_of({});
  EXPECT_NEAR(none.value, 0.0, 1e-12);
  EXPECT_NEAR(none.standard_error, 1.5, 0.01);
}

TEST(Ability, OfManyAnswersIsThatWhichGivesThem) {
  // 625 of 1,000 at difficulty 0: ability 0. 700: (0.7 - 0.25) / 0.75 = 0.6, whose logit is 0.405.
  std::vector<Response> responses(1000, {false, 0.0, 0.25});
  for (std::size_t i = 0; i < 625; ++i) responses[i].right = true;
  EXPECT_NEAR(ability_of(responses).value, 0.0, 0.01);
  for (std::size_t i = 0; i < 700; ++i) responses[i].right = true;
  EXPECT_NEAR(ability_of(responses).value, std::log(0.6 / 0.4), 0.01);
  EXPECT_LT(ability_of(responses).standard_error, 0.12);
}

TEST(Ability, AllRightIsFinite) {
  const Ability all = ability_of(std::vector<Response>(10, {true, 0.0, 0.25}));
  EXPECT_GT(all.value, 1.0);
  EXPECT_LT(all.value, 4.0);
}

TEST(Difficulty, ForAProbabilityIsGotRightWithIt) {
  EXPECT_NEAR(probability_right(0.5, {true, difficulty_for(0.5, 0.25, 0.6), 0.25}), 0.6, 1e-12);
}

/// Raters of normal abilities answer every item by the model.
std::vector<RatedItem> scripted_answers(int raters, const std::vector<ItemFit>& items,
                                        double chance) {
  std::mt19937_64 engine(3);
  std::vector<RatedItem> rated;
  for (int r = 0; r < raters; ++r) {
    const double ability = 1.5 * normal_share(engine);
    for (std::size_t i = 0; i < items.size(); ++i) {
      const Response item{true, items[i].difficulty, chance, items[i].slope};
      rated.push_back(
          {r, static_cast<int>(i), random_share(engine) < probability_right(ability, item)});
    }
  }
  return rated;
}

TEST(Calibration, FindsTheDifficultiesOfScriptedRaters) {
  std::vector<ItemFit> truth;
  for (const double difficulty : {-2.0, -1.0, -0.3, 0.0, 0.4, 1.0, 1.8})
    truth.push_back({0, difficulty, 1.0, 0.0});
  const auto fits = calibrate(scripted_answers(300, truth, 0.25), 300, 7, {.chance = 0.25});
  for (std::size_t i = 0; i < truth.size(); ++i) {
    EXPECT_EQ(fits[i].answers, 300);
    EXPECT_NEAR(fits[i].difficulty, truth[i].difficulty, 4.0 * fits[i].difficulty_se);
    EXPECT_LT(fits[i].difficulty_se, 0.4);
  }
}

TEST(Calibration, FindsSlopesWhereItIsAsked) {
  std::vector<ItemFit> truth;
  for (int i = 0; i < 12; ++i) truth.push_back({0, -1.0 + 0.2 * i, i % 2 == 0 ? 0.6 : 1.6, 0.0});
  const auto fits =
      calibrate(scripted_answers(400, truth, 0.25), 400, 12, {.chance = 0.25, .slopes = true});
  for (std::size_t i = 0; i < 12; i += 2) EXPECT_LT(fits[i].slope, fits[i + 1].slope);
}

TEST(Calibration, AnItemThatAllGotRightIsFinite) {
  std::vector<RatedItem> rated;
  for (int r = 0; r < 20; ++r) rated.push_back({r, 0, true});
  const auto fits = calibrate(rated, 20, 1, {});
  EXPECT_LT(fits[0].difficulty, -1.0);
  EXPECT_GT(fits[0].difficulty, -6.0);
}

}  // namespace
}  // namespace coapt
