#include "lab/closures/ablation_study.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "core/presets/presets.h"
#include "core/valve/validate.h"

namespace coapt {
namespace {

AblatedModel changed(const std::string& change, const AblatedModel& full) {
  for (const Ablation& ablation : ablations())
    if (ablation.change == change) return ablation.apply(full, {"human-normal", -1, 1, 300});
  ADD_FAILURE() << change;
  return full;
}

TEST(Ablations, HaveNamesOfTheirOwnWithoutCommasAndLeaveAValidValve) {
  const AblatedModel full{*make_preset("human-normal", 300), {}, false};
  std::set<std::string> names;
  for (const Ablation& ablation : ablations()) {
    EXPECT_TRUE(names.insert(ablation.change).second) << ablation.change;
    EXPECT_EQ((ablation.group + ablation.change).find(','), std::string::npos);
    const AblatedModel model = ablation.apply(full, {"human-normal", -1, 1, 300});
    EXPECT_TRUE(validate(model.valve).empty()) << ablation.change;
  }
}

TEST(Ablations, OfThicknessKeepStiffnessAndMassPerArea) {
  const AblatedModel full{*make_preset("human-normal", 300), {}, false};
  const Tissue &before = full.valve.tissue, after = changed("2 mm thick", full).valve.tissue;
  EXPECT_EQ(after.thickness_mm, 2.0);
  EXPECT_DOUBLE_EQ(after.thickness_mm * after.radial_post_kpa, before.radial_post_kpa);
  EXPECT_DOUBLE_EQ(after.thickness_mm * after.density_g_per_mm3, before.density_g_per_mm3);
}

TEST(Ablations, StraightChordaeKeepInsertionsAndTheStiffnessOfTheirGroup) {
  const Valve branched = *make_preset("human-normal", 300);
  const Valve straight = with_straight_chordae(branched);
  std::size_t insertions = 0;
  double twig_path = 0.0;
  for (const Chorda& chorda : branched.chordae)
    for (const ChordaSegment& segment : chorda.segments) insertions += segment.inserts;
  ASSERT_EQ(straight.chordae.size(), insertions);
  // The first marginal chorda: three twigs on a trunk, all 1 mm thick.
  const Chorda& tree = branched.chordae[0];
  ASSERT_EQ(tree.segments.size(), 4u);
  for (std::size_t twig = 1; twig < 4; ++twig) {
    const ChordaSegment& one = straight.chordae[twig - 1].segments[0];
    EXPECT_EQ(one.insertion.face, tree.segments[twig].insertion.face);
    twig_path = tree.segments[0].rest_length_mm + tree.segments[twig].rest_length_mm;
    EXPECT_LT(one.rest_length_mm, twig_path);
    EXPECT_GT(one.rest_length_mm, 0.9 * twig_path);
    EXPECT_NEAR(one.rest_length_mm / (one.diameter_mm * one.diameter_mm),
                3.0 * tree.segments[0].rest_length_mm + tree.segments[twig].rest_length_mm, 1e-9);
  }
}

TEST(AblationStudy, ClosesEverySceneInEveryWayAndFindsTheTransitionToMatter) {
  AblationStudyOptions options;
  options.presets = {"human-normal"};
  options.variations = 1;
  options.triangles = 300;
  options.repeats = 1;
  int last = 0;
  const auto outcomes = study_ablations(options, [&](int done, int planned) {
    EXPECT_EQ(done, ++last);
    EXPECT_EQ(planned, static_cast<int>(2 * ablations().size()));
  });
  ASSERT_EQ(outcomes.size(), 2 * ablations().size());
  EXPECT_EQ(outcomes.front().scene, "human-normal");
  EXPECT_EQ(outcomes.back().scene, "human-normal/0");
  for (const AblationOutcome& outcome : outcomes) {
    EXPECT_TRUE(std::isfinite(outcome.rms_mm));
    EXPECT_GT(outcome.time_ratio, 0.0);
    if (outcome.change == "300 triangles") {
      EXPECT_LT(outcome.rms_mm, 1e-6);
    }
    if (outcome.change == "linear: modulus after transition") {
      EXPECT_GT(outcome.leak_change_mm2, 20.0);
    }
  }
}

}  // namespace
}  // namespace coapt
