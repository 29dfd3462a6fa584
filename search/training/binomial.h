// Shares of right answers against chance, and how many learners a study needs.
#pragma once

#include <array>

namespace coapt {

/// P(at least `right` of `answers`) by chance alone, exact.
double chance_of_at_least(int right, int answers, double chance);

/// 95 % interval of a share (Wilson 1927). @pre answers > 0.
std::array<double, 2> share_interval(int right, int answers);

/// Quantile of the standard normal distribution, to 1e-9. @pre 0 < share < 1.
double normal_quantile(double share);

struct PowerQuestion {
  double before = 0.25, after = 0.45;  ///< shares of right answers of the two groups
  double power = 0.8;
  double significance = 0.05;  ///< two-sided
  /// Answers of one person are alike: variance of a group's share over that of as many independent answers.
  double design_effect = 1.0;
};

/// Answers that each of two groups must give, not rounded up (two proportions, normal approximation, pooled where they do not differ;
/// Fleiss 1981 without the correction for continuity).
double answers_per_group(const PowerQuestion& question);

}  // namespace coapt
