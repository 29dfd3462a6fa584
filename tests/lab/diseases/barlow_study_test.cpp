#include "lab/diseases/barlow_study.h"

#include <gtest/gtest.h>

namespace coapt {
namespace {

BarlowState state(BarlowTissue tissue, double reduction, double index, double leak_mm2) {
  return {0, tissue, reduction, true, index, leak_mm2};
}

TEST(BarlowStudy, AnswersAreReadOffTheSeriesByLine) {
  using enum BarlowTissue;
  // 0.15 at 0.2 and 0.25 at 0.4: 0.2 at 0.3. Dilated states do not count.
  const std::vector<BarlowAnswer> answers =
      barlow_answers({state(Myxomatous, -0.2, 0.25, 90.0), state(Myxomatous, 0.0, 0.1, 20.0),
                      state(Myxomatous, 0.2, 0.15, 0.5), state(Myxomatous, 0.4, 0.25, 0.2),
                      state(Healthy, 0.0, 0.05, 40.0), state(Healthy, 0.2, 0.3, 10.0)});
  ASSERT_EQ(answers.size(), 1u);
  EXPECT_NEAR(answers[0].reduction_for_index.value(), 0.3, 1e-12);
  EXPECT_EQ(answers[0].reduction_to_close.value(), 0.2);
  EXPECT_EQ(answers[0].leak_mm2, 20.0);
  EXPECT_EQ(answers[0].healthy_leak_mm2, 40.0);
}

TEST(BarlowStudy, ASmallerAnnulusCoaptsMoreAndAHealthyLawLeaksMore) {
  const std::vector<BarlowState> states = study_barlow({.valves = 1, .seed = 1, .threads = 2});
  ASSERT_EQ(states.size(), 36u);
  EXPECT_GT(states[17].coaptation_area_index, states[4].coaptation_area_index);
  const std::vector<BarlowAnswer> answers = barlow_answers(states);
  EXPECT_GT(answers.at(0).healthy_leak_mm2, answers.at(0).leak_mm2);
}

TEST(BarlowStudy, TheTableHasARowForEachClosure) {
  EXPECT_EQ(barlow_csv({state(BarlowTissue::Healthy, 0.05, 0.125, 3.5)}),
            "valve,tissue,reduction,trusted,coaptation_area_index,leak_mm2\n"
            "0,healthy,0.05,1,0.125,3.5\n");
}

}  // namespace
}  // namespace coapt
