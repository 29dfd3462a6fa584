// Ability of learners and difficulty of cases: the two-parameter logistic model with guessing (Birnbaum 1968; Rasch 1960 with slope 1).
//
//   P(right) = c + (1 - c) / (1 + exp(-slope (ability - difficulty)))
//
// c is the share of right answers by chance and is given, not fitted: 1/4 of four choices, 1/3 of three kinds. Abilities are normal
// with mean 0 and standard deviation 1.5 before anything was answered (assumed: wide enough that thirty trials decide), so that who has all
// right or all wrong has an ability, too. Expectations are sums over a grid of abilities.
#pragma once

#include <vector>

#include "search/training/training_trial.h"

namespace coapt {

double probability_right(double ability, const Response& item);

struct Ability {
  double value = 0.0;           ///< expected
  double standard_error = 1.5;  ///< standard deviation that is left
};
/// Answers are taken to be independent, given the ability.
Ability ability_of(const std::vector<Response>& responses);

/// Of a case that a learner of this ability gets right with probability `target`, slope 1. @pre chance < target < 1.
double difficulty_for(double ability, double chance, double target);

/// An answer of a rater to an item, both counted from 0.
struct RatedItem {
  int rater = 0, item = 0;
  bool right = false;
};

struct ItemFit {
  int answers = 0;
  double difficulty = 0.0, slope = 1.0;
  double difficulty_se = 0.0;  ///< given the slope
};

struct CalibrationOptions {
  double chance = 0.25;
  bool slopes = false;  ///< fitted, too (2PL); else 1 (Rasch)
};

/// Marginal maximum likelihood by expectation and maximisation (Bock and Aitkin 1981), with normal priors on difficulties (mean 0, sd 2) and
/// logarithms of slopes (sd 0.3), which keep items that all or none got right finite. @return by item.
std::vector<ItemFit> calibrate(const std::vector<RatedItem>& rated, int raters, int items,
                               const CalibrationOptions& options = {});

}  // namespace coapt
