#include "search/studies/geometry_studies.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/search/studies/study_scene.h"

namespace coapt {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

std::size_t index_of(const DisplacementGrid& grid, int t, int p, int a) {
  return static_cast<std::size_t>((t * grid.nodes + p) * grid.nodes + a);
}

TEST(DisplacementGrid, PlaceAndIndexBelongTogether) {
  const DisplacementGrid grid = grid_of(
      Displaced::Both, 4, 2.0, [](const Vec3& d) { return 100.0 * d.x() + 10.0 * d.y() + d.z(); });
  for (int t = 0; t < 4; ++t)
    for (int p = 0; p < 4; ++p)
      for (int a = 0; a < 4; ++a) {
        EXPECT_EQ(grid.displacement_mm(index_of(grid, t, p, a)), Vec3(2.0 * t, 2.0 * p, 2.0 * a));
        EXPECT_EQ(grid.at(t, p, a), 200.0 * t + 20.0 * p + 2.0 * a);
      }
}

TEST(LargestOrifices, AreThoseAlongJustTheAxesNamed) {
  // 1, 2, 4 mm2 per mm.
  DisplacementGrid grid = grid_of(Displaced::Both, 3, 1.0,
                                  [](const Vec3& d) { return d.x() + 2.0 * d.y() + 4.0 * d.z(); });
  EXPECT_EQ(largest_orifices(grid), (std::array<double, 7>{2, 4, 8, 6, 10, 12, 14}));
  grid.area_mm2[index_of(grid, 1, 0, 0)] = 11.0;  // in T, T + P, T + A and all
  EXPECT_EQ(largest_orifices(grid), (std::array<double, 7>{11, 4, 8, 11, 11, 12, 14}));
  grid.area_mm2[index_of(grid, 0, 0, 0)] = 13.0;  // in all of them
  EXPECT_EQ(largest_orifices(grid), (std::array<double, 7>{13, 13, 13, 13, 13, 13, 14}));
}

TEST(LargestOrifices, PassOverConfigurationsThatHaveNone) {
  DisplacementGrid grid = grid_of(Displaced::Both, 2, 6.0, [](const Vec3& d) { return d.sum(); });
  grid.area_mm2[index_of(grid, 1, 1, 1)] = kUnknown;
  EXPECT_EQ(largest_orifices(grid), (std::array<double, 7>{6, 6, 6, 12, 12, 12, 12}));
}

TEST(Gradients, OfALinearFieldAreItsSlopesEverywhere) {
  for (const double step : {1.0, 2.0, 6.0}) {
    const DisplacementGrid grid = grid_of(Displaced::Anterolateral, 4, step, [](const Vec3& d) {
      return 7.0 + 3.0 * d.x() - 2.0 * d.y() + 0.5 * d.z();
    });
    const std::vector<Vec3> slopes = gradients(grid);
    ASSERT_EQ(slopes.size(), grid.area_mm2.size());
    for (const Vec3& slope : slopes) EXPECT_NEAR((slope - Vec3(3.0, -2.0, 0.5)).norm(), 0.0, 1e-12);
  }
}

TEST(Gradients, AreCentralInsideAndOneSidedAtTheBorder) {
  const DisplacementGrid grid =
      grid_of(Displaced::Anterolateral, 4, 1.0, [](const Vec3& d) { return d.z() * d.z(); });
  const std::vector<Vec3> slopes = gradients(grid);
  for (const auto& [a, slope] : {std::pair{0, 1.0}, {1, 2.0}, {2, 4.0}, {3, 5.0}})
    EXPECT_EQ(slopes[index_of(grid, 2, 1, a)], Vec3(0.0, 0.0, slope)) << a;
}

PapillaryStudy singles_of_one(int nodes, double step_mm, const OrificeOf& both) {
  const OrificeOf one = [](const Vec3&) { return 1.0; };
  PapillaryStudy study;
  study.grids = {grid_of(Displaced::Anterolateral, nodes, step_mm, one),
                 grid_of(Displaced::Posteromedial, nodes, step_mm, one),
                 grid_of(Displaced::Both, nodes, step_mm, both)};
  return study;
}

TEST(Synergy, CountsConfigurationsAboveTheSumByLeastDisplacement) {
  // Of 4^3 - 1 displaced nodes both exceeds 1 + 1 on the 3^3 from 1 mm along each axis, but for one.
  PapillaryStudy study =
      singles_of_one(4, 1.0, [](const Vec3& d) { return d.minCoeff() >= 1.0 ? 3.0 : 2.0; });
  EXPECT_DOUBLE_EQ(synergy(study).share, 27.0 / 63.0);
  EXPECT_DOUBLE_EQ(synergy(study).share_from_1mm, 1.0);
  study.grids[2].area_mm2[index_of(study.grids[2], 2, 2, 3)] = 2.0;  // equal is not above
  const Synergy found = synergy(study);
  EXPECT_DOUBLE_EQ(found.share, 26.0 / 63.0);
  EXPECT_DOUBLE_EQ(found.share_from_1mm, 26.0 / 27.0);
  EXPECT_DOUBLE_EQ(found.share_from_2mm, 7.0 / 8.0);
  EXPECT_NEAR(found.mean_increase, 26.0 * 0.5 / 63.0, 1e-12);
  EXPECT_NEAR(found.total_increase, (63.0 * 2.0 + 26.0) / (63.0 * 2.0) - 1.0, 1e-12);
}

TEST(Synergy, MeanIncreaseIsOfTheRatiosAndAsksNothingOfTightValves) {
  PapillaryStudy study = singles_of_one(2, 6.0, [](const Vec3&) { return 3.0; });
  auto& [al, pm, both] = study.grids;
  al.area_mm2[1] = pm.area_mm2[1] = 0.4;  // 0.8 mm2 have no meaningful ratio
  both.area_mm2[1] = 80.0;
  al.area_mm2[2] = 9.0;  // 1 + 9, not increased
  both.area_mm2[2] = 10.0;
  const Synergy found = synergy(study);
  EXPECT_NEAR(found.mean_increase, 5.0 * 0.5 / 6.0, 1e-12);
  EXPECT_NEAR(found.total_increase, (80.0 + 10.0 + 15.0) / (0.8 + 10.0 + 10.0) - 1.0, 1e-12);
}

TEST(MeanGradient, OfALinearFieldIsItsSlope) {
  const DisplacementGrid grid = grid_of(Displaced::Both, 4, 2.0, [](const Vec3& d) {
    return 7.0 + 3.0 * d.x() - 2.0 * d.y() + 0.5 * d.z();
  });
  EXPECT_NEAR((mean_gradient(grid) - Vec3(3.0, -2.0, 0.5)).norm(), 0.0, 1e-12);
}

TEST(Synergy, OfAGridOf2mmCountsItsFirstStepForBothLimits) {
  PapillaryStudy study =
      singles_of_one(4, 2.0, [](const Vec3& d) { return d.minCoeff() >= 2.0 ? 3.0 : 2.0; });
  study.grids[2].area_mm2[index_of(study.grids[2], 1, 1, 1)] = 0.0;
  EXPECT_DOUBLE_EQ(synergy(study).share_from_1mm, 26.0 / 27.0);
  EXPECT_DOUBLE_EQ(synergy(study).share_from_2mm, 26.0 / 27.0);
}

TEST(Synergy, DoesNotAskWhereNothingIsDisplaced) {
  PapillaryStudy study = singles_of_one(2, 6.0, [](const Vec3&) { return 3.0; });
  study.grids[2].area_mm2[0] = 1000.0;
  EXPECT_DOUBLE_EQ(synergy(study).share, 1.0);
  EXPECT_NEAR(synergy(study).mean_increase, 0.5, 1e-12);
}

RingStudy ring_study(const std::vector<double>& proper, const std::vector<double>& smallest) {
  RingStudy study;
  for (auto& sizes : study.grids) sizes[0].area_mm2 = sizes[1].area_mm2 = proper;
  study.grids[1][3].area_mm2 = smallest;
  return study;
}

TEST(RingRatios, SayNothingWhereTheProperSizeIsTight) {
  const RingStudy study = ring_study({0.99, 1.0, 10.0, kUnknown}, {5.0, 0.5, 4.0, 1.0});
  const std::vector<double> ratios = ring_ratios(study, Displaced::Posteromedial, 3);
  ASSERT_EQ(ratios.size(), 4u);
  EXPECT_TRUE(std::isnan(ratios[0]));
  EXPECT_DOUBLE_EQ(ratios[1], 0.5);
  EXPECT_DOUBLE_EQ(ratios[2], 0.4);
  EXPECT_TRUE(std::isnan(ratios[3]));
  EXPECT_DOUBLE_EQ(largest_ring_ratio(study, Displaced::Posteromedial, 3), 0.5);
  EXPECT_DOUBLE_EQ(largest_ring_ratio(study, Displaced::Both, 1), 1.0);
}

TEST(RingRatios, WithoutAnyThereIsNoLargest) {
  EXPECT_TRUE(std::isnan(
      largest_ring_ratio(ring_study({0.0, 0.9}, {3.0, 3.0}), Displaced::Posteromedial, 3)));
}

TEST(StudyAnnulus, HasARowForEachHeightWithTheValvesOwnFirst) {
  OrificeTable table = small_table({});
  const AnnulusStudy study = study_annulus(table);
  EXPECT_EQ(study.height_percent, (std::vector<double>{100.0, 75.0, 50.0, 25.0, 0.0}));
  ASSERT_EQ(study.dilation_percent.size(), 31u);
  EXPECT_EQ(study.dilation_percent.back(), 30.0);
  EXPECT_EQ(table.configurations(), 155);
  ASSERT_EQ(study.area_mm2.size(), 5u);
  for (const auto& [h, d] : {std::pair<std::size_t, std::size_t>{0, 0}, {0, 30}, {2, 7}, {4, 30}}) {
    Configuration wanted;
    wanted.change.annular_height_percent = study.height_percent[h];
    wanted.change.ap_dilation_percent = study.dilation_percent[d];
    ASSERT_NE(table.find(wanted), nullptr);
    EXPECT_EQ(study.area_mm2[h][d], table.find(wanted)->area_mm2) << h << ' ' << d;
  }
}

TEST(StudyPapillary, AsksForEachClassInTheOrderOfItsGrid) {
  OrificeTable table = small_table({});
  const PapillaryStudy study = study_papillary(table, 2);
  EXPECT_EQ(table.configurations(), 3 * 7 + 1) << "undisplaced is one of all classes";
  for (std::size_t k = 0; k < 3; ++k) {
    const DisplacementGrid& grid = study.grids[k];
    EXPECT_EQ(grid.displaced, kDisplaced[k]);
    EXPECT_EQ(grid.step_mm, 6.0);
    ASSERT_EQ(grid.area_mm2.size(), 8u);
    for (std::size_t i = 0; i < 8; ++i)
      EXPECT_EQ(grid.area_mm2[i],
                table.find(displacement(kDisplaced[k], grid.displacement_mm(i)))->area_mm2);
  }
}

TEST(StudyRing, HasFourSizesForEachClassAndUndisplacedOnlyOnceForEachSize) {
  // Known in advance, each another orifice.
  OrificeTableOptions options;
  for (int sizes = 0; sizes < 4; ++sizes)
    for (const Displaced displaced : kDisplaced)
      for (int i = 0; i < 64; ++i)
        options
            .known[key_of(displacement(displaced, 2.0 * Vec3(i / 16, i / 4 % 4, i % 4), sizes))] = {
            1000.0 * sizes + 100.0 * static_cast<int>(displaced) + i, 0.0, true};
  OrificeTable table = small_table(options);
  const RingStudy study = study_ring(table);
  EXPECT_EQ(table.closures(), 0);
  EXPECT_EQ(table.configurations(), 4 * (3 * 63 + 1));
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t sizes = 0; sizes < 4; ++sizes) {
      const DisplacementGrid& grid = study.grids[k][sizes];
      EXPECT_EQ(grid.displaced, kDisplaced[k]);
      EXPECT_EQ(grid.ring_sizes_below, static_cast<int>(sizes));
      EXPECT_EQ(grid.step_mm, 2.0);
      ASSERT_EQ(grid.area_mm2.size(), 64u);
      for (std::size_t i = 1; i < 64; ++i)
        EXPECT_EQ(grid.area_mm2[i], static_cast<double>(1000 * sizes + 100 * k + i));
    }
}

}  // namespace
}  // namespace coapt
