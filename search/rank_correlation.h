#pragma once

#include <vector>

namespace coapt {

/// Spearman's: Pearson's correlation of the ranks, equal values sharing their mean rank. NaN if
/// there are fewer than two values or one side is constant. @pre equally long, finite.
double rank_correlation(const std::vector<double>& x, const std::vector<double>& y);

}  // namespace coapt
