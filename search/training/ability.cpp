#include "search/training/ability.h"

#include <algorithm>
#include <cmath>

namespace coapt {
namespace {

constexpr double kAbility_sd = 1.5;
constexpr double kDifficulty_sd = 2.0, kLogSlope_sd = 0.3;
constexpr double kGridEnd = 6.0;
constexpr int kGridPoints = 121;
constexpr int kRounds = 200, kNewtonSteps = 8;
constexpr double kStill = 1e-6;

double grid_ability(int at) { return kGridEnd * (2.0 * at / (kGridPoints - 1) - 1.0); }

std::vector<double> prior_weights() {
  std::vector<double> weights;
  for (int k = 0; k < kGridPoints; ++k)
    weights.push_back(std::exp(-0.5 * std::pow(grid_ability(k) / kAbility_sd, 2)));
  return weights;
}

void normalise(std::vector<double>& weights) {
  double sum = 0.0;
  for (const double weight : weights) sum += weight;
  for (double& weight : weights) weight /= sum;
}

/// Expected answers to an item at each ability of the grid.
struct ExpectedAnswers {
  std::vector<double> all = std::vector<double>(kGridPoints, 0.0);
  std::vector<double> right = std::vector<double>(kGridPoints, 0.0);
};

/// Derivatives of the expected logarithm of the posterior along (difficulty, log slope); information is minus the expected
/// second ones.
struct Climb {
  double towards_difficulty = 0.0, towards_slope = 0.0;
  double info_difficulty = 0.0, info_slope = 0.0, info_both = 0.0;
};

Climb climb_at(const ExpectedAnswers& answers, const ItemFit& item, double chance) {
  Climb climb;
  climb.towards_difficulty = -item.difficulty / (kDifficulty_sd * kDifficulty_sd);
  climb.info_difficulty = 1.0 / (kDifficulty_sd * kDifficulty_sd);
  climb.towards_slope = -std::log(item.slope) / (kLogSlope_sd * kLogSlope_sd);
  climb.info_slope = 1.0 / (kLogSlope_sd * kLogSlope_sd);
  for (int k = 0; k < kGridPoints; ++k) {
    const auto at = static_cast<std::size_t>(k);
    if (answers.all[at] <= 0.0) continue;
    const double distance = grid_ability(k) - item.difficulty;
    const double logistic = 1.0 / (1.0 + std::exp(-item.slope * distance));
    const double p = chance + (1.0 - chance) * logistic;
    const double rise = (1.0 - chance) * logistic * (1.0 - logistic);  // dp / d(slope distance)
    const double pull = (answers.right[at] - answers.all[at] * p) / (p * (1.0 - p)) * rise;
    const double info = answers.all[at] * rise * rise / (p * (1.0 - p));
    climb.towards_difficulty -= item.slope * pull;
    climb.towards_slope += item.slope * distance * pull;
    climb.info_difficulty += item.slope * item.slope * info;
    climb.info_slope += item.slope * distance * item.slope * distance * info;
    climb.info_both -= item.slope * item.slope * distance * info;
  }
  return climb;
}

/// Fisher's scoring. @return the longest step of the difficulty.
double maximise(const ExpectedAnswers& answers, const CalibrationOptions& options, ItemFit& item) {
  double moved = 0.0;
  for (int step = 0; step < kNewtonSteps; ++step) {
    const Climb climb = climb_at(answers, item, options.chance);
    double by = climb.towards_difficulty / climb.info_difficulty, by_slope = 0.0;
    if (options.slopes) {
      const double determinant =
          climb.info_difficulty * climb.info_slope - climb.info_both * climb.info_both;
      by = (climb.info_slope * climb.towards_difficulty - climb.info_both * climb.towards_slope) /
           determinant;
      by_slope = (climb.info_difficulty * climb.towards_slope -
                  climb.info_both * climb.towards_difficulty) /
                 determinant;
    }
    by = std::clamp(by, -1.0, 1.0);
    by_slope = std::clamp(by_slope, -0.3, 0.3);
    item.difficulty += by;
    item.slope *= std::exp(by_slope);
    moved = std::max({moved, std::abs(by), std::abs(by_slope)});
    if (std::max(std::abs(by), std::abs(by_slope)) < kStill) break;
  }
  item.difficulty_se = 1.0 / std::sqrt(climb_at(answers, item, options.chance).info_difficulty);
  return moved;
}

}  // namespace

double probability_right(double ability, const Response& item) {
  return item.chance +
         (1.0 - item.chance) / (1.0 + std::exp(-item.slope * (ability - item.difficulty)));
}

Ability ability_of(const std::vector<Response>& responses) {
  std::vector<double> weights = prior_weights();
  for (const Response& response : responses) {
    for (int k = 0; k < kGridPoints; ++k) {
      const double p = probability_right(grid_ability(k), response);
      weights[static_cast<std::size_t>(k)] *= response.right ? p : 1.0 - p;
    }
    normalise(weights);
  }
  normalise(weights);
  double mean = 0.0, square = 0.0;
  for (int k = 0; k < kGridPoints; ++k) {
    mean += weights[static_cast<std::size_t>(k)] * grid_ability(k);
    square += weights[static_cast<std::size_t>(k)] * grid_ability(k) * grid_ability(k);
  }
  return {mean, std::sqrt(std::max(0.0, square - mean * mean))};
}

double difficulty_for(double ability, double chance, double target) {
  const double known = (target - chance) / (1.0 - chance);
  return ability - std::log(known / (1.0 - known));
}

std::vector<ItemFit> calibrate(const std::vector<RatedItem>& rated, int raters, int items,
                               const CalibrationOptions& options) {
  std::vector<ItemFit> fits(static_cast<std::size_t>(items));
  std::vector<std::vector<RatedItem>> of_rater(static_cast<std::size_t>(raters));
  for (const RatedItem& answer : rated) {
    of_rater[static_cast<std::size_t>(answer.rater)].push_back(answer);
    ++fits[static_cast<std::size_t>(answer.item)].answers;
  }
  for (int round = 0; round < kRounds; ++round) {
    std::vector<ExpectedAnswers> expected(fits.size());
    for (const std::vector<RatedItem>& answers : of_rater) {
      std::vector<double> weights = prior_weights();
      for (const RatedItem& answer : answers) {
        const ItemFit& fit = fits[static_cast<std::size_t>(answer.item)];
        for (int k = 0; k < kGridPoints; ++k) {
          const double p = probability_right(
              grid_ability(k), {answer.right, fit.difficulty, options.chance, fit.slope});
          weights[static_cast<std::size_t>(k)] *= answer.right ? p : 1.0 - p;
        }
        normalise(weights);
      }
      for (const RatedItem& answer : answers) {
        ExpectedAnswers& of_item = expected[static_cast<std::size_t>(answer.item)];
        for (std::size_t k = 0; k < weights.size(); ++k) {
          of_item.all[k] += weights[k];
          if (answer.right) of_item.right[k] += weights[k];
        }
      }
    }
    double moved = 0.0;
    for (std::size_t i = 0; i < fits.size(); ++i)
      moved = std::max(moved, maximise(expected[i], options, fits[i]));
    if (moved < 1e-4) break;
  }
  return fits;
}

}  // namespace coapt
