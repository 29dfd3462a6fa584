#include "search/rank_correlation.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace coapt {
namespace {

std::vector<double> ranks(const std::vector<double>& values) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t i, std::size_t j) { return values[i] < values[j]; });
  std::vector<double> rank(values.size());
  for (std::size_t first = 0; first < order.size();) {
    std::size_t end = first + 1;
    while (end < order.size() && values[order[end]] == values[order[first]]) ++end;
    for (std::size_t i = first; i < end; ++i)
      rank[order[i]] = 0.5 * static_cast<double>(first + end - 1);
    first = end;
  }
  return rank;
}

}  // namespace

double rank_correlation(const std::vector<double>& x, const std::vector<double>& y) {
  const std::vector<double> p = ranks(x), q = ranks(y);
  const double mean = 0.5 * (static_cast<double>(x.size()) - 1.0);
  double pq = 0.0, pp = 0.0, qq = 0.0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    pq += (p[i] - mean) * (q[i] - mean);
    pp += (p[i] - mean) * (p[i] - mean);
    qq += (q[i] - mean) * (q[i] - mean);
  }
  return pq / std::sqrt(pp * qq);
}

}  // namespace coapt
