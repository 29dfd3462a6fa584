#include "search/studies/model_study.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "search/fit/fit_parameters.h"
#include "search/fit/fitted_draw.h"
#include "search/model_draw.h"
#include "search/threads.h"
#include "tests/scenes/small_preset.h"
#include "tests/search/plans/search_scene.h"

namespace coapt::scene {
namespace {

constexpr int kChordalModulus = 7;

/// Leaks 20 mm2 per e-fold of the chordal modulus, 40 on its own.
double leak_by_modulus(const Valve& valve) {
  static const Valve own = small_valve();
  return 40.0 + 20.0 * std::log(valve.tissue.chordae_kpa / own.tissue.chordae_kpa);
}

ModelStudyOptions with(Evaluator evaluate, int draws = 128, int threads = 1) {
  ModelStudyOptions options;
  options.evaluate = std::move(evaluate);
  options.draws = draws;
  options.threads = threads;
  return options;
}

TEST(ModelStudy, FindsThePropertyThatDecides) {
  const ModelStudy study = study_model(small_valve(), with(leak_of(leak_by_modulus)));
  EXPECT_EQ(study.leak.as_it_is_mm2, 40.0);
  EXPECT_EQ(study.untrusted, 0);
  ASSERT_EQ(study.draws.size(), 128u);
  // Piecewise linear in the share: from 40 + 20 ln 0.5 over 40 to 40 + 20 ln 4.6.
  const double low = 20.0 * std::log(0.5), high = 20.0 * std::log(4.6);
  EXPECT_NEAR(study.leak.mean_mm2, 40.0 + 0.25 * (low + high), 0.2);
  EXPECT_NEAR(study.leak.p5_mm2, 40.0 + 0.9 * low, 0.5);
  EXPECT_NEAR(study.leak.p95_mm2, 40.0 + 0.9 * high, 0.5);
  EXPECT_GT(study.leak.decided_by.first[kChordalModulus], 0.98);
  EXPECT_GT(study.leak.decided_by.total[kChordalModulus], 0.98);
  EXPECT_NEAR(study.leak.decided_by.effect[kChordalModulus], high - low, 3.0);
}

TEST(ModelStudy, LeavesOutWhatIsNotTrustedAndCountsIt) {
  const ModelStudy study =
      study_model(small_valve(), with([](const Valve& valve, const ClosureResult*) -> ClosedPlan {
                    Evaluation evaluation = leaking(leak_by_modulus(valve));
                    if (evaluation.measure.leak.area_mm2 > 40.0)
                      evaluation.status = ClosureStatus::StepLimit;
                    return {evaluation, nullptr};
                  }));
  EXPECT_EQ(study.untrusted, 64) << "a half of a Latin hypercube";
  EXPECT_LE(study.leak.p95_mm2, 40.0);
}

TEST(ModelStudy, AClosedValveThatStaysClosedHasNoDecidingProperty) {
  const ModelStudy study =
      study_model(small_valve(), with(leak_of([](const Valve&) { return 0.0; })));
  EXPECT_EQ(study.leak.sd_mm2, 0.0);
  EXPECT_TRUE(std::isnan(study.leak.decided_by.total[0]));
}

/// 25 +- 3 mm2 seen of a valve.
Valve seen_leaking(Valve valve) {
  valve.observed = {{ObservedFigure::Leak, 25.0, 3.0, "planimetry"}};
  return valve;
}

TEST(ModelStudy, WeighsDrawsByWhatWasObserved) {
  const ModelStudy study = study_model(seen_leaking(small_valve()), with(leak_of(leak_by_modulus)));
  ASSERT_EQ(study.observed.size(), 1u);
  EXPECT_FALSE(study.contradicts);
  EXPECT_GE(study.effective, kLeastEffective);
  // Leaks lie from 26 mm2 up: what is seen leaves the lower end of them.
  const std::optional<Interval> tissue = tissue_interval(study);
  ASSERT_TRUE(tissue);
  EXPECT_GT(tissue->low, 26.0);
  EXPECT_LT(tissue->high, 32.0);
  EXPECT_EQ(study.leak.p95_mm2, tissue->high);
  EXPECT_LT(study.leak.mean_mm2, 30.0);
}

TEST(ModelStudy, MakesMoreDrawsWhereFewAgreeWithWhatWasObserved) {
  const ModelStudy study =
      study_model(seen_leaking(small_valve()), with(leak_of(leak_by_modulus), 32));
  EXPECT_GE(std::ssize(study.draws), kConditionedDraws) << "however few were asked for";
  EXPECT_LE(std::ssize(study.draws), kConditionedDraws * kMostBlocks);
  EXPECT_EQ(study_model(small_valve(), with(leak_of(leak_by_modulus), 32)).draws.size(), 32u);
}

TEST(ModelStudy, SaysThatWhatWasObservedContradictsTheModel) {
  Valve valve = small_valve();
  valve.observed = {{ObservedFigure::Leak, 5.0, 2.0, ""}};  // no draw leaks less than 26 mm2
  const ModelStudy study = study_model(valve, with(leak_of(leak_by_modulus), 32));
  EXPECT_TRUE(study.contradicts);
  EXPECT_EQ(tissue_interval(study), std::nullopt);
  for (const ModelStudyDraw& draw : study.draws) EXPECT_EQ(draw.weight, study.draws.front().weight);
}

TEST(ModelStudy, ARepairedValveIsWeighedByTheUnrepairedOne) {
  // The repair leaves a tenth of the leak: 25 mm2 before are 2.5 mm2 after.
  const Valve unrepaired = seen_leaking(small_valve());
  const RepairPlan ring{{Annuloplasty{OwnRing{1}}}};
  ModelStudyOptions options = with(leak_of([&](const Valve& valve) {
    return leak_by_modulus(valve) * (valve.annulus_mm == unrepaired.annulus_mm ? 1.0 : 0.1);
  }));
  options.plan = &ring;
  const std::optional<Interval> tissue = tissue_interval(study_model(unrepaired, options));
  ASSERT_TRUE(tissue);
  EXPECT_GT(tissue->low, 2.6);
  EXPECT_LT(tissue->high, 3.2);
}

/// A millimetre for each of a valve's chordae.
double leak_by_chordae(const Valve& valve) {
  double leak_mm2 = 0.0;
  for (const Chorda& chorda : valve.chordae)
    for (const ChordaSegment& segment : chorda.segments) leak_mm2 += segment.rest_length_mm;
  return leak_mm2 / valve.tissue.thickness_mm;
}

TEST(ModelStudy, DrawsChordaeThatWereNeverSeen) {
  Valve valve = shared_preset("human-functional-mr", 150);
  const ModelStudy seen = study_model(valve, with(leak_of(leak_by_chordae), 4));
  valve.drawn_chordae = {.seed = 3, .tips_given = false};
  std::set<std::size_t> counts;
  Mutex mutex;
  const ModelStudy drawn = study_model(valve, with(leak_of([&](const Valve& one) {
                                                     const Lock lock(mutex);
                                                     counts.insert(one.chordae.size());
                                                     return leak_by_chordae(one);
                                                   }),
                                                   4, 2));
  EXPECT_TRUE(drawn.draws_chordae && !seen.draws_chordae);
  EXPECT_GT(counts.size(), 2u) << "each has chordae of its own";
  EXPECT_EQ(drawn.as_it_is.measure.leak.area_mm2, seen.as_it_is.measure.leak.area_mm2);
  for (std::size_t i = 0; i < drawn.draws.size(); ++i)
    EXPECT_EQ(drawn.draws[i].shares, seen.draws[i].shares) << "tissue is drawn as before";
}

TEST(ModelStudy, DrawsWhatAFitLeftUncertain) {
  Valve valve = shared_preset("human-functional-mr", 150);
  const ModelStudy own = study_model(valve, with(leak_of(leak_by_chordae), 32));
  valve.fitted = FittedValues{{fit_parameters(valve, {}).front().name},
                              Eigen::MatrixXd::Constant(1, 1, 0.05 * 0.05)};
  ASSERT_TRUE(check_fitted_parameters(valve).empty());
  const ModelStudy fitted = study_model(valve, with(leak_of(leak_by_chordae), 32));
  EXPECT_TRUE(fitted.draws_fit && !fitted.draws_chordae);
  EXPECT_NE(fitted.leak.mean_mm2, own.leak.mean_mm2);
}

TEST(ModelStudy, WeighsAlikeForAnyNumberOfThreads) {
  const Valve valve = seen_leaking(small_valve());
  const ModelStudy one = study_model(valve, with(leak_of(leak_by_modulus), 32, 1));
  const ModelStudy three = study_model(valve, with(leak_of(leak_by_modulus), 32, 3));
  EXPECT_EQ(one.effective, three.effective);
  EXPECT_EQ(tissue_interval(one), tissue_interval(three));
}

TEST(ModelStudy, CancelledItReportsWhatIsClosed) {
  std::atomic<bool> cancelled = false;
  std::atomic<int> calls = 0;
  ModelStudyOptions options = with(cancelling(leak_of(leak_by_modulus), calls, 1 + 10, cancelled));
  options.cancelled = [&] { return cancelled.load(); };
  int told = 0;
  options.progress = [&](int done, int planned) {
    EXPECT_EQ(done, ++told);
    EXPECT_EQ(planned, 128);
  };
  EXPECT_EQ(study_model(small_valve(), options).draws.size(), 10u);
  EXPECT_EQ(told, 10);
}

TEST(ModelStudy, IsTheSameForAnyNumberOfThreadsAndDependsOnItsSeed) {
  const Valve& valve = shared_preset("human-functional-mr", 150);
  const ModelStudy one = study_model(valve, with({}, 12, 1));
  ModelStudyOptions options = with({}, 12, 2);
  const ModelStudy two = study_model(valve, options);
  EXPECT_EQ(bits(one.leak.mean_mm2), bits(two.leak.mean_mm2));
  EXPECT_EQ(bits(one.leak.sd_mm2), bits(two.leak.sd_mm2));
  for (std::size_t i = 0; i < one.draws.size(); ++i)
    EXPECT_EQ(bits(one.draws[i].leak_mm2), bits(two.draws[i].leak_mm2));
  options.seed = 2;
  EXPECT_NE(study_model(valve, options).draws[0].shares, one.draws[0].shares);
}

}  // namespace
}  // namespace coapt::scene
