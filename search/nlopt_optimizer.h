// Local optimisation within bounds: BOBYQA (Powell 2009), which models the valley, Sbplx (Rowan
// 1990) and Nelder-Mead (1965), which only compare. The only part of coapt that knows NLopt.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace coapt {

enum class LocalMethod { Bobyqa, Sbplx, NelderMead };

struct BoundedProblem {
  std::vector<double> lower, upper, start;  ///< |n|, start within the bounds
  /// |n|, > 0: where the optimiser first looks; cut to 0.49 of the range.
  std::vector<double> first_step;
  double tolerance = 0.1;  ///< stop when steps are shorter than this share of the first
  int most_calls = 100;
  LocalMethod method = LocalMethod::Bobyqa;
};

/// Cost at a point, or nothing to stop. Points are always within the bounds.
using PointCostAt = std::function<std::optional<double>(const std::vector<double>&)>;

/// Calls `cost` until it is satisfied, told to stop, or out of calls; whoever calls keeps the best.
/// Rounding on a plateau is an end like any other.
void minimise(const BoundedProblem& problem, const PointCostAt& cost, std::uint64_t seed);

}  // namespace coapt
