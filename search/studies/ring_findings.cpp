#include "search/studies/ring_findings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "search/rank_correlation.h"
#include "search/studies/finding_text.h"
#include "search/studies/thesis_figures.h"

namespace coapt {
namespace {

constexpr double kRatioTolerance = 6.0;     // points, mean absolute error over table 4.2
constexpr double kNoIncrease_mm2 = 0.1;     // what a closure's orifice is known to
constexpr double kLeastRingLeak_mm2 = 5.0;  // smaller orifices have no meaningful ratio

/// Of the orifice under any ring over that under the proper size.
double largest_increase(const RingStudy& study) {
  double largest = -std::numeric_limits<double>::infinity();
  for (const auto& sizes : study.grids)
    for (std::size_t ring = 1; ring < sizes.size(); ++ring)
      for (std::size_t i = 0; i < sizes[ring].area_mm2.size(); ++i)
        largest = std::max(largest, sizes[ring].area_mm2[i] - sizes[0].area_mm2[i]);
  return largest;
}

/// Growth per mm of apical displacement over its last step, mean over the other axes.
double last_growth(const DisplacementGrid& grid) {
  const int last = grid.nodes - 1;
  double sum = 0.0;
  for (int t = 0; t <= last; ++t)
    for (int p = 0; p <= last; ++p) sum += grid.at(t, p, last) - grid.at(t, p, last - 1);
  return sum / (grid.nodes * grid.nodes * grid.step_mm);
}

Finding growth_finding(const RingStudy& study, Displaced displaced) {
  const auto& sizes = study.grids[static_cast<int>(displaced)];
  const double proper = last_growth(sizes[0]), ring = last_growth(sizes[1]);
  return {std::string("orifice-grows-faster-under-a-ring-") + to_string(displaced),
          "4.4.2",
          "an undersized ring leaves the valve more sensitive to further displacement",
          in_words(ring, 1) + " mm2 per mm under U1, " + in_words(proper, 1) +
              " under the proper size (last 2 mm of apical displacement)",
          "faster under U1",
          ring > proper};
}

Finding lateral_finding(const RingStudy& study) {
  const auto share = [](const DisplacementGrid& grid) {
    const Vec3 slope = mean_gradient(grid);
    return slope.x() / slope.z();
  };
  const double proper = share(study.grids[2][0]), ring = share(study.grids[2][2]);
  return {"lateral-sensitivity-nears-apical-under-a-ring",
          "4.3.2",
          "under a ring the sensitivity to lateral displacement of both nears the apical one",
          in_percent(ring) + " of the apical one under U2, " + in_percent(proper) +
              " under the proper size",
          "a larger share under U2",
          ring > proper};
}

}  // namespace

std::vector<Finding> ring_findings(const RingStudy& study) {
  std::vector<Finding> all;
  double off = 0.0, largest = std::numeric_limits<double>::quiet_NaN();
  std::string text;
  std::array<double, 3> mean_of_class{};
  bool falls = true;
  for (std::size_t k = 0; k < kDisplaced.size(); ++k) {
    std::vector<double> row;
    for (int sizes = 1; sizes <= 3; ++sizes) {
      row.push_back(100.0 * largest_ring_ratio(study, kDisplaced[k], sizes));
      off += std::abs(row.back() - thesis::kRingRatio_percent[k][row.size() - 1]) / 9.0;
      largest = std::fmax(largest, row.back());
      mean_of_class[k] += row.back() / 3.0;
    }
    falls &= row[0] > row[1] && row[1] > row[2];
    text +=
        (text.empty() ? "" : "; ") + std::string(to_string(kDisplaced[k])) + ' ' + in_words(row);
  }
  if (std::isnan(largest)) return all;  // nothing leaks under the proper size: nothing to ask
  all.push_back({"undersized-ring-always-reduces", "4.3.2",
                 "an undersized ring reduces the orifice in all configurations",
                 "largest ratio " + in_words(largest, 1) + " %; at most " +
                     in_words(largest_increase(study), 1) + " mm2 more than under the proper size",
                 "nowhere more than 0.1 mm2 more", largest_increase(study) <= kNoIncrease_mm2});
  all.push_back({"table-4.2", "4.3.2",
                 "AL 54.5 / 27.3 / 13.0; PM 75.4 / 52.8 / 32.4; both 81.9 / 64.1 / 47.3 %",
                 text + " %; mean absolute difference " + in_words(off, 1) + " points",
                 "mean absolute difference at most 6 points", off <= kRatioTolerance});
  all.push_back(
      {"ring-works-least-when-both-move", "4.3.2",
       "the ratio is largest for both, then PM, then AL, and falls with each size", text,
       "in that order",
       falls && mean_of_class[2] > mean_of_class[1] && mean_of_class[1] > mean_of_class[0]});
  for (int sizes = 1; sizes <= 2; ++sizes) {
    std::vector<double> ratio, size;
    const std::vector<double> ratios = ring_ratios(study, Displaced::Both, sizes);
    const DisplacementGrid& grid = study.grids[2][0];
    for (std::size_t i = 0; i < ratios.size(); ++i) {
      if (!(grid.area_mm2[i] >= kLeastRingLeak_mm2)) continue;
      ratio.push_back(ratios[i]);
      size.push_back(grid.displacement_mm(i).norm());
    }
    const double rho = rank_correlation(ratio, size);
    all.push_back({"ring-ratio-grows-with-displacement-U" + std::to_string(sizes), "4.3.2",
                   "the ratio to the properly sized annulus rises towards 1 with displacement",
                   "Spearman " + in_words(rho, 2) + " of ratio and displacement, both muscles",
                   "above 0.5", rho > 0.5});
  }
  for (const Displaced displaced : kDisplaced) all.push_back(growth_finding(study, displaced));
  all.push_back(lateral_finding(study));
  return all;
}

}  // namespace coapt
