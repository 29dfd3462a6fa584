#include "core/metrics/loads.h"

#include <gtest/gtest.h>

#include "tests/scenes/sheets.h"
#include "tests/scenes/small_valve.h"

namespace coapt {
namespace {

TEST(Strain, AUniformStretchHasItsGreenLagrangeStrain) {
  const Valve valve = disc_with_hole(15.0, 3.0, 32);
  Points closed = valve.rest_mm;
  closed.col(0) *= 1.1;
  closed.col(1) *= 1.2;
  for (const FaceStrain& strain : face_strains(valve, closed)) {
    EXPECT_NEAR(strain.circumferential, 0.5 * (1.21 - 1.0), 1e-12);  // fibres run along x
    EXPECT_NEAR(strain.radial, 0.5 * (1.44 - 1.0), 1e-12);
  }
}

TEST(Strain, FibresAtFortyFiveDegreesFeelShear) {
  Valve valve = disc_with_hole(15.0, 3.0, 32);
  for (Eigen::Index f = 0; f < valve.fibre.rows(); ++f)
    valve.fibre.row(f) << std::sqrt(0.5), std::sqrt(0.5), 0.0;
  Points closed = valve.rest_mm;
  closed.col(0) += 0.2 * valve.rest_mm.col(1);  // simple shear: E_xy = 0.1, E_yy = 0.02
  for (const FaceStrain& strain : face_strains(valve, closed)) {
    EXPECT_NEAR(strain.circumferential, 0.1 + 0.01, 1e-12);
    EXPECT_NEAR(strain.radial, -0.1 + 0.01, 1e-12);
  }
}

TEST(Strain, RigidMotionStrainsNothing) {
  const Valve valve = small_valve();
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
  motion.translate(Vec3(5.0, 6.0, 7.0));
  motion.rotate(Eigen::AngleAxisd(1.0, Vec3(1.0, 2.0, 3.0).normalized()));
  for (const FaceStrain& strain : face_strains(valve, moved(valve, motion).rest_mm)) {
    EXPECT_NEAR(strain.circumferential, 0.0, 1e-12);
    EXPECT_NEAR(strain.radial, 0.0, 1e-12);
  }
}

TEST(Tension, TheLargestIsOverAllSegmentsAndTheSumOverTrunks) {
  const Valve valve = small_valve();  // chorda 0 branches, chorda 1 is one segment
  std::vector<std::vector<double>> tension_n(valve.chordae.size());
  for (std::size_t c = 0; c < tension_n.size(); ++c)
    for (const ChordaSegment& segment : valve.chordae[c].segments)
      tension_n[c].push_back(segment.parent < 0 ? 1.0 + static_cast<double>(c) : 5.0);
  const ChordaeTension tension = chordae_tension(valve, tension_n);
  EXPECT_EQ(tension.max_n, 5.0);
  EXPECT_EQ(tension.sum_n, 1.0 + 2.0);
}

TEST(Tension, WithoutChordaeThereIsNone) {
  EXPECT_EQ(chordae_tension(disc_with_hole(15.0, 3.0, 32), {}).max_n, 0.0);
}

}  // namespace
}  // namespace coapt
