#include "core/live/passivity.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <numbers>
#include <random>
#include <vector>

#include "core/live/live_valve.h"
#include "core/live/nearest_hold.h"
#include "search/random_share.h"
#include "tests/scenes/small_preset.h"
#include "tests/scenes/small_valve.h"

namespace coapt {
namespace {

using Path = std::vector<Vec3>;

constexpr double kPeriod_ms = 1.0;

Vec3 random_vector(std::mt19937_64& engine) {
  const double x = random_share(engine), y = random_share(engine), z = random_share(engine);
  return 2.0 * Vec3(x, y, z) - Vec3::Ones();
}

/// A closed path of three tones with random amplitudes, begun and ended at rest at the origin.
Path closed_stroke(std::mt19937_64& engine, int periods, double size_mm) {
  std::array<Vec3, 3> tones;
  for (Vec3& tone : tones) tone = size_mm / 3.0 * random_vector(engine);
  Path path;
  for (int n = 0; n <= periods; ++n) {
    const double t = static_cast<double>(n) / periods;
    Vec3 at = Vec3::Zero();
    for (std::size_t k = 0; k < tones.size(); ++k)
      at += std::sin(2.0 * std::numbers::pi * static_cast<double>(k + 1) * t) * tones[k];
    path.push_back(std::pow(std::sin(std::numbers::pi * t), 2) * at);
  }
  return path;
}

/// Accelerations thrown about, each of the size that a hand can have at most, for 1 to 20 periods.
Path jerks(std::mt19937_64& engine, int periods, const PassivityLimits& limits) {
  Path path = {Vec3::Zero()};
  Vec3 way = Vec3::Zero(), acceleration = Vec3::Zero();
  for (int n = 0, left = 0; n < periods; ++n) {
    if (left-- == 0) {
      acceleration = random_vector(engine).normalized() * limits.acceleration_mm_per_ms2;
      // Back towards the middle where it is fast.
      if (way.norm() > 0.5) acceleration = -way.normalized() * limits.acceleration_mm_per_ms2;
      left = static_cast<int>(20.0 * random_share(engine));
    }
    way += acceleration * kPeriod_ms * kPeriod_ms;
    path.push_back(path.back() + way);
  }
  return path;
}

/// A spring to the origin whose force is computed from a place so many periods ago.
struct LateSpring {
  double stiffness_n_per_mm;
  std::size_t delay;
  std::deque<Vec3> places{};
  Vec3 operator()(const Vec3& hand_mm) {
    places.push_back(hand_mm);
    if (places.size() > delay + 1) places.pop_front();
    return -stiffness_n_per_mm * places.front();
  }
};

/// What a hand puts in on a path, mJ: force times way, each force held for a period.
double raw_energy_mj(const Path& path, LateSpring spring) {
  double energy = 0.0;
  for (std::size_t n = 0; n + 1 < path.size(); ++n)
    energy -= spring(path[n]).dot(path[n + 1] - path[n]);
  return energy;
}

PassivityAccount controlled(const Path& path, LateSpring spring,
                            const PassivityLimits& limits = {}) {
  PassivityAccount account;
  for (const Vec3& place : path) passive_force_n(account, place, spring(place), kPeriod_ms, limits);
  return account;
}

TEST(Passivity, AnEnergyIsForceTimesWay) {
  PassivityAccount account;
  observe(account, Vec3::Zero());
  account.shown_n = Vec3(-2.0, 0.0, 0.0);
  observe(account, Vec3(0.5, 3.0, 0.0));
  EXPECT_DOUBLE_EQ(account.energy_mj, 1.0);
  account.shown_n = Vec3(0.0, -1.0, 0.0);
  observe(account, Vec3(0.5, 1.0, 0.0));
  EXPECT_DOUBLE_EQ(account.energy_mj, -1.0);
  EXPECT_DOUBLE_EQ(account.lowest_mj, -1.0);
}

TEST(Passivity, ASampledSpringGivesAwayHalfItsStiffnessTimesTheSquareOfEachWay) {
  // Out by 10 steps of 0.1 mm and back: twice 10 k 0.1^2 / 2.
  Path path;
  for (int n = 0; n <= 20; ++n) path.push_back(Vec3(0.1 * (n <= 10 ? n : 20 - n), 0.0, 0.0));
  EXPECT_NEAR(raw_energy_mj(path, {0.5, 0}), -20 * 0.5 * 0.5 * 0.01, 1e-12);
}

TEST(Passivity, LateSpringsFeedAHandOnClosedPathsAndControlledOnesDoNot) {
  std::mt19937_64 engine(1);
  const PassivityLimits limits;
  int fed = 0;
  for (int i = 0; i < 500; ++i) {
    const Path path = closed_stroke(engine, 200 + i, 10.0);
    for (const std::size_t delay : {0U, 1U, 5U}) {
      for (const double stiffness : {0.1, 0.5, 5.0}) {
        if (raw_energy_mj(path, {stiffness, delay}) < 0.0) ++fed;
        const PassivityAccount account = controlled(path, {stiffness, delay});
        ASSERT_GE(account.energy_mj, 0.0) << i << ' ' << delay << ' ' << stiffness;
        ASSERT_GE(account.lowest_mj, -limits.credit_mj) << i << ' ' << delay << ' ' << stiffness;
      }
    }
  }
  EXPECT_EQ(fed, 500 * 9);
}

TEST(Passivity, JerksGainNothing) {
  std::mt19937_64 engine(2);
  const PassivityLimits limits;
  for (int i = 0; i < 200; ++i) {
    const Path path = jerks(engine, 1000, limits);
    for (const std::size_t delay : {0U, 1U, 5U})
      ASSERT_GE(controlled(path, {2.0, delay}).lowest_mj, -limits.credit_mj * (1.0 + 1e-9))
          << i << ' ' << delay;
  }
}

TEST(Passivity, ASourceOfForceCannotDriveTheHand) {
  // A force that always goes where the hand goes.
  std::mt19937_64 engine(3);
  const PassivityLimits limits;
  PassivityAccount account;
  Vec3 before = Vec3::Zero();
  for (const Vec3& place : jerks(engine, 5000, limits)) {
    const Vec3 way = place - before;
    before = place;
    passive_force_n(account, place, 3.0 * way.normalized(), kPeriod_ms, limits);
    ASSERT_GE(account.energy_mj, -limits.credit_mj * (1.0 + 1e-9));
  }
}

TEST(Passivity, ASlowHandFeelsTheWholeSpring) {
  PassivityAccount account;
  LateSpring spring{0.5, 1};
  for (int n = 0; n <= 400; ++n) {
    const Vec3 hand(0.01 * n, 0.0, 0.0);  // 10 mm/s
    const Vec3 wanted = spring(hand);
    const Vec3 shown = passive_force_n(account, hand, wanted, kPeriod_ms);
    if (n >= 50) {
      EXPECT_EQ(shown, wanted) << n;
    }
  }
  EXPECT_NEAR(account.energy_mj, 0.5 * 0.5 * 4.0 * 4.0, 0.05);
}

TEST(Passivity, ADebtIsPaidBackByResistance) {
  // A leap that no hand makes, with the force; then a hand that goes on evenly.
  const PassivityLimits limits;
  PassivityAccount account;
  for (int n = 0; n <= 100; ++n)
    passive_force_n(account, Vec3(0.02 * n, 0.0, 0.0), Vec3(-0.01 * n, 0.0, 0.0), kPeriod_ms);
  passive_force_n(account, Vec3(-8.0, 0.0, 0.0), Vec3::Zero(), kPeriod_ms);
  EXPECT_LT(account.energy_mj, -1.0);
  double x = -8.0;
  for (int n = 0; n < 2000 && account.energy_mj < 0.0; ++n) {
    x += 0.2;
    const Vec3 shown =
        passive_force_n(account, Vec3(x, 0.0, 0.0), Vec3(1.0, 0.0, 0.0), kPeriod_ms, limits);
    if (n > 0 && account.energy_mj < 0.0) {
      EXPECT_LT(shown.x(), 0.0);
    }
  }
  EXPECT_GE(account.energy_mj, 0.0);
}

/// The hand's energy on closed paths of a stylus that holds a valve, a look of the valve a period, the spot a period late.
double lowest_on_a_valve_mj(const Valve& valve, int paths, int periods, std::uint64_t seed) {
  std::mt19937_64 engine(seed);
  LiveValve live(valve, 120.0);
  for (int k = 0; k < 300 && !live.at_rest(); ++k) live.advance(60);
  double lowest = 0.0;
  for (int i = 0; i < paths; ++i) {
    const auto vertex = static_cast<double>(live.vertices()) * random_share(engine);
    live.grab(0, static_cast<int>(vertex));
    const Vec3 start = live.spot_mm(0);
    PassivityAccount account;
    for (const Vec3& way : closed_stroke(engine, periods, 6.0)) {
      Hook hook;
      hook.hook_mm = start + way;
      const Vec3 late_spot = live.spot_mm(0);
      live.move_to(0, hook.hook_mm);
      live.advance(30);
      passive_force_n(account, hook.hook_mm, -pull_n(hook, late_spot, HookLimits{}), kPeriod_ms);
    }
    live.release(0);
    live.advance(300);
    lowest = std::min(lowest, account.energy_mj);
  }
  return lowest;
}

TEST(Passivity, AHandGainsNothingOnClosedPathsWithAValve) {
  EXPECT_GE(lowest_on_a_valve_mj(small_valve(), 60, 120, 1), 0.0);
  EXPECT_GE(lowest_on_a_valve_mj(small_preset("human-p2-prolapse"), 5, 120, 2), 0.0);
}

}  // namespace
}  // namespace coapt
