#include "lab/closures/accuracy_study.h"

#include <gtest/gtest.h>

namespace coapt {
namespace {

TEST(AccuracyStudy, FindsFinerMeshesAndTighterTolerancesNearer) {
  AccuracyStudyOptions options;
  options.presets = {"human-functional-mr"};
  options.triangles = {300, 650};
  options.tolerances = {0.1, 0.001};
  options.thesis_tolerances = {};
  options.reference_triangles = 1300;
  int last = 0;
  const std::vector<AccuracyPoint> points = study_accuracy(options, [&](int done, int planned) {
    EXPECT_EQ(done, ++last);
    EXPECT_EQ(planned, 8);
  });
  ASSERT_EQ(points.size(), 8u);
  for (const AccuracyPoint& point : points) {
    EXPECT_EQ(point.status, ClosureStatus::Converged);
    EXPECT_GT(point.rms_mm, 0.0);
    EXPECT_LE(point.rms_mm, point.max_mm);
    EXPECT_GT(point.seconds, 0.0);
  }
  // Springs, then continuum; in each 300 triangles before 650, loose before tight.
  for (const std::size_t first : {0u, 4u}) {
    EXPECT_LT(points[first + 1].own_rms_mm, points[first].own_rms_mm);
    EXPECT_LT(points[first + 3].own_rms_mm, points[first + 2].own_rms_mm);
    EXPECT_LT(points[first + 3].rms_mm, points[first + 1].rms_mm);
  }
}

}  // namespace
}  // namespace coapt
