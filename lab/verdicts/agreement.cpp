#include "lab/verdicts/agreement.h"

#include <cmath>

namespace coapt {
namespace {

int order_of(double a, double b, double tie) {
  if (a == b || std::abs(a - b) < tie) return 0;
  return a < b ? -1 : 1;
}

}  // namespace

PairCount& PairCount::operator+=(const PairCount& other) {
  concordant += other.concordant;
  discordant += other.discordant;
  tied_x += other.tied_x;
  tied_y += other.tied_y;
  return *this;
}

PairCount count_pairs(const std::vector<double>& x, const std::vector<double>& y, double tie) {
  PairCount pairs;
  for (std::size_t i = 0; i < x.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const int in_x = order_of(x[i], x[j], tie), in_y = order_of(y[i], y[j], tie);
      pairs.concordant += in_x * in_y > 0;
      pairs.discordant += in_x * in_y < 0;
      pairs.tied_x += in_x == 0 && in_y != 0;
      pairs.tied_y += in_x != 0 && in_y == 0;
    }
  return pairs;
}

double kendall_tau(const PairCount& pairs) {
  const double both = pairs.concordant + pairs.discordant;
  return (pairs.concordant - pairs.discordant) /
         std::sqrt((both + pairs.tied_x) * (both + pairs.tied_y));
}

void VerdictCount::add(bool competent, bool competent_by_reference) {
  ++plans;
  agree += competent == competent_by_reference;
  false_competent += competent && !competent_by_reference;
  false_leaks += !competent && competent_by_reference;
}

}  // namespace coapt
