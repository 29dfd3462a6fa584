#include "core/valve/principal_axes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace coapt {
namespace {

TEST(PrincipalAxes, RiseInSpread) {
  Points points(4, 3);
  points << 3, 0, 0, -3, 0, 0, 0, 0, 1, 0, 0, -1;
  const Eigen::Matrix3d axes = principal_axes(points);
  EXPECT_NEAR(std::abs(axes(1, 0)), 1.0, 1e-12) << "nothing along y";
  EXPECT_NEAR(std::abs(axes(2, 1)), 1.0, 1e-12);
  EXPECT_NEAR(std::abs(axes(0, 2)), 1.0, 1e-12);
}

TEST(Eigensystem, HasItsVectorsInTheOrderOfItsValues) {
  Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
  matrix.diagonal() << 5.0, -2.0, 1.0;
  const Eigensystem found = eigensystem(matrix);
  EXPECT_NEAR((found.values - Vec3(-2.0, 1.0, 5.0)).norm(), 0.0, 1e-12);
  for (int k = 0; k < 3; ++k)
    EXPECT_NEAR((matrix * found.vectors.col(k) - found.values[k] * found.vectors.col(k)).norm(),
                0.0, 1e-12);
}

}  // namespace
}  // namespace coapt
