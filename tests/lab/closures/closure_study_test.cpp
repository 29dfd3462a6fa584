#include "lab/closures/closure_study.h"

#include <gtest/gtest.h>

#include "core/presets/presets.h"
#include "core/valve/validate.h"
#include "lab/closures/varied_scenes.h"

namespace coapt {
namespace {

TEST(VariedScenes, AreValidDifferAndComeBackWithTheirNumber) {
  const Valve valve = *make_preset("human-normal", 300);
  Points last = valve.annulus_mm;
  for (int i = 0; i < 20; ++i) {
    const Valve scene = varied_scene(valve, 7, i);
    EXPECT_TRUE(validate(scene).empty()) << i;
    EXPECT_EQ(scene.annulus_mm, varied_scene(valve, 7, i).annulus_mm);
    EXPECT_NE(scene.annulus_mm, last);
    EXPECT_EQ(scene.rest_mm, valve.rest_mm);
    last = scene.annulus_mm;
  }
  EXPECT_NE(varied_scene(valve, 8, 0).annulus_mm, varied_scene(valve, 7, 0).annulus_mm);
}

TEST(ClosureStudy, IsTheSameForAnyNumberOfThreadsButForTheTimes) {
  const Valve valve = *make_preset("human-normal", 300);
  ClosureStudyOptions options;
  options.count = 6;
  options.threads = 1;
  int calls = 0;
  const ClosureStudy one = study_closures({valve}, options, [&](int) { ++calls; });
  options.threads = 2;
  const ClosureStudy two = study_closures({valve}, options);
  EXPECT_EQ(calls, 6);
  ASSERT_EQ(one.scenes.size(), 6u);
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_EQ(one.scenes[i].steps, two.scenes[i].steps);
    EXPECT_EQ(one.scenes[i].from_end.rms_mm, two.scenes[i].from_end.rms_mm);
    EXPECT_EQ(one.scenes[i].from_other.leak_mm2, two.scenes[i].from_other.leak_mm2);
  }
  EXPECT_EQ(one.unconverged + one.crossed, 0);
  EXPECT_GT(one.closures_per_second_per_core, 0.0);
}

TEST(ClosureStudy, CountsClosuresNearTheirOwnEnd) {
  ClosureStudyOptions options;
  options.count = 8;
  const ClosureStudy study = study_closures({*make_preset("human-normal")}, options);
  for (const SceneOutcome& scene : study.scenes) {
    ASSERT_TRUE(scene.compared);
    EXPECT_GT(scene.from_end.rms_mm, 0.0);
    EXPECT_LE(scene.from_end.rms_mm, scene.from_end.max_mm);
    EXPECT_LT(scene.from_end.rms_mm, 0.3);
    EXPECT_EQ(scene.other_equilibrium, scene.from_other.rms_mm > 0.05);
  }
}

TEST(ClosureStudy, FromALibraryIsTheSameForAnyNumberOfThreadsAndTakesFewerSteps) {
  const Valve valve = *make_preset("human-functional-mr", 300);
  ClosureStudyOptions options;
  options.count = 6;
  options.accuracy = false;
  const ClosureStudy cold = study_closures({valve}, options);
  options.library = 12;
  options.threads = 1;
  const ClosureStudy one = study_closures({valve}, options);
  options.threads = 2;
  const ClosureStudy two = study_closures({valve}, options);
  for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(one.scenes[i].steps, two.scenes[i].steps);
  EXPECT_LT(one.median_steps, cold.median_steps);
  EXPECT_EQ(one.unconverged + one.crossed, 0);
}

TEST(ClosureStudy, OfWarmStartsTakesFewerStepsAndSaysHowFarFromAColdOne) {
  ClosureStudyOptions options;
  options.count = 8;
  const Valve valve = *make_preset("human-normal");
  const ClosureStudy cold = study_closures({valve}, options);
  options.warm = true;
  const ClosureStudy warm = study_closures({valve}, options);
  EXPECT_EQ(warm.unconverged + warm.crossed, 0);
  EXPECT_LT(warm.median_steps, cold.median_steps);
  for (const SceneOutcome& scene : warm.scenes)
    EXPECT_EQ(scene.other_equilibrium, scene.from_other.rms_mm > 0.05);
}

}  // namespace
}  // namespace coapt
