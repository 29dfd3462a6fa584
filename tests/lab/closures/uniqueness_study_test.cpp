#include "lab/closures/uniqueness_study.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace coapt {
namespace {

TEST(UniquenessStudy, HasEverySceneAtEveryRigidityAndTheSameOnes) {
  UniquenessStudyOptions options;
  options.presets = {"human-normal"};
  options.scenes = 2;
  options.anatomies = 1;
  options.bending_n_mm = {0.03, 0.1};
  int last = 0;
  const std::vector<UniquenessPoint> points = study_uniqueness(options, [&](int done, int planned) {
    EXPECT_EQ(planned, 10);
    EXPECT_GT(done, last);
    last = done;
  });
  ASSERT_EQ(points.size(), 10u);
  EXPECT_EQ(last, 10);
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_EQ(points[i].kind, points[i + 5].kind);
    EXPECT_EQ(points[i].valve, points[i + 5].valve);
    EXPECT_EQ(points[i].seed, points[i + 5].seed);
    EXPECT_NE(points[i].outcome.from_end.rms_mm, points[i + 5].outcome.from_end.rms_mm);
  }
  EXPECT_EQ(points[0].kind, "known");
  EXPECT_EQ(points[2].kind, "new");
  EXPECT_EQ(points[2].seed, 6u);
  EXPECT_EQ(points[4].kind, "anatomies");
}

TEST(UniquenessTable, HasTheColumnsThatScriptsRelyOnAndNothingForNoNumber) {
  UniquenessPoint point{"new", "v", 6, 1, 0.03, {}};
  point.outcome.status = ClosureStatus::Converged;
  point.outcome.attempts = 1;
  point.outcome.steps = 300;
  UniquenessPoint compared = point;
  compared.outcome.compared = true;
  compared.outcome.from_other.rms_mm = 0.25;
  compared.outcome.from_other.leak_mm2 = -1.5;
  const std::string csv = uniqueness_csv({point, compared});
  EXPECT_EQ(csv.substr(0, csv.find('\n')),
            "kind,valve,seed,scene,bending_n_mm,status,crossing,attempts,steps,compared,rms_mm,"
            "leak_difference_mm2");
  EXPECT_NE(csv.find("new,v,6,1,0.03,converged,false,1,300,false,,\n"), std::string::npos);
  EXPECT_NE(csv.find("new,v,6,1,0.03,converged,false,1,300,true,0.25,-1.5\n"), std::string::npos);
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 3);
}

}  // namespace
}  // namespace coapt
