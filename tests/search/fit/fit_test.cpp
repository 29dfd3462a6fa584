#include "search/fit/fit.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <limits>

#include "core/valve/remodel.h"
#include "tests/scenes/small_preset.h"

namespace coapt {
namespace {

FitOptions tips_alone() {
  FitOptions options;
  options.unknowns.slack = options.unknowns.prestretch = options.unknowns.stiffness =
      options.unknowns.hidden = false;
  return options;
}

/// The closed vertices of the valve with its anterolateral tip 1 mm outwards and 1.5 mm apically.
MeasuredClosure displaced(const Valve& valve) {
  Remodelling change;
  change.anterolateral_mm = Vec3(1.0, 0.0, 1.5);
  const ClosedValve closed = close_and_measure(*remodel(valve, change));
  return {closed.closure.closed_mm, MeasuredSide::Middle, {}, 3.0};
}

TEST(Fit, FindsTheTipsOfAClosedStateThatItsModelCanReach) {
  const Valve& valve = small_preset("human-functional-mr");
  const Expected<ValveFit> fit = fit_valve(valve, displaced(valve), tips_alone());
  ASSERT_TRUE(fit);
  EXPECT_EQ(fit->stop, FitStop::AtRest);
  EXPECT_GT(fit->rms_before_mm, 0.3);
  EXPECT_LT(fit->rms_mm, 0.05);
  const std::vector<double> truth = {-1.0, 0.0, -1.5, 0.0, 0.0, 0.0};
  ASSERT_EQ(fit->parameters.size(), truth.size());
  for (std::size_t i = 0; i < truth.size(); ++i) {
    EXPECT_NEAR(fit->parameters[i].value, truth[i], 0.15) << fit->parameters[i].parameter.name;
    EXPECT_GT(fit->parameters[i].sd, 0.0);
    EXPECT_TRUE(fit->parameters[i].identifiable) << "by so many points";
  }
}

/// The closed vertices of a tethered twin: both tips so far outwards and towards the apex that its leaflets tent.
MeasuredClosure tethered(const Valve& valve, double outwards_mm, double apical_mm) {
  Remodelling change;
  change.anterolateral_mm = change.posteromedial_mm = Vec3(outwards_mm, 0.0, apical_mm);
  const ClosedValve closed = close_and_measure(*remodel(valve, change));
  return {closed.closure.closed_mm, MeasuredSide::Middle, {}, 3.0};
}

TEST(Fit, FindsATetheredTwinThatStartsFourMillimetresOff) {
  const Valve& valve = small_preset("human-normal");
  FitOptions options = tips_alone();
  options.unknowns.tip_sd_mm = 4.0;
  options.most_rounds = 6;
  const Expected<ValveFit> fit = fit_valve(valve, tethered(valve, 4.0, 8.0), options);
  ASSERT_TRUE(fit);
  EXPECT_GT(fit->rms_before_mm, 3.5);
  EXPECT_LT(fit->rms_mm, 0.3);
  EXPECT_LE(fit->rms_mm, 1.02 * fit->best_rms_mm);
}

TEST(Fit, AnswersWithTheNearestPlaceThatItMetWhereItsModelCannotReach) {
  const Valve& valve = small_preset("human-normal");
  FitOptions options = tips_alone();
  options.unknowns.tip_sd_mm = 0.5;
  options.most_rounds = 3;
  double least_mm = std::numeric_limits<double>::infinity();
  options.keep = [&](const FitState& state) {
    least_mm = std::min(least_mm, state.nearest_rms_mm);
  };
  const Expected<ValveFit> fit = fit_valve(valve, tethered(valve, 4.0, 8.0), options);
  ASSERT_TRUE(fit);
  EXPECT_LT(fit->rms_mm, fit->rms_before_mm);
  EXPECT_LE(fit->best_rms_mm, least_mm);
  EXPECT_LE(fit->rms_mm, 1.02 * fit->best_rms_mm);
  EXPECT_FALSE(doubts_of(*fit).empty());
}

TEST(Fit, DoubtsAnEndFarFromTheSurfaceAndASurfaceThatSaysLessThanIsAsked) {
  ValveFit fit;
  fit.parameters.resize(6);
  fit.rms_mm = 1.9;
  fit.independent_points = 6.0;
  EXPECT_TRUE(doubts_of(fit).empty());
  fit.rms_mm = 2.1;
  EXPECT_EQ(doubts_of(fit).size(), 1U);
  fit.independent_points = 5.0;
  EXPECT_EQ(doubts_of(fit).size(), 2U);
}

TEST(Fit, IsTheSameForAnyNumberOfThreads) {
  const Valve& valve = small_preset("human-functional-mr");
  FitOptions options = tips_alone();
  options.most_rounds = 2;
  options.threads = 1;
  const Expected<ValveFit> one = fit_valve(valve, displaced(valve), options);
  options.threads = 3;
  const Expected<ValveFit> three = fit_valve(valve, displaced(valve), options);
  ASSERT_TRUE(one);
  ASSERT_TRUE(three);
  EXPECT_EQ(one->distances_mm, three->distances_mm);
  EXPECT_EQ(one->covariance, three->covariance);
  EXPECT_EQ(one->closed.valve.heads[0].tip_mm, three->closed.valve.heads[0].tip_mm);
}

TEST(Fit, BrokenOffAfterAnyRoundItGoesOnToTheSameBits) {
  const Valve& valve = small_preset("human-functional-mr");
  FitOptions options = tips_alone();
  options.most_rounds = 2;
  std::vector<FitState> states;
  options.keep = [&](const FitState& state) { states.push_back(state); };
  const Expected<ValveFit> whole = fit_valve(valve, displaced(valve), options);
  ASSERT_TRUE(whole);
  ASSERT_EQ(static_cast<int>(states.size()), whole->rounds);
  EXPECT_GT(states.back().pass, 0);
  options.keep = nullptr;
  for (const FitState& state : states) {
    options.from = state;
    const Expected<ValveFit> resumed = fit_valve(valve, displaced(valve), options);
    ASSERT_TRUE(resumed);
    EXPECT_EQ(resumed->distances_mm, whole->distances_mm);
    EXPECT_EQ(resumed->covariance, whole->covariance);
    EXPECT_EQ(resumed->rounds, whole->rounds);
    EXPECT_EQ(resumed->closures, whole->closures);
    EXPECT_EQ(resumed->stop, whole->stop);
  }
}

TEST(Fit, SaysWhatTheDataCannotTell) {
  const Valve& valve = small_preset("human-normal");
  FitOptions options = tips_alone();
  options.unknowns.tip_sd_mm = 0.01;  // known better than any surface tells
  options.most_rounds = 1;
  const Expected<ValveFit> fit = fit_valve(valve, displaced(valve), options);
  ASSERT_TRUE(fit);
  for (const FittedParameter& fitted : fit->parameters) EXPECT_FALSE(fitted.identifiable);
}

TEST(Fit, StopsWhereItIsToldTo) {
  const Valve& valve = small_preset("human-functional-mr");
  FitOptions options = tips_alone();
  options.progress = [](int, double) { return false; };
  const Expected<ValveFit> fit = fit_valve(valve, displaced(valve), options);
  ASSERT_TRUE(fit);
  EXPECT_EQ(fit->stop, FitStop::Cancelled);
}

TEST(Fit, EndsWhenItsTimeIsOverWithTheBestSoFarAndItsUncertainty) {
  const Valve& valve = small_preset("human-functional-mr");
  FitOptions options = tips_alone();
  options.most_seconds = 1e-6;
  const Expected<ValveFit> fit = fit_valve(valve, displaced(valve), options);
  ASSERT_TRUE(fit);
  EXPECT_EQ(fit->stop, FitStop::TimeLimit);
  EXPECT_EQ(fit->rms_mm, fit->rms_before_mm);
  for (const FittedParameter& fitted : fit->parameters) {
    EXPECT_EQ(fitted.value, fitted.parameter.prior);
    EXPECT_GT(fitted.sd, 0.0);
    EXPECT_LE(fitted.sd, fitted.parameter.prior_sd);
  }
}

TEST(Fit, EndsInTheMiddleOfARoundIfItIsCancelled) {
  const Valve& valve = small_preset("human-functional-mr");
  FitOptions options = tips_alone();
  std::atomic<int> asked = 0;
  options.cancelled = [&] { return ++asked > 100; };
  const Expected<ValveFit> fit = fit_valve(valve, displaced(valve), options);
  ASSERT_TRUE(fit);
  EXPECT_EQ(fit->stop, FitStop::Cancelled);
  EXPECT_EQ(fit->rounds, 1);
}

TEST(Fit, RefusesWhatCannotBeFitted) {
  const Valve& valve = small_preset("human-normal");
  const auto path_of = [&](const MeasuredClosure& measured, const FitOptions& options) {
    const Expected<ValveFit> fit = fit_valve(valve, measured, options);
    return fit ? std::string("fitted") : fit.errors().front().path;
  };
  const MeasuredClosure good = displaced(valve);
  MeasuredClosure few = good, away = good, leak = good, broken = good, huge = good;
  few.points_mm.conservativeResize(20, 3);
  away.points_mm.col(0).array() += 100.0;
  leak.leak_mm2 = std::nan("");
  broken.points_mm(3, 1) = std::nan("");
  huge.points_mm(3, 1) = 1e300;
  EXPECT_EQ(path_of(few, tips_alone()), "/points_mm");
  EXPECT_EQ(path_of(away, tips_alone()), "/points_mm");
  EXPECT_EQ(path_of(broken, tips_alone()), "/points_mm");
  EXPECT_EQ(path_of(huge, tips_alone()), "/points_mm");
  EXPECT_EQ(path_of(leak, tips_alone()), "/leak_mm2");
  FitOptions nothing = tips_alone();
  nothing.unknowns.tips = false;
  EXPECT_EQ(path_of(good, nothing), "/unknowns");
}

}  // namespace
}  // namespace coapt
