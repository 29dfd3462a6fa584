#include "search/studies/approximation_study.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "search/perturbation.h"
#include "tests/search/studies/study_scene.h"

namespace coapt {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr double kLengthSd_mm = 0.6454972;  // of -1 to 1 mm by 0.25 mm
constexpr double kAngleSd_deg = 3.1622777;  // of -5 to 5 degrees by 1 degree

/// An anchor straight above every tip's own place, so high above it.
std::vector<AnchorSite> above(double by_mm) {
  const Vec3 at(0.0, 0.0, -by_mm);
  return {{"above", 0.25, {at, at, at}}};
}

/// Only 0 and 6 mm along each axis, looked up in a table that closes nothing.
ApproximationStudy study_of(const OrificeOf& area_mm2, const std::vector<AnchorSite>& anchors,
                            Protocol protocol = Protocol::LookupExtended) {
  OrificeTable table = small_table(known_at_nodes(-4, 10, area_mm2));
  ApproximationOptions options;
  options.displacement_step_mm = 6.0;
  const ApproximationStudy study = study_approximation(table, protocol, anchors, options);
  EXPECT_EQ(table.closures(), 0);
  return study;
}

/// Steep to the sides, so that of the displacements of 0 and 6 mm only (0, 0, 6) leaks.
double steep(const Vec3& d) { return 31.0 + 5.0 * (d.z() - 6.0) - 8.0 * d.x() - 8.0 * d.y(); }

/// Over the region's angles.
double mean_cosine() {
  double sum = 0.0;
  for (int a = -5; a <= 5; ++a)
    for (int b = -5; b <= 5; ++b) sum += std::cos(std::hypot(a, b) * kDegree);
  return sum / 121.0;
}

TEST(StudyApproximation, MovesToTheFirstQuarterMillimetreThatIsTight) {
  // 31 - 5 m is below 5 from m = 5.2 on. Only (0, 0, 6) leaks, in each class.
  const ApproximationStudy study = study_of(steep, above(30.0));
  EXPECT_EQ(study.options.displacement_step_mm, 6.0);
  EXPECT_EQ(study.options.region_points, 1089);
  ASSERT_EQ(study.approximations.size(), 3u);
  for (std::size_t k = 0; k < 3; ++k) {
    const Approximation& found = study.approximations[k];
    EXPECT_EQ(found.displaced, kDisplaced[k]);
    EXPECT_EQ(found.displaced_mm, Vec3(0.0, 0.0, 6.0));
    EXPECT_NEAR(found.displaced_area_mm2, 31.0, 1e-12);
    EXPECT_TRUE(found.repaired);
    EXPECT_NEAR(found.movement_mm, 5.25, 1e-12);
    EXPECT_NEAR(found.suture_mm, 30.75, 1e-12);
    EXPECT_NEAR((found.position_mm - Vec3(0.0, 0.0, 0.75)).norm(), 0.0, 1e-12);
    EXPECT_NEAR(found.area_mm2, 4.75, 1e-12);
  }
}

TEST(StudyApproximation, RegionOfALinearFieldIsKnownByHand) {
  const RegionOrifice region = study_of(steep, above(30.0)).approximations.front().region;
  // At (L + l) cos(swing) below the anchor; lengths and angles are independent and centred.
  EXPECT_NEAR(region.mean_mm2, 4.75 - 5.0 * 30.75 * (1.0 - mean_cosine()), 1e-9);
  EXPECT_NEAR(region.length_sd_mm2, 5.0 * mean_cosine() * kLengthSd_mm, 1e-6);
  EXPECT_NEAR(region.length_slope_mm2_per_mm, 5.0 * mean_cosine(), 1e-9);
  // 8 mm2 per mm along both axes, small angles.
  EXPECT_NEAR(region.swing_slope_mm2_per_mm, 8.0 * std::numbers::sqrt2, 0.04);
  const double by_angles = 8.0 * std::numbers::sqrt2 * 30.75 * kAngleSd_deg * kDegree;
  EXPECT_NEAR(region.angle_sd_mm2, by_angles, 0.003 * by_angles);
  EXPECT_NEAR(region.sd_mm2, std::hypot(region.length_sd_mm2, region.angle_sd_mm2),
              0.003 * region.sd_mm2);
  EXPECT_EQ(region.clamped_share, 0.0);
  EXPECT_GT(region.leaking_share, 0.3);
  EXPECT_LT(region.leaking_share, 0.7);
  // Straight away from the anchor 1 mm, swung 5 degrees against both axes.
  const double angle = std::hypot(5.0, 5.0) * kDegree;
  const double side = 31.75 * std::sin(angle) / std::numbers::sqrt2;
  const Vec3 worst(-side, -side, 31.75 * std::cos(angle) - 30.0);
  EXPECT_NEAR(region.worst_mm2, steep(worst), 1e-9);
}

TEST(StudyApproximation, OutwardsAndPosteriorAreTheTablesAxes) {
  // Leaks more the further outwards: the part by angles is of one axis only.
  const ApproximationStudy study = study_of(
      [](const Vec3& d) { return 20.0 + 2.0 * d.x() + 4.0 * (d.z() - 6.0) - 20.0 * d.y(); },
      {{"above", 0.25, {Vec3(0, 0, -30), Vec3(0, 0, -30), Vec3(6, 0, -30)}}});
  for (const Approximation& found : study.approximations) {
    const bool straight = found.displaced == Displaced::Both ? found.displaced_mm.x() == 6.0
                                                             : found.displaced_mm.x() == 0.0;
    if (!straight) continue;
    const double slopes = std::hypot(2.0, 20.0);
    const double expected = slopes * found.suture_mm * kAngleSd_deg * kDegree;
    EXPECT_NEAR(found.region.angle_sd_mm2, expected, 0.003 * expected);
  }
}

TEST(StudyApproximation, TheLastPartOfAMillimetreBeforeHalfWayIsSearchedToo) {
  // Half way is 5.9 mm; below 5 mm2 from 5.5 mm on.
  const Approximation found =
      study_of([](const Vec3& d) { return 15.4 + 1.9 * (d.z() - 6.0) - 16.0 * (d.x() + d.y()); },
               above(5.8))
          .approximations.front();
  EXPECT_TRUE(found.repaired);
  EXPECT_NEAR(found.movement_mm, 5.5, 1e-12);
}

TEST(StudyApproximation, WhatCannotBeRepairedIsLeftWhereItLeaksLeast) {
  // Half of the 10 mm to the anchor: 22 - 3 x 5 mm2 remain.
  const Approximation half =
      study_of([](const Vec3& d) { return 22.0 + 3.0 * (d.z() - 6.0) - 8.0 * (d.x() + d.y()); },
               above(4.0))
          .approximations.front();
  EXPECT_FALSE(half.repaired);
  EXPECT_NEAR(half.movement_mm, 5.0, 1e-12);
  EXPECT_NEAR(half.area_mm2, 7.0, 1e-9);
  // Least after 2 mm, more again after.
  const Approximation valley =
      study_of([](const Vec3& d) { return 10.0 + std::abs(d.z() - 4.0) - 8.0 * (d.x() + d.y()); },
               above(6.0))
          .approximations.back();
  EXPECT_FALSE(valley.repaired);
  EXPECT_NEAR(valley.movement_mm, 2.0, 1e-12);
  EXPECT_NEAR((valley.position_mm - Vec3(0.0, 0.0, 4.0)).norm(), 0.0, 1e-12);
  EXPECT_NEAR(valley.area_mm2, 10.0, 1e-9);
  EXPECT_NEAR(valley.suture_mm, 10.0, 1e-12);
}

TEST(StudyApproximation, AsksOnlyWhatLeaksMoreThanFive) {
  EXPECT_TRUE(study_of([](const Vec3&) { return 5.0; }, above(30.0)).approximations.empty());
  EXPECT_TRUE(
      study_of([](const Vec3&) { return std::numeric_limits<double>::quiet_NaN(); }, above(30.0))
          .approximations.empty());
  // Two anchors: class, displacement, anchor.
  std::vector<AnchorSite> anchors = above(30.0);
  anchors.push_back(above(20.0).front());
  const ApproximationStudy study = study_of(steep, anchors);
  ASSERT_EQ(study.approximations.size(), 6u);
  EXPECT_EQ(study.approximations[2].anchor, 0u);
  EXPECT_EQ(study.approximations[3].anchor, 1u);
  EXPECT_EQ(study.approximations[3].displaced, Displaced::Posteromedial);
  EXPECT_NEAR(study.approximations[3].suture_mm, 20.75, 1e-12);
}

TEST(StudyApproximation, ClampedCountsWhatLiesOutsideTheGrid) {
  // Around (0, 0, 0.75) all nodes lie outside that swing inwards or forwards.
  const Approximation found =
      study_of(steep, above(30.0), Protocol::LookupClamped).approximations.front();
  EXPECT_GT(found.region.clamped_share, 1.0 - 36.0 / 121.0 - 1e-9) << "by the angles";
  EXPECT_LT(found.region.clamped_share, 0.8);
}

/// (0, 0, 6) leaks if the anterolateral muscle is displaced; where it goes from there is closed.
OrificeTableOptions one_leak() {
  OrificeTableOptions options;
  for (const Displaced displaced : kDisplaced)
    for (int i = 0; i < 8; ++i)
      options.known[key_of(displacement(displaced, 6.0 * Vec3(i >> 2 & 1, i >> 1 & 1, i & 1)))] = {
          i == 1 && displaced == Displaced::Anterolateral ? 31.0 : 0.0, 0.0, true};
  return options;
}

double movement_of(const OrificeTableOptions& known) {
  OrificeTable table = small_table(known);
  ApproximationOptions few;
  few.displacement_step_mm = 6.0;
  few.region_points = 17;
  return study_approximation(table, Protocol::Optimum, above(30.0), few)
      .approximations.front()
      .movement_mm;
}

TEST(StudyApproximation, OptimumPassesOverAPlaceThatHasNoOrifice) {
  OrificeTableOptions options = one_leak();
  const double best = movement_of(options);
  EXPECT_EQ(best, std::round(best)) << "by millimetres";
  const Vec3 place(0.0, 0.0, 6.0 - best);
  options.known[key_of(displacement(Displaced::Anterolateral, place))] = {
      std::numeric_limits<double>::quiet_NaN(), 0.0, false};
  EXPECT_NE(movement_of(options), best);
}

/// Optimum on an orifice that is known wherever it asks, from all displacements of 0 and 6 mm that leak
/// more than `least_mm2`.
std::vector<Approximation> optima_of(const OrificeOf& area_mm2, double least_mm2) {
  const std::vector<AnchorSite> anchors = above(30.0);
  const Vec3 mirror(1.0, -1.0, -1.0);  // to the posteromedial muscle's axes and back
  const Vec3 anchor = anchors.front().at_mm.front();
  std::vector<Perturbation> nodes = region_of_interest();
  nodes.resize(17);
  OrificeTableOptions options;
  for (const Displaced displaced : kDisplaced)
    for (int i = 0; i < 8; ++i) {
      const Vec3 from = 6.0 * Vec3(i >> 2 & 1, i >> 1 & 1, i & 1);
      for (int moved = 0; moved <= 15; ++moved)
        for (const Perturbation& node : nodes) {
          const Vec3 tip = from + moved * (anchor - from).normalized();
          const Vec3 place =
              disturbed_tip(tip.cwiseProduct(mirror), anchor.cwiseProduct(mirror), 1.0, node)
                  .cwiseProduct(mirror);
          options.known[key_of(displacement(displaced, place))] = {area_mm2(place), 0.0, true};
        }
    }
  OrificeTable table = small_table(options);
  ApproximationOptions few;
  few.displacement_step_mm = 6.0;
  few.region_points = 17;
  few.least_mm2 = least_mm2;
  const ApproximationStudy study = study_approximation(table, Protocol::Optimum, anchors, few);
  EXPECT_EQ(table.closures(), 0);
  return study.approximations;
}

TEST(StudyApproximation, OptimumLeavesAMuscleWhereMovingItGainsNothing) {
  const std::vector<Approximation> all = optima_of([](const Vec3&) { return 0.0; }, -1.0);
  ASSERT_EQ(all.size(), 24u);
  for (const Approximation& found : all) {
    EXPECT_EQ(found.movement_mm, 0.0);
    EXPECT_EQ(found.position_mm, found.displaced_mm);
    EXPECT_EQ(found.area_mm2, 0.0);
    EXPECT_TRUE(found.repaired);
  }
}

TEST(StudyApproximation, OptimumMovesAsFarAsAMillimetreIsWorthItsPrice) {
  // 0.3 mm2 per mm: one muscle costs 0.2 up to 10 mm and 1.2 from there, both cost twice that.
  const std::vector<Approximation> all =
      optima_of([](const Vec3& d) { return 31.0 + 0.3 * (d.z() - 6.0); }, 30.0);
  ASSERT_EQ(all.size(), 12u);
  for (const Approximation& found : all) {
    EXPECT_EQ(found.movement_mm, found.displaced == Displaced::Both ? 0.0 : 10.0);
    EXPECT_FALSE(found.repaired);
  }
}

}  // namespace
}  // namespace coapt
