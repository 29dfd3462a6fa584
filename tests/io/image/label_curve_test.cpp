#include "io/image/label_curve.h"

#include <gtest/gtest.h>

#include <numbers>

#include "core/valve/contour.h"
#include "tests/io/image/drawn_labels.h"

namespace coapt {
namespace {

constexpr double kRadius_mm = 15.0, kTube_mm = 1.6, kSaddle_mm = 3.0;
const std::array<Index, 3> kImage = {80, 80, 40};
const Eigen::Matrix4d kPlace = oblique_frame(kImage, {0.5, 0.5, 0.6}, true);

/// From LPS into axes in which the ring is round z.
Vec3 into_ring(const Vec3& x) {
  return Vec3((kPlace.topLeftCorner<3, 3>().colwise().normalized()).transpose() *
              (x - kObliqueMiddle_mm));
}

/// Distance from a saddle-shaped ring, nearly.
double from_ring(const Vec3& lps_mm) {
  const Vec3 x = into_ring(lps_mm);
  const double turn = std::atan2(x.y(), x.x());
  return std::hypot(std::hypot(x.x(), x.y()) - kRadius_mm, x.z() - kSaddle_mm * std::cos(2 * turn));
}

TEST(LabelCurve, TubeAboutASaddleGivesItsMiddleLine) {
  const LabelMap map =
      drawn_labels(kImage, kPlace, [](const Vec3& x) { return from_ring(x) < kTube_mm; });
  const Expected<Points> line = label_curve(map, {0, 1});
  ASSERT_TRUE(line);
  ASSERT_EQ(line->rows(), 72);
  for (const auto& point : line->rowwise()) EXPECT_LT(from_ring(point), 0.25);
  EXPECT_NEAR(ArcLength(*line).total_mm(), 2 * std::numbers::pi * kRadius_mm, 6.0)
      << "in order round the ring (the saddle adds 4 mm)";
}

TEST(LabelCurve, AGapOfTenDegreesIsBridgedOneOfFortyStaysOneOfEightyIsRefused) {
  const auto with_gap = [](double degrees) {
    return drawn_labels(kImage, kPlace, [=](const Vec3& x) {
      const Vec3 at = into_ring(x);
      return from_ring(x) < kTube_mm &&
             std::abs(std::atan2(at.y(), at.x())) > degrees / 360.0 * std::numbers::pi;
    });
  };
  EXPECT_EQ(label_curve(with_gap(10), {0, 1})->rows(), 72);
  const Expected<Points> wide = label_curve(with_gap(40), {0, 1});
  ASSERT_TRUE(wide);
  EXPECT_NEAR(static_cast<double>(wide->rows()), 72.0 * 320.0 / 360.0, 3.0);
  const Expected<Points> open = label_curve(with_gap(80), {0, 1});
  ASSERT_FALSE(open);
  EXPECT_NE(open.errors()[0].message.find("it is open over"), std::string::npos);
}

TEST(LabelCurve, WhatIsNoRingIsRefusedWithTheReason) {
  const auto why = [](const std::function<bool(const Vec3&)>& inside) {
    const Expected<Points> line = label_curve(drawn_labels(kImage, kPlace, inside), {0, 1});
    return line ? "" : line.errors()[0].message;
  };
  EXPECT_NE(why([](const Vec3& x) { return into_ring(x).norm() < 9; }).find("no central hole"),
            std::string::npos);
  EXPECT_NE(why([](const Vec3& x) {
              const double r = into_ring(x).norm();
              return r > 5 && r < 14 && std::abs(into_ring(x).z()) < 1;
            }).find("wider than half"),
            std::string::npos);
  EXPECT_NE(why([](const Vec3& x) { return into_ring(x).norm() < 0.8; }).find("voxels"),
            std::string::npos);
}

TEST(LabelCurve, AsManyVoxelsAsNoAnnulusHasAreRefusedUnread) {
  LabelMap map;
  map.size = {128, 128, 128};
  map.voxels.assign(128 * 128 * 128, 1);
  const Expected<Points> line = label_curve(map, {0, 1});
  ASSERT_FALSE(line);
  EXPECT_NE(line.errors()[0].message.find("it has 2097152 voxels, must have 36 to 2000000"),
            std::string::npos);
}

}  // namespace
}  // namespace coapt
