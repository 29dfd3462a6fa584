#include "core/valve/ruptures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>

#include "search/fit/fit.h"
#include "tests/scenes/small_preset.h"

namespace coapt {
namespace {

/// Lengths of chordae are the unknowns that stand in for a rupture.
FitOptions slack_and_ruptures() {
  FitOptions options;
  options.unknowns.tips = options.unknowns.prestretch = options.unknowns.stiffness =
      options.unknowns.hidden = false;
  options.ruptures = true;
  options.most_rounds = 2;
  return options;
}

MeasuredClosure closed_state(const Valve& valve) {
  const ClosedValve closed = close_and_measure(valve);
  return {closed.closure.closed_mm, MeasuredSide::Middle, closed.measure.leak.area_mm2, 3.0};
}

/// Normal, with an annulus that lets a flail scallop leak.
Valve dilated() {
  Valve valve = small_preset("human-p2-prolapse");
  for (Chorda& chorda : valve.chordae) chorda.ruptured = false;
  return valve;
}

const FitHypothesis& named(const ValveFit& fit, const std::string& name) {
  return *std::find_if(fit.hypotheses.begin(), fit.hypotheses.end(),
                       [&](const FitHypothesis& of) { return of.name == name; });
}

TEST(Ruptures, AreOfMarginalChordaeThatInsertInOneScallopNotOfCommissuralOnes) {
  const Valve& valve = small_preset("human-normal");
  EXPECT_EQ(held_segments(valve), (std::vector<Segment>{Segment::A1, Segment::A2, Segment::A3,
                                                        Segment::P1, Segment::P2, Segment::P3}));
  const Valve without = with_ruptured(valve, Segment::P2);
  std::vector<std::string> ids;
  for (const Chorda& chorda : without.chordae)
    if (chorda.ruptured) ids.push_back(chorda.id);
  EXPECT_EQ(ids, (std::vector<std::string>{"AL3-P2-marginal-5", "PM3-P2-marginal-5"}));
  const std::vector<Segment> held = held_segments(without);
  EXPECT_EQ(std::count(held.begin(), held.end(), Segment::P2), 0);
  EXPECT_EQ(held.size(), 5u);
}

MeasuredClosure flail_state() { return closed_state(with_ruptured(dilated(), Segment::P2)); }

/// Of the flail state, on two threads.
const Expected<ValveFit>& flail_fit() {
  static const Expected<ValveFit> kFit = [] {
    FitOptions options = slack_and_ruptures();
    options.threads = 2;
    return fit_valve(dilated(), flail_state(), options);
  }();
  return kFit;
}

TEST(Ruptures, ThatClosedTheScallopAreFound) {
  const MeasuredClosure measured = flail_state();
  const Expected<ValveFit>& fit = flail_fit();
  ASSERT_TRUE(fit);
  EXPECT_EQ(fit->taken, "ruptured_P2");
  const FitHypothesis& found = named(*fit, "ruptured_P2");
  EXPECT_TRUE(found.refitted);
  EXPECT_GT(found.probability, 0.9);
  EXPECT_EQ(found.rms_mm, fit->rms_mm);
  EXPECT_LT(fit->rms_mm, 0.5 * named(*fit, "intact").rms_mm);
  EXPECT_NEAR(fit->leak.mm2, *measured.leak_mm2, 3.0);
  EXPECT_EQ(held_segments(fit->closed.valve).size(), 5u);
  EXPECT_EQ(held_segments(fit->before.valve).size(), 6u);
  double sum = 0.0;
  for (const FitHypothesis& of : fit->hypotheses) sum += of.probability;
  EXPECT_NEAR(sum, 1.0, 1e-12);
  EXPECT_TRUE(fit->left_out.empty());
}

TEST(Ruptures, AreNotFoundInAnIntactValve) {
  const Valve whole = dilated();
  const MeasuredClosure measured = closed_state(whole);
  FitOptions options = slack_and_ruptures();
  const Expected<ValveFit> fit = fit_valve(whole, measured, options);
  ASSERT_TRUE(fit);
  EXPECT_EQ(fit->taken, "intact");
  EXPECT_GT(named(*fit, "intact").probability, 0.5);
  options.ruptures = false;
  const Expected<ValveFit> alone = fit_valve(whole, measured, options);
  ASSERT_TRUE(alone);
  EXPECT_TRUE(alone->hypotheses.empty());
  EXPECT_EQ(alone->distances_mm, fit->distances_mm);
  EXPECT_EQ(alone->covariance, fit->covariance);
}

TEST(Ruptures, AreTheSameForAnyNumberOfThreads) {
  FitOptions options = slack_and_ruptures();
  options.threads = 1;
  const Expected<ValveFit> one = fit_valve(dilated(), flail_state(), options);
  const Expected<ValveFit>& two = flail_fit();
  ASSERT_TRUE(one);
  ASSERT_TRUE(two);
  EXPECT_EQ(one->taken, two->taken);
  EXPECT_EQ(one->distances_mm, two->distances_mm);
  EXPECT_EQ(one->covariance, two->covariance);
  EXPECT_EQ(one->closures, two->closures);
  ASSERT_EQ(one->hypotheses.size(), two->hypotheses.size());
  for (std::size_t i = 0; i < one->hypotheses.size(); ++i)
    EXPECT_EQ(one->hypotheses[i].probability, two->hypotheses[i].probability);
}

TEST(Ruptures, AreLeftOutByNameWhenTimeIsOver) {
  const Valve whole = dilated();
  FitOptions options = slack_and_ruptures();
  options.most_seconds = 1e-6;
  const Expected<ValveFit> fit = fit_valve(whole, closed_state(whole), options);
  ASSERT_TRUE(fit);
  EXPECT_EQ(fit->stop, FitStop::TimeLimit);
  EXPECT_EQ(fit->taken, "intact");
  EXPECT_EQ(fit->left_out.size(), 6u);
  ASSERT_EQ(fit->hypotheses.size(), 1u);
  EXPECT_EQ(fit->hypotheses.front().probability, 1.0);
}

TEST(Ruptures, AreLeftOutWhenTheFitIsCancelled) {
  const Valve whole = dilated();
  FitOptions options = slack_and_ruptures();
  std::atomic<int> asked = 0;
  options.cancelled = [&] { return ++asked > 100; };
  const Expected<ValveFit> fit = fit_valve(whole, closed_state(whole), options);
  ASSERT_TRUE(fit);
  EXPECT_EQ(fit->stop, FitStop::Cancelled);
  EXPECT_EQ(fit->left_out.size(), 6u);
}

}  // namespace
}  // namespace coapt
