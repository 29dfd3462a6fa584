#include "io/image/image_geometry.h"

#include <gtest/gtest.h>

#include "tests/io/image/drawn_labels.h"

namespace coapt {
namespace {

const std::array<Index, 3> kSize = {4, 5, 6};
const Eigen::Matrix4d kFrame = oblique_frame(kSize, {0.5, 0.6, 0.7}, false);

LabelMap map_at(const Eigen::Matrix4d& frame, bool placed) {
  LabelMap map = drawn_labels(kSize, frame, [](const Vec3&) { return true; });
  map.placed = placed;
  return map;
}

TEST(ImageGeometry, AMapWithoutAFrameTakesThatOfItsImages) {
  LabelMap map = map_at(Eigen::Matrix4d::Identity(), false);
  const Expected<std::string> said = place(map, {kSize, kFrame, true});
  ASSERT_TRUE(said);
  EXPECT_EQ(map.to_lps_mm, kFrame);
  EXPECT_TRUE(map.placed);
  EXPECT_EQ(*said,
            "voxels of 0.5 x 0.6 x 0.7 mm, origin and directions from the series, because the "
            "label map has none");
}

TEST(ImageGeometry, AMapWithAFrameKeepsItAndTheDifferenceIsSaid) {
  Eigen::Matrix4d moved = kFrame;
  moved(2, 3) += 0.3;
  LabelMap map = map_at(moved, true);
  const Expected<std::string> said = place(map, {kSize, kFrame, true});
  ASSERT_TRUE(said);
  EXPECT_EQ(map.to_lps_mm, moved);
  EXPECT_EQ(*said, "taken from the label map, which differs from the series by 0.3 mm at most");
}

TEST(ImageGeometry, OtherSizesAndFramesFarApartAreRefused) {
  LabelMap map = map_at(kFrame, true);
  EXPECT_EQ(place(map, {{4, 5, 7}, kFrame, true}).errors()[0].code, ErrorCode::BadReference);
  Eigen::Matrix4d moved = kFrame;
  moved(2, 3) += 3.0;
  EXPECT_EQ(place(map, {kSize, moved, true}).errors()[0].code, ErrorCode::BadGeometry);
}

}  // namespace
}  // namespace coapt
