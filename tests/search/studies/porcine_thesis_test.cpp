// Presets fitted to the thesis's chapter 4: what they were fitted to, what they predict, and where the
// trigone is the better anchor on them. Reduced grids; `coapt study thesis porcine-thesis` has the full ones.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/presets/presets.h"
#include "search/rank_correlation.h"
#include "search/studies/anchor_summary.h"
#include "search/studies/calibration.h"
#include "search/studies/geometry_studies.h"
#include "search/studies/thesis_figures.h"

namespace coapt {
namespace {

/// The default closure, one end state.
OrificeTable table_of(const std::string& preset) { return OrificeTable(*make_preset(preset), {}); }

class PorcineThesis : public testing::TestWithParam<const char*> {};

TEST_P(PorcineThesis, GivesFigure45AndTable41AsFitted) {
  OrificeTable table = table_of(GetParam());
  const std::vector<CalibrationTarget> targets = calibration_targets();
  std::vector<Configuration> wanted;
  for (const CalibrationTarget& target : targets) wanted.push_back(target.configuration);
  const std::vector<OrificeSample> ours = table.at(wanted);
  EXPECT_EQ(table.untrusted(), 0);
  for (std::size_t k = 0; k < 3; ++k)
    EXPECT_NEAR(ours[k].area_mm2, targets[k].area_mm2, std::max(2.5, 0.15 * targets[k].area_mm2))
        << targets[k].name;
  std::vector<double> fitted, theirs;
  double squares = 0.0;
  for (std::size_t k = 3; k < 24; ++k) {
    fitted.push_back(ours[k].area_mm2);
    theirs.push_back(targets[k].area_mm2);
    squares += std::pow(fitted.back() - theirs.back(), 2);
  }
  EXPECT_GE(rank_correlation(fitted, theirs), 0.98);
  EXPECT_LE(std::sqrt(squares / 21.0), 8.0);
  EXPECT_LE(ours[24].area_mm2, 2.0);
}

TEST_P(PorcineThesis, PredictsTable42WithoutBeingFittedToIt) {
  OrificeTable table = table_of(GetParam());
  double off = 0.0;
  for (std::size_t k = 0; k < kDisplaced.size(); ++k) {
    const DisplacementGrid proper = displacement_grid(table, kDisplaced[k], 2, 6.0);
    for (int sizes = 1; sizes <= 3; ++sizes) {
      const DisplacementGrid ring = displacement_grid(table, kDisplaced[k], 2, 6.0, sizes);
      double largest = 0.0;
      for (std::size_t i = 0; i < proper.area_mm2.size(); ++i)
        if (proper.area_mm2[i] >= kRatioFrom_mm2)
          largest = std::max(largest, 100.0 * ring.area_mm2[i] / proper.area_mm2[i]);
      EXPECT_LT(largest, 100.0);
      off += std::abs(largest - thesis::kRingRatio_percent[k][static_cast<std::size_t>(sizes - 1)]);
    }
  }
  EXPECT_LE(off / 9.0, 6.0);
}

INSTANTIATE_TEST_SUITE_P(Presets, PorcineThesis,
                         testing::Values("porcine-thesis", "porcine-thesis-tables"));

/// Means over displacements of 6 mm along any axes that leak more than `least_mm2`.
struct Anchors {
  AnchorSummary trigone, peak;
};

Anchors compare(OrificeTable& table, Protocol protocol, Displaced displaced,
                const ApproximationOptions& options) {
  const std::vector<AnchorSummary> all =
      summarise(study_approximation(table, protocol, thesis_anchors(table.valve()), options));
  for (std::size_t i = 0; i + 1 < all.size(); ++i)
    if (all[i].displaced == displaced && all[i].anchor.name == "trigone")
      return {all[i], all[i + 1]};
  ADD_FAILURE() << "no configuration leaks";
  return {};
}

constexpr ApproximationOptions kWholeRegion = {6.0, 1089, 5.0}, kFewPoints = {6.0, 17, 5.0},
                               kLargeLeaks = {6.0, 17, 60.0};

TEST(OptimalAnchorIsTheTrigone, ByTheThesissLookUpWhicheverMuscleIsDisplaced) {
  OrificeTable table = table_of("porcine-thesis");
  for (const Displaced displaced : kDisplaced) {
    const Anchors anchors = compare(table, Protocol::LookupClamped, displaced, kWholeRegion);
    EXPECT_LT(anchors.trigone.mean_mm2, anchors.peak.mean_mm2) << to_string(displaced);
    EXPECT_LT(anchors.trigone.sd_mm2, anchors.peak.sd_mm2) << to_string(displaced);
  }
}

TEST(OptimalAnchorIsTheTrigone, WithEveryPositionClosedIfOneMuscleIsDisplacedButNotIfBothAre) {
  OrificeTable table = table_of("porcine-thesis");
  for (const Displaced displaced : kDisplaced) {
    const Anchors anchors = compare(table, Protocol::Closed, displaced, kFewPoints);
    const bool both = displaced == Displaced::Both;
    EXPECT_EQ(anchors.trigone.mean_mm2 > anchors.peak.mean_mm2, both) << to_string(displaced);
    EXPECT_EQ(anchors.trigone.length_sd_mm2 > anchors.peak.length_sd_mm2, both)
        << to_string(displaced);
    EXPECT_EQ(anchors.trigone.sd_mm2 > anchors.peak.sd_mm2, both)
        << to_string(displaced) << ": " << anchors.trigone.sd_mm2 << ", " << anchors.peak.sd_mm2;
  }
}

TEST(OptimalAnchorIsTheSaddlePeak, ByLessThanAMm2WhereEachHasItsOwnBestSutureLength) {
  OrificeTable table = table_of("porcine-thesis");
  for (const Displaced displaced : {Displaced::Posteromedial, Displaced::Both}) {
    const Anchors anchors = compare(table, Protocol::Optimum, displaced, kLargeLeaks);
    for (const AnchorSummary& anchor : {anchors.trigone, anchors.peak}) {
      EXPECT_LE(anchor.leaking_share, 0.05) << to_string(displaced);
      EXPECT_LT(anchor.mean_mm2, 2.0) << to_string(displaced);
    }
    EXPECT_GT(anchors.trigone.mean_mm2, anchors.peak.mean_mm2) << to_string(displaced);
    EXPECT_LT(anchors.trigone.mean_mm2, anchors.peak.mean_mm2 + 1.0) << to_string(displaced);
    EXPECT_NEAR(anchors.trigone.movement_mm, anchors.peak.movement_mm, 2.0) << to_string(displaced);
  }
}

}  // namespace
}  // namespace coapt
