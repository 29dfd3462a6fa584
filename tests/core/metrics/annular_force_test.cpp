#include "core/metrics/annular_force.h"

#include <gtest/gtest.h>

#include "core/closure/closure.h"
#include "tests/scenes/small_preset.h"
#include "tests/scenes/small_valve.h"

namespace coapt {
namespace {

Vec3 sum(const std::vector<Vec3>& forces) {
  Vec3 total = Vec3::Zero();
  for (const Vec3& force : forces) total += force;
  return total;
}

TEST(AnnularForce, AnnulusAndMusclesTakeThePressure) {
  const Valve& valve = small_preset("human-normal");
  ClosureOptions options;
  options.residual_tolerance = 0.001;
  const ClosureResult closure = close_valve(valve, options);
  ASSERT_TRUE(trusted(closure));
  const SupportForces forces = support_forces(valve, closure);
  const Vec3 taken = sum(forces.annulus_n) + forces.papillary_n;
  // 16 kPa on an annulus of about 900 mm2 are 14 N.
  EXPECT_GT(forces.pressure_n.norm(), 8.0);
  EXPECT_LT((taken - forces.pressure_n).norm(), 0.01 * forces.pressure_n.norm());
  const SutureLoad load = suture_load(valve, closure, 12);
  EXPECT_GT(load.mean_n, 0.1);
  EXPECT_GE(load.max_n, load.mean_n);
  EXPECT_LE(load.out_of_plane_n, load.max_n);
}

TEST(AnnularForce, SuturesShareWhatThePullIs) {
  const Valve valve = small_valve();  // eight vertices, the saddle peak its third
  std::vector<Vec3> pull_n(8, Vec3::Zero());
  pull_n[2] = Vec3(0.0, -1.0, 0.5);
  const std::vector<Vec3> at_peak = suture_pulls_n(valve, pull_n, 4);
  EXPECT_LT((at_peak[0] - pull_n[2]).norm(), 1e-12) << "a suture is at the saddle peak";
  pull_n[3] = Vec3(0.3, 0.0, 0.0);  // between the first and the second of four
  pull_n[7] = Vec3(0.0, 0.2, 0.0);
  const std::vector<Vec3> four = suture_pulls_n(valve, pull_n, 4);
  EXPECT_NEAR((four[0] + four[1]).x(), 0.3, 1e-12);
  for (const int count : {1, 4, 12})
    EXPECT_LT((sum(suture_pulls_n(valve, pull_n, count)) - sum(pull_n)).norm(), 1e-12);
}

}  // namespace
}  // namespace coapt
