#include "core/live/live_valve.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/closure/closure.h"
#include "core/closure/crossing.h"
#include "core/closure/model.h"
#include "core/closure/prepared_valve.h"
#include "core/closure/residual.h"
#include "core/closure/self_contact.h"
#include "core/repair/apply_plan.h"
#include "search/random_share.h"
#include "tests/scenes/small_preset.h"
#include "tests/scenes/small_valve.h"

namespace coapt {
namespace {

constexpr double kSystole_mmhg = 120.0;
constexpr int kMostSteps = 30000;

/// Folds that are a single vertex wide, as on 200 triangles, creep: where tolerances end a cold closure is up to 0.2 mm from rest.
const Valve& folded(const std::string& name) { return shared_preset(name, 300); }

/// Whether it came to rest.
bool settle(LiveValve& live) {
  for (int done = 0; done < kMostSteps && !live.at_rest(); done += 60) live.advance(60);
  return live.at_rest();
}

Points leaflets_mm(const LiveValve& live) { return live.vertices_mm().topRows(live.vertices()); }

double rms_mm(const Points& a, const Points& b) {
  return std::sqrt((a - b).squaredNorm() / static_cast<double>(a.rows()));
}

/// At rest to a thirtieth of the tolerances of a closure, which leave 0.1 mm.
Points cold_mm(const Valve& valve) {
  ClosureOptions options;
  options.residual_tolerance *= 0.03;
  options.way_tolerance_mm *= 0.03;
  return close_valve(valve, options).closed_mm;
}

/// The lowest, at a free edge.
int lowest_vertex(const LiveValve& live) {
  Index vertex = 0;
  leaflets_mm(live).col(2).minCoeff(&vertex);
  return static_cast<int>(vertex);
}

Vec3 random_way(std::mt19937_64& engine, double longest_mm) {
  const double x = random_share(engine), y = random_share(engine), z = random_share(engine);
  return longest_mm * (2.0 * Vec3(x, y, z) - Vec3::Ones());
}

/// A pull, a jerk in six directions or a pinch with two hooks, in turn; `shown` sees each state on the way.
template <class Shown>
void random_pull(LiveValve& live, int kind, std::mt19937_64& engine, const Shown& shown) {
  const bool jerk = kind % 3 == 1;
  const int hooks = kind % 3 == 2 ? 2 : 1;
  for (int h = 0; h < hooks; ++h) {
    const auto cables = static_cast<double>(live.cables().size());
    if (random_share(engine) < 0.2)
      live.grab_cable(h, static_cast<int>(cables * random_share(engine)), 0.5);
    else
      live.grab(h, static_cast<int>(live.vertices() * random_share(engine)));
  }
  for (int move = 0; move < (jerk ? 6 : 2); ++move) {
    for (int h = 0; h < hooks; ++h)
      live.move_to(h, live.spot_mm(h) + random_way(engine, jerk ? 25.0 : 12.0));
    for (int k = 0; k < 5; ++k) {
      live.advance(60);
      shown();
    }
  }
  for (int h = 0; h < hooks; ++h) live.release(h);
}

TEST(LiveValve, LetGoEndsInTheColdClosureAndNeverShowsACrossing) {
  std::mt19937_64 engine(1);
  for (const char* name : {"human-p2-prolapse", "marfan", "porcine-2", "secondary-mr"}) {
    const Valve& valve = folded(name);
    const Points cold = cold_mm(valve);
    LiveValve live(valve, kSystole_mmhg);
    ASSERT_TRUE(settle(live)) << name;
    const Points fresh = leaflets_mm(live);
    for (int pull = 0; pull < 3; ++pull) {
      const auto uncrossed = [&] {
        ASSERT_TRUE(crossing_pairs(valve.faces, leaflets_mm(live)).empty()) << name << pull;
      };
      random_pull(live, pull, engine, uncrossed);
      ASSERT_TRUE(live.beats());
      ASSERT_TRUE(settle(live)) << name << ' ' << pull;
      uncrossed();
      EXPECT_LT(rms_mm(leaflets_mm(live), cold), 0.1) << name << ' ' << pull;
      EXPECT_LT(rms_mm(leaflets_mm(live), fresh), 1e-3) << name << ' ' << pull;
    }
  }
}

TEST(LiveValve, TheSameCallsGiveTheSameBits) {
  const Valve& valve = small_preset("human-p2-prolapse");
  const auto end = [&] {
    std::mt19937_64 engine(7);
    LiveValve live(valve, kSystole_mmhg);
    for (int pull = 0; pull < 3; ++pull) {
      random_pull(live, pull, engine, [] {});
      live.advance(600);
    }
    return live.vertices_mm();
  };
  EXPECT_EQ(end(), end());
}

TEST(LiveValve, PressureToZeroAndBackClosesItAgain) {
  const Valve& valve = folded("human-normal");
  LiveValve live(valve, kSystole_mmhg);
  ASSERT_TRUE(settle(live));
  const Points closed = leaflets_mm(live);
  EXPECT_LT(rms_mm(closed, cold_mm(valve)), 0.1);
  live.set_pressure(0.0);
  live.advance(3000);
  EXPECT_GT(rms_mm(leaflets_mm(live), closed), 1.0);
  live.set_pressure(kSystole_mmhg);
  EXPECT_EQ(live.pressure_mmhg(), kSystole_mmhg);
  ASSERT_TRUE(settle(live));
  EXPECT_LT(rms_mm(leaflets_mm(live), closed), 0.1);
}

TEST(LiveValve, AChangeKeepsLeafletsWhereTheyAreAndEndsInTheChangedValvesColdClosure) {
  const Valve& valve = folded("human-functional-mr");
  const RepairStep ring = Annuloplasty{CatalogueRing{"generic-classic", 32.0}};
  const RepairStep shorter = ChordalLengthChange{valve.chordae.front().id, -2.0};
  for (const RepairStep& step : {ring, shorter}) {
    const Valve changed = *apply_plan(valve, {{step}});
    LiveValve live(valve, kSystole_mmhg);
    ASSERT_TRUE(settle(live));
    const Points before = leaflets_mm(live);
    live.change(changed);
    EXPECT_LT((leaflets_mm(live) - before).cwiseAbs().maxCoeff(), 1e-5);
    ASSERT_TRUE(settle(live));
    EXPECT_GT(rms_mm(leaflets_mm(live), before), 0.01);
    EXPECT_LT(rms_mm(leaflets_mm(live), cold_mm(changed)), 0.1);
  }
}

TEST(LiveValve, AnotherMeshLetsGoAndBeginsAnew) {
  LiveValve live(small_valve());
  live.grab(0, 20);
  const Valve& other = small_preset("human-normal");
  live.change(other);
  EXPECT_FALSE(live.hook(0).has_value());
  EXPECT_EQ(live.vertices(), other.rest_mm.rows());
}

TEST(LiveValve, AConstantPullBalancesTheTissue) {
  for (const double pressure_mmhg : {0.0, kSystole_mmhg}) {
    const Valve& valve = folded("human-normal");
    LiveValve live(valve, pressure_mmhg);
    settle(live);
    const int vertex = lowest_vertex(live);
    live.grab(0, vertex);
    const Vec3 before = live.spot_mm(0), pull(0.0, 0.0, 0.2);
    live.pull_with(0, pull);
    EXPECT_EQ(live.force_n(0), pull);
    settle(live);
    EXPECT_GT((live.spot_mm(0) - before).z(), 0.1);

    // The same state by the plain double-precision code: what is left of all forces.
    PreparedValve prepared(valve, {});
    ClosureModel model = prepared.model(valve);
    model.pressure_mpa = 1.33322e-4 * pressure_mmhg;
    const Points& x = live.vertices_mm();
    Points force = Points::Zero(x.rows(), 3);
    add_elastic_forces(model, x, force);
    add_pressure_forces(model, x, force);
    Contact(prepared.contact()).add_forces(model, x, force);
    for (const NodeShare& share : live.hook(0)->shares)
      force.row(share.node) += share.weight * pull.transpose();
    EXPECT_LT(rms_free(model, force, static_cast<int>(x.rows())), 1e-4) << pressure_mmhg;
  }
}

TEST(LiveValve, AHookPullsNoHarderThanItsLimit) {
  LiveValve live(small_preset("human-normal"), kSystole_mmhg);
  ASSERT_TRUE(settle(live));
  live.grab(0, 5);
  EXPECT_EQ(live.force_n(0).norm(), 0.0);
  live.move_to(0, live.spot_mm(0) + Vec3(0.0, 0.0, 500.0));
  live.advance(6000);
  EXPECT_LE(live.force_n(0).norm(), HookLimits{}.largest_n + 1e-9);
  live.release(0);
  EXPECT_EQ(live.force_n(0).norm(), 0.0);
}

}  // namespace
}  // namespace coapt
