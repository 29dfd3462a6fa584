#include "core/closure/closure.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/closure/insertion_zone.h"
#include "core/closure/tauten.h"
#include "core/presets/presets.h"
#include "core/valve/validate.h"
#include "tests/scenes/small_preset.h"
#include "tests/scenes/small_valve.h"

namespace coapt {
namespace {

/// Folds that are a single vertex wide, as on 200 triangles, creep: where tolerances end a closure is up to 0.2 mm from rest.
constexpr int kFolded = 300;

Valve human(int triangles = 200) { return shared_preset("human-normal", triangles); }

/// Applies x -> R x to everything that has a place; `mirror` also restores the winding.
Valve moved(Valve valve, const Eigen::Matrix3d& r, bool mirror) {
  const auto turn = [&](Points& p) { p = (p * r.transpose()).eval(); };
  turn(valve.rest_mm);
  turn(valve.annulus_mm);
  turn(valve.fibre);
  for (PapillaryHead& head : valve.heads) {
    head.rest_mm = r * head.rest_mm;
    head.tip_mm = r * head.tip_mm;
  }
  for (Chorda& chorda : valve.chordae)
    for (ChordaSegment& segment : chorda.segments) {
      segment.branch_point_mm = r * segment.branch_point_mm;
      if (mirror) std::swap(segment.insertion.weights[1], segment.insertion.weights[2]);
    }
  if (mirror) valve.faces.col(1).swap(valve.faces.col(2));
  return valve;
}

TEST(Closure, OneThatStaysWithinItsBudgetHasTheSameBits) {
  const Valve valve = human();
  for (const Method method : {Method::Fast, Method::Thesis}) {
    const ClosureResult plain = close_valve(valve, {.method = method});
    int asked = 0;
    ClosureOptions options{.method = method};
    options.budget = {1.2 * plain.steps * static_cast<double>(valve.rest_mm.rows()),
                      [&asked] { return ++asked < 0; }};
    const ClosureResult within = close_valve(valve, options);
    EXPECT_FALSE(plain.unfinished || within.unfinished);
    EXPECT_EQ(within.closed_mm, plain.closed_mm);
    EXPECT_GE(asked, plain.steps / 20 - 1);
  }
}

TEST(Closure, OneThatSpendsItsBudgetEndsUnfinished) {
  const Valve valve = human();
  for (const Method method : {Method::Fast, Method::Thesis}) {
    ClosureOptions options{.method = method};
    options.budget.vertex_steps = 100.0 * static_cast<double>(valve.rest_mm.rows());
    const ClosureResult closed = close_valve(valve, options);
    EXPECT_TRUE(closed.unfinished);
    EXPECT_EQ(closed.status, ClosureStatus::StepLimit);
    EXPECT_EQ(closed.attempts.size(), 1U);
    EXPECT_NEAR(closed.steps, 100, 20);
    EXPECT_TRUE(closed.closed_mm.allFinite());
  }
}

TEST(Closure, OneThatIsCancelledEndsAtOnce) {
  ClosureOptions options;
  options.budget.cancelled = [] { return true; };
  const ClosureResult closed = close_valve(human(), options);
  EXPECT_TRUE(closed.unfinished);
  EXPECT_LE(closed.steps, 20);
}

TEST(Closure, BranchPointsRestWhereTheirCablesBalance) {
  const Valve valve = human();
  ClosureOptions options;
  options.residual_tolerance = 1e-5;
  const ClosureResult closed = close_valve(valve, options);
  ASSERT_EQ(closed.status, ClosureStatus::Converged);
  int forks = 0;
  for (std::size_t c = 0; c < valve.chordae.size(); ++c) {
    const Chorda& chorda = valve.chordae[c];
    if (chorda.segments.size() < 2) continue;
    const Vec3 tip = valve.heads[chorda.head].tip_mm;
    const Vec3 fork = closed.branch_points_mm[c].row(0);
    Vec3 sum = closed.tension_n[c][0] * (tip - fork).normalized();
    for (std::size_t s = 1; s < chorda.segments.size(); ++s) {
      const ChordaSegment& twig = chorda.segments[s];
      const Vec3 end =
          mean_position(insertion_zone(valve, twig.insertion, twig.zone_mm), closed.closed_mm);
      sum += closed.tension_n[c][s] * (end - fork).normalized();
    }
    EXPECT_NEAR(sum.norm(), 0.0, 2e-3) << chorda.id;
    forks += closed.tension_n[c][0] > 0.05;
  }
  EXPECT_GT(forks, 5);
}

TEST(Closure, TurnsWithTheValve) {
  const Valve valve = human();
  const Eigen::Matrix3d r = Eigen::AngleAxisd(1.0, Vec3(1, 2, 3).normalized()).toRotationMatrix();
  ClosureOptions options;
  options.residual_tolerance = 1e-4;
  options.method = Method::Thesis;
  const ClosureResult here = close_valve(valve, options);
  const ClosureResult there = close_valve(moved(valve, r, false), options);
  ASSERT_EQ(here.status, ClosureStatus::Converged);
  ASSERT_EQ(there.status, ClosureStatus::Converged);
  const Points back = there.closed_mm * r;
  EXPECT_LT((back - here.closed_mm).rowwise().norm().maxCoeff(), 0.05);
}

TEST(Closure, OfTheMirrorImageIsTheMirrorImage) {
  const Valve valve = human();
  const Eigen::Matrix3d r = Vec3(-1, 1, 1).asDiagonal();
  ClosureOptions options;
  options.residual_tolerance = 1e-4;
  options.method = Method::Thesis;
  const ClosureResult here = close_valve(valve, options);
  const ClosureResult there = close_valve(moved(valve, r, true), options);
  EXPECT_LT((there.closed_mm * r - here.closed_mm).rowwise().norm().maxCoeff(), 0.05);
}

TEST(Closure, OfTheTurnedOrMirroredValveMayDifferInSlackTissueOnlyWhenFast) {
  // The order of sums differs, the way to rest with it, and slack edges may come to rest elsewhere.
  const Valve valve = human(kFolded);
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(1.0, Vec3(1, 2, 3).normalized()).toRotationMatrix();
  const Eigen::Matrix3d mirror = Vec3(-1, 1, 1).asDiagonal();
  const ClosureResult here = close_valve(valve);
  for (const auto& [r, mirrored] : {std::pair(turn, false), std::pair(mirror, true)}) {
    const Points apart = close_valve(moved(valve, r, mirrored)).closed_mm * r - here.closed_mm;
    EXPECT_LT(std::sqrt(apart.squaredNorm() / static_cast<double>(apart.rows())), 0.05) << mirrored;
  }
}

TEST(Closure, ClimbsTheWholeLadderBeforeItSaysThatItDidNotConverge) {
  ClosureOptions options;
  options.max_steps = 40;
  const ClosureResult closed = close_valve(human(), options);
  EXPECT_EQ(closed.status, ClosureStatus::StepLimit);
  std::vector<std::string> tried;
  for (const ClosureAttempt& attempt : closed.attempts) {
    EXPECT_EQ(attempt.status, ClosureStatus::StepLimit);
    tried.push_back(attempt.how);
  }
  EXPECT_EQ(tried, (std::vector<std::string>{
                       "float", "float, edge contact", "float, edge contact, slow",
                       "double, edge contact, slow", "double, edge contact, lightly damped",
                       "double, edge contact, slow, load in parts"}));
}

TEST(Closure, FromItsOwnClosureStaysThere) {
  const Valve valve = human(kFolded);
  const ClosureResult cold = close_valve(valve);
  const ClosureResult warm = close_valve(valve, {}, &cold);
  ASSERT_EQ(warm.status, ClosureStatus::Converged);
  EXPECT_EQ(warm.attempts.front().how, "float, from a neighbour");
  EXPECT_LT(warm.steps, cold.steps / 2);
  const Points apart = warm.closed_mm - cold.closed_mm;
  EXPECT_LT(std::sqrt(apart.squaredNorm() / static_cast<double>(apart.rows())), 0.02);
}

TEST(Closure, TellsWhereThePointsOfARupturedChordaAre) {
  Valve valve = human();
  std::size_t c = 0;
  while (valve.chordae[c].segments.size() < 2) ++c;
  valve.chordae[c].ruptured = true;
  const ClosureResult closed = close_valve(valve);
  for (std::size_t s = 0; s < valve.chordae[c].segments.size(); ++s) {
    EXPECT_EQ(closed.tension_n[c][s], 0.0);
    const Vec3 end = closed.branch_points_mm[c].row(s);
    const ChordaSegment& segment = valve.chordae[c].segments[s];
    if (!segment.inserts) {
      EXPECT_LT((end - segment.branch_point_mm).norm(), 10.0);
      EXPECT_GT(end.norm(), 1.0);  // not at the origin
      continue;
    }
    Vec3 insertion = Vec3::Zero();
    for (int k = 0; k < 3; ++k)
      insertion += segment.insertion.weights[k] *
                   closed.closed_mm.row(valve.faces(segment.insertion.face, k)).transpose();
    EXPECT_LT((end - insertion).norm(), 1e-9);
  }
}

TEST(Closure, StartsFromTheOpenStateIfTheNeighbourIsUnfit) {
  const Valve valve = human();
  const ClosureResult cold = close_valve(valve);
  ClosureResult neighbour = cold;
  neighbour.status = ClosureStatus::StepLimit;
  EXPECT_EQ(close_valve(valve, {}, &neighbour).closed_mm, cold.closed_mm);
  neighbour = cold;
  neighbour.crossing = true;
  EXPECT_EQ(close_valve(valve, {}, &neighbour).closed_mm, cold.closed_mm);
  const ClosureResult finer = close_valve(human(650));
  EXPECT_EQ(close_valve(valve, {}, &finer).closed_mm, cold.closed_mm);
}

TEST(Closure, OfTheSameValveGivesTheSameBits) {
  const Valve valve = human();
  const ClosureResult a = close_valve(valve), b = close_valve(valve);
  EXPECT_EQ(a.closed_mm, b.closed_mm);
  EXPECT_EQ(a.steps, b.steps);
  EXPECT_EQ(a.tension_n, b.tension_n);
}

TEST(Closure, KeepsAnnulusAndTipsWhereTheySitUnderPressure) {
  Valve valve = human();
  valve.annulus_mm.col(1) *= 0.9;
  const ClosureResult closed = close_valve(valve);
  for (std::size_t i = 0; i < valve.annulus.size(); ++i)
    EXPECT_EQ(closed.closed_mm.row(valve.annulus[i]), valve.annulus_mm.row(i));
}

TEST(Closure, SamplesStayCloseOnceTheValveIsAtRest) {
  ClosureOptions options;
  options.samples = 5;
  const ClosureResult closed = close_valve(human(), options);
  ASSERT_EQ(closed.samples_mm.size(), 5u);
  EXPECT_EQ(closed.samples_mm.front(), closed.closed_mm);
  for (const Points& sample : closed.samples_mm)
    EXPECT_LT((sample - closed.closed_mm).rowwise().norm().maxCoeff(), 0.1);
}

TEST(Closure, KeepsItsWayFromTheOpenToTheClosedStateWithoutAJumpAndWithoutChangingIt) {
  for (const char* name : {"human-normal", "porcine-1", "human-p2-prolapse"}) {
    const Valve& valve = small_preset(name);
    const ClosureResult plain = close_valve(valve);
    const ClosureResult kept = close_valve(valve, {.motion = true});
    EXPECT_TRUE(plain.motion_mm.empty());
    EXPECT_EQ(plain.closed_mm, kept.closed_mm);
    EXPECT_EQ(plain.steps, kept.steps);
    const auto vertices = valve.rest_mm.rows();
    ASSERT_GT(kept.motion_mm.size(), 10u);
    EXPECT_EQ(kept.motion_mm.front().topRows(vertices), valve.rest_mm);
    EXPECT_EQ(kept.motion_mm.back().topRows(vertices), kept.closed_mm);
    constexpr double kFarthest_mm = 15 * 0.15;  // in 15 steps
    for (std::size_t i = 1; i < kept.motion_mm.size(); ++i) {
      const Points way = (kept.motion_mm[i] - kept.motion_mm[i - 1]).topRows(vertices);
      EXPECT_LT(way.rowwise().norm().maxCoeff(), 1.001 * kFarthest_mm) << name << ' ' << i;
    }
  }
}

TEST(Closure, ThatRunsOutOfStepsSaysSo) {
  ClosureOptions options;
  options.max_steps = 100;
  const ClosureResult closed = close_valve(human(), options);
  EXPECT_EQ(closed.status, ClosureStatus::StepLimit);
  EXPECT_GT(closed.residual, 0.01);
}

TEST(Closure, ThatOverflowsIsDivergedAndNotAnAnswer) {
  ClosureOptions options;
  options.method = Method::Thesis;
  options.contact_pressure_mpa = std::numeric_limits<double>::max();
  EXPECT_EQ(close_valve(human(), options).status, ClosureStatus::Diverged);
}

TEST(Closure, WithContactTooSoftIsCaughtCrossing) {
  ClosureOptions options;
  options.contact_pressure_mpa = 1e-6;
  EXPECT_TRUE(close_valve(human(), options).crossing);
}

TEST(Closure, WithEdgeContactLeavesOutTheAttemptWithout) {
  for (const Method method : {Method::Fast, Method::Thesis}) {
    const ClosureResult closed = close_valve(human(), {.method = method, .edge_contact = true});
    EXPECT_EQ(closed.status, ClosureStatus::Converged);
    EXPECT_NE(closed.attempts.front().how.find("edge contact"), std::string::npos);
    EXPECT_EQ(closed.method, method);
    EXPECT_EQ(closed.membrane, Membrane::Continuum);
  }
}

TEST(Closure, HardlyChangesIfTheAnteriorLeafletCannotTouchItself) {
  const Valve valve = human(650);
  const Points apart = close_valve(valve).closed_mm -
                       close_valve(valve, {.self_contact = SelfContact::NotAnterior}).closed_mm;
  EXPECT_GT(apart.norm(), 0.0);
  EXPECT_LT(std::sqrt(apart.squaredNorm() / static_cast<double>(apart.rows())), 0.2);
}

TEST(Closure, OfSurplusLeafletFallsBackOnEdgeContactAndEndsUncrossed) {
  // Heights a fifth over porcine-1: tight folds that vertex-face contact alone lets cross.
  ParametricValve d;
  d.ap_mm = 28.1;
  d.al_pm_mm = 37.7;
  d.anterior_height_mm = 23.9;
  d.posterior_height_mm = 13.5;
  d.lateral_height_mm = 12.1;
  d.commissure_height_mm = 9.1;
  d.tip_depth_mm = 22.5;
  d.tip_spread_mm = 22.6;
  const ClosureResult closed = close_valve(*make_taut_valve(d));
  EXPECT_EQ(closed.status, ClosureStatus::Converged);
  EXPECT_EQ(closed.crossing_pairs, 0);
}

TEST(Tauten, MakesEveryChordaAsLongAsInTheClosedStateTimesItsSlack) {
  const Valve valve = small_valve();
  const ClosureResult closed = close_valve(valve);
  const Valve taut = tauten(valve, closed, 1.1);
  const Vec3 tip = valve.heads[valve.chordae[1].head].tip_mm;
  const Vec3 end = closed.branch_points_mm[1].row(0);
  EXPECT_NEAR(taut.chordae[1].segments[0].rest_length_mm, 1.1 * (end - tip).norm(), 1e-12);
  EXPECT_TRUE(validate(taut).empty());
}

}  // namespace
}  // namespace coapt
