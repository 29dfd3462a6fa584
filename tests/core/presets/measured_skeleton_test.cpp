#include "core/valve/measured_skeleton.h"

#include <gtest/gtest.h>

namespace coapt {
namespace {

/// Two tips at the sides of a human annulus.
Points two_tips(double depth_mm, double behind_mm = 2.0) {
  Points tips(2, 3);
  tips << -12.0, -behind_mm, -depth_mm, 12.0, -behind_mm, -depth_mm;
  return tips;
}

Points human_contour() { return generic_annulus_contour(29.0, 39.0, 0.0); }

/// The only error of a skeleton that must be refused.
Error problem(const Points& annulus_mm, const Points& tips_mm) {
  const Expected<MeasuredSkeleton> skeleton = measured_skeleton(annulus_mm, tips_mm);
  EXPECT_FALSE(skeleton) << "was accepted";
  if (skeleton) return {};
  EXPECT_EQ(skeleton.errors().size(), 1u);
  return skeleton.errors().front();
}

TEST(MeasuredSkeleton, OfHumanDimensionsIsAcceptedInAnyFrame) {
  EXPECT_TRUE(measured_skeleton(human_contour(), two_tips(23.5)));
  const Points upside_down = -human_contour();
  EXPECT_TRUE(measured_skeleton(upside_down, -two_tips(23.5)));
}

TEST(MeasuredSkeleton, TipsInOrNearTheAnnulusPlaneOrFarFromItAreRefused) {
  for (const double depth_mm : {0.0, 7.9, 60.1}) {
    const Error error = problem(human_contour(), two_tips(depth_mm));
    EXPECT_EQ(error.path, "/tips_mm") << depth_mm;
    EXPECT_EQ(error.code, ErrorCode::BadGeometry);
    EXPECT_NE(error.message.find("from 8 to 60 mm below it"), std::string::npos) << error.message;
  }
  EXPECT_EQ(problem(human_contour(), two_tips(23.5, 61.0)).path, "/tips_mm");
  Points above(4, 3);
  above << two_tips(30.0), two_tips(-5.0, 4.0);
  EXPECT_NE(problem(human_contour(), above).message.find("2 of 4 tips"), std::string::npos);
}

TEST(MeasuredSkeleton, TheContourInPlaceOfTheTipsIsTooManyTips) {
  const Error error = problem(human_contour(), human_contour());
  EXPECT_EQ(error.path, "/tips_mm");
  EXPECT_EQ(error.code, ErrorCode::OutOfRange);
  EXPECT_NE(error.message.find("720 points, accepted: 2 to 100"), std::string::npos);
}

TEST(MeasuredSkeleton, TipsThatTellNoDirectionAreRefused) {
  Points one_muscle = two_tips(23.5);
  one_muscle.col(0).array() += 14.0;
  EXPECT_EQ(problem(human_contour(), one_muscle).path, "/tips_mm");
  Points same = two_tips(23.5);
  same.row(1) = same.row(0);
  EXPECT_FALSE(measured_skeleton(human_contour(), same));
}

TEST(MeasuredSkeleton, AContourOfOnePointOrInOtherUnitsSaysSo) {
  EXPECT_NE(problem(Points::Zero(40, 3), two_tips(23.5)).message.find("same point 40 times"),
            std::string::npos);
  EXPECT_NE(problem(0.001 * human_contour(), two_tips(23.5)).message.find("looks like metres"),
            std::string::npos);
  Points line = human_contour();
  line.col(1) *= 0.01;
  EXPECT_NE(problem(line, two_tips(23.5)).message.find("across the line"), std::string::npos);
}

}  // namespace
}  // namespace coapt
