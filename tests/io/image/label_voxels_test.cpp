#include "io/image/label_voxels.h"

#include <gtest/gtest.h>

#include "tests/io/image/drawn_labels.h"

namespace coapt {
namespace {

constexpr std::array<Index, 3> kBowl = {70, 70, 70};

/// A bowl of 1.6 mm thickness about an axis in no plane of voxels, without what lies below `from_mm` along x.
double flat_share(double from_mm, double voxel_mm = 0.75) {
  const Vec3 axis = Vec3(1, 2, 3).normalized();
  Eigen::Matrix4d frame = Eigen::Matrix4d::Identity();
  frame.topLeftCorner<3, 3>() *= voxel_mm;
  frame.topRightCorner<3, 1>().setConstant(-0.5 * voxel_mm * static_cast<double>(kBowl[0] - 1));
  const LabelMap map = drawn_labels(kBowl, frame, [&](const Vec3& point) {
    const double along = axis.dot(point), aside = (point - along * axis).norm();
    return point.x() >= from_mm && aside < 16.0 &&
           std::abs(along + 6.0 - aside * aside / 20.0) < 0.8;
  });
  const LabelVoxels voxels(map, {0, 1});
  const LabelBox box = voxels.box();
  return static_cast<double>(voxels.flat_end(box)) / static_cast<double>(box.count);
}

TEST(LabelVoxels, ASheetThatWasCutEndsFlat) {
  EXPECT_LT(flat_share(-1e9), 0.0175) << "whole";
  EXPECT_LT(flat_share(-1e9, 0.5), 0.0175) << "whole, finer";
  for (const double from_mm : {-9.0, -4.0, 0.0}) EXPECT_GT(flat_share(from_mm), 0.0175) << from_mm;
  EXPECT_GT(flat_share(-4.0, 0.5), 0.0175);
}

}  // namespace
}  // namespace coapt
