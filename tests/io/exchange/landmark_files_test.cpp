#include "io/exchange/landmark_files.h"

#include <gtest/gtest.h>

#include "io/exchange/markups.h"

namespace coapt {
namespace {

TEST(LandmarkFiles, LandmarksAreLabelledPointsOfATableOrOfSlicer) {
  const auto table = landmarks_in("label,x,y,z\nALC,1,2,3\nSaddle peak,4,5,6\nAL,7,8,9\n", "csv");
  ASSERT_TRUE(table);
  EXPECT_EQ(table->anterolateral_commissure_mm, Vec3(1, 2, 3));
  EXPECT_EQ(table->saddle_peak_mm, Vec3(4, 5, 6));
  EXPECT_FALSE(table->mid_posterior_mm);
  const std::string slicer =
      write_markups({{MarkupType::Fiducial, "landmarks", {"PMC"}, Points::Constant(1, 3, 2.0)}});
  const auto markups = landmarks_in(slicer, "json");
  ASSERT_TRUE(markups);
  EXPECT_EQ(markups->posteromedial_commissure_mm, Vec3(2, 2, 2));
  EXPECT_FALSE(landmarks_in("label,x,y,z\nAL,1,2,3\n", "csv"));
  EXPECT_FALSE(landmarks_in("A,1,2,3\nA,4,5,6\n", "csv"));
}

}  // namespace
}  // namespace coapt
