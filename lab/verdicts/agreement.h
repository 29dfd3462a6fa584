// How far two ways of judging the same plans agree: their order, and what they call competent.
#pragma once

#include <vector>

namespace coapt {

/// Pairs of plans of one valve. Counts of several valves add up.
struct PairCount {
  int concordant = 0, discordant = 0;
  int tied_x = 0, tied_y = 0;  ///< in that order alone
  PairCount& operator+=(const PairCount& other);
};

/// Values that are less than `tie` apart, or equal, count as tied. @pre equally long.
PairCount count_pairs(const std::vector<double>& x, const std::vector<double>& y, double tie = 0.0);

/// Kendall's tau-b (Kendall 1945): 1 the same order, -1 the opposite one; NaN if one side has none.
double kendall_tau(const PairCount& pairs);

/// Of verdicts against those of a reference.
struct VerdictCount {
  int plans = 0, agree = 0;
  int false_competent = 0, false_leaks = 0;
  void add(bool competent, bool competent_by_reference);
};

}  // namespace coapt
