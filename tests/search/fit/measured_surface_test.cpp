#include "search/fit/measured_surface.h"

#include <gtest/gtest.h>

#include "search/fit/correlated_noise.h"

namespace coapt {
namespace {

/// One triangle in the plane z = 0, its normal up.
ClosedSurface triangle(double thickness_mm) {
  ClosedSurface surface;
  surface.closed_mm.resize(3, 3);
  surface.closed_mm << 0, 0, 0, 10, 0, 0, 0, 10, 0;
  surface.faces.resize(1, 3);
  surface.faces << 0, 1, 2;
  surface.thickness_mm = {thickness_mm};
  return surface;
}

TEST(MeasuredSurface, DistancesAreCountedFromTheSideThatWasMeasured) {
  Points points(3, 3);
  points << 2, 2, 1, 2, 2, -1, -3, 2, -4;  // above, below, beyond the edge
  const std::vector<double> middle =
      signed_distances_mm(points, triangle(1.0), MeasuredSide::Middle);
  EXPECT_DOUBLE_EQ(middle[0], 1.0);
  EXPECT_DOUBLE_EQ(middle[1], -1.0);
  EXPECT_DOUBLE_EQ(middle[2], 5.0);
  const std::vector<double> atrial =
      signed_distances_mm(points, triangle(1.0), MeasuredSide::Atrial);
  EXPECT_DOUBLE_EQ(atrial[0], 0.5);
  EXPECT_DOUBLE_EQ(atrial[1], -1.5);
}

TEST(MeasuredSurface, ThinningKeepsPointsOfItsInput) {
  Points points(1000, 3);
  for (Eigen::Index i = 0; i < points.rows(); ++i) points.row(i) << 0.05 * double(i), 0.0, 0.0;
  const Points kept = thinned(points, 100);
  EXPECT_LE(kept.rows(), 100);
  EXPECT_GT(kept.rows(), 60);
  for (Eigen::Index i = 0; i < kept.rows(); ++i)
    EXPECT_NEAR(std::remainder(kept(i, 0), 0.05), 0.0, 1e-9);
  EXPECT_EQ(thinned(points, 1000), points);
}

TEST(CorrelatedNoise, PointsFarApartAreIndependent) {
  Points points(4, 3);
  points << 0, 0, 0, 100, 0, 0, 200, 0, 0, 300, 0, 0;
  const CorrelatedNoise noise = correlated_noise(points, {1.0, 1.0, -1.0, 1.0});
  EXPECT_DOUBLE_EQ(noise.sd_mm, 1.0);
  EXPECT_DOUBLE_EQ(noise.independent, 4.0);
}

TEST(CorrelatedNoise, PointsThatErrAlikeCountAsOne) {
  Points points(4, 3);
  points << 0, 0, 0, 0.1, 0, 0, 0.2, 0, 0, 0.3, 0, 0;
  EXPECT_DOUBLE_EQ(correlated_noise(points, {2.0, 2.0, 2.0, 2.0}).independent, 1.0);
}

TEST(CorrelatedNoise, TwoBunchesOfPointsCountAsTwo) {
  Points points(4, 3);
  points << 0, 0, 0, 0.1, 0, 0, 50, 0, 0, 50.1, 0, 0;
  EXPECT_DOUBLE_EQ(correlated_noise(points, {1.0, 1.0, -1.0, -1.0}).independent, 2.0);
}

}  // namespace
}  // namespace coapt
