// Shares of right answers against chance.
#pragma once

#include <array>

namespace coapt {

/// P(at least `right` of `answers`) by chance alone, exact.
double chance_of_at_least(int right, int answers, double chance);

/// 95 % interval of a share (Wilson 1927). @pre answers > 0.
std::array<double, 2> share_interval(int right, int answers);

/// Answers in each of two groups with these shares of right ones that tell them apart with probability `power`, at 5 %, two-sided (Fleiss
/// 1981, without continuity correction). @pre 0 < share != other < 1, 0 < power < 1.
int answers_to_tell(double share, double other, double power);

/// Quantile of the standard normal distribution, to 1e-9. @pre 0 < share < 1.
double normal_quantile(double share);

}  // namespace coapt
