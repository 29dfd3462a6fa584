#include "search/start_comparison.h"

#include <algorithm>
#include <cmath>

namespace coapt {

StartCheck compare_ends(const ClosureResult& predicted, const ClosureResult& cold,
                        double leak_difference_mm2) {
  const Points& x = predicted.closed_mm;
  const double rms_mm =
      std::sqrt((x - cold.closed_mm).squaredNorm() / static_cast<double>(x.rows()));
  return {1, rms_mm > kElsewhere_mm ? 1 : 0, std::abs(leak_difference_mm2)};
}

StartCheck united(std::span<const StartCheck> checks) {
  StartCheck all;
  for (const StartCheck& check : checks) {
    all.closures += check.closures;
    all.elsewhere += check.elsewhere;
    all.leak_difference_max_mm2 =
        std::max(all.leak_difference_max_mm2, check.leak_difference_max_mm2);
  }
  return all;
}

}  // namespace coapt
