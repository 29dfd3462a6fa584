// How well a rater agrees with themselves, and two raters with each other.
#pragma once

#include <optional>

#include "search/preference/comparison.h"

namespace coapt {

/// Share of the repeated pairs that were answered as the first time; none without repeats. Sides do not count.
std::optional<double> consistency(const std::vector<GivenAnswer>& given);

struct Agreement {
  int pairs = 0;       ///< that both answered; of each the first answer
  double share = 0.0;  ///< answered alike
  /// Cohen (1960, Educ Psychol Meas 20:37), of three answers: the plan that the search ranked higher, the other one, cannot
  /// tell. 1: always alike, 0: as by chance. None without common pairs, or where both always gave the same answer.
  std::optional<double> kappa;
};
Agreement agreement(const std::vector<GivenAnswer>& one, const std::vector<GivenAnswer>& other);

}  // namespace coapt
