// Fits a parametric valve to the thesis's own numbers (4.3.1): one porcine valve that is not
// published.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "search/studies/anatomy.h"
#include "search/studies/configuration.h"

namespace coapt {

/// Figure 4.5 at 10, 20, 30 %, the 21 of table 4.1 at 6 mm, and a competent valve (0) undisturbed.
struct CalibrationTarget {
  std::string name;  ///< "AP 10 %", "AL T + A", "undisturbed"
  Configuration configuration;
  double area_mm2 = 0.0;
};
std::vector<CalibrationTarget> calibration_targets();

struct CalibrationOptions {
  std::uint64_t seed = 1;
  /// Random anatomies around the typical one, of which the best is the start.
  int first_looks = 60;
  double spread = 0.2;  ///< of them, share of each range to either side
  int most_rounds = 30;
  double towards_typical = 0.15;  ///< weight of a parameter's distance from typical, in ranges
  int threads = 0;
  /// Rounds done of most_rounds, cost; false stops.
  std::function<bool(int, double)> progress;
};

struct Calibration {
  Anatomy anatomy{};
  std::vector<double> area_mm2;          ///< order of calibration_targets()
  double spearman = 0.0, rms_mm2 = 0.0;  ///< over table 4.1
  double largest_dilation_error = 0.0;   ///< share, over figure 4.5
  int closures = 0;
  int untrusted = 0;  ///< of the closures of the result
};

/// Minimises the squares of sqrt(area + 1) - sqrt(target + 1), plus a little for being untypical.
Calibration calibrate(const CalibrationOptions& options = {});

}  // namespace coapt
