#include "core/valve/mean_point.h"

#include <gtest/gtest.h>

namespace coapt {
namespace {

TEST(MeanPoint, OfOnePointIsThatPoint) {
  Points point(1, 3);
  point << 1.5, -2.0, 7.0;
  EXPECT_EQ(mean_point(point), Vec3(1.5, -2.0, 7.0));
}

TEST(MeanPoint, CountsEveryRowOnceForAnyNumberOfRows) {
  for (int rows = 1; rows <= 20; ++rows) {
    Points points(rows, 3);
    for (int i = 0; i < rows; ++i) points.row(i) << i, 2.0 * i, -3.0 * i;
    const double mean = 0.5 * (rows - 1);
    EXPECT_EQ(mean_point(points), Vec3(mean, 2.0 * mean, -3.0 * mean)) << rows;
  }
}

}  // namespace
}  // namespace coapt
