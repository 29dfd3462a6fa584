#include "lab/leak/leak_study.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "lab/leak/drawn_valves.h"
#include "lab/leak/leak_tables.h"

namespace coapt {
namespace {

LeakCase made(int number, double reference_mm2, double area_mm2, double error_mm2) {
  LeakCase one;
  one.number = number;
  one.valve = "made";
  one.repair = "none";
  one.is_trusted = true;
  one.reference.area_mm2 = reference_mm2;
  one.reference.levels.resize(1);
  one.areas = {{"guess", area_mm2, error_mm2}};
  return one;
}

TEST(LeakAgreement, IsCountedByHalvesAsOneWouldByHand) {
  std::vector<LeakCase> cases = {made(0, 10.0, 8.0, 1.0),  made(2, 20.0, 22.0, 3.0),
                                 made(4, 2.0, 0.5, 2.0),   made(6, 0.5, 1.2, 0.5),
                                 made(1, 10.0, 10.0, 1.0), made(3, 10.0, 99.0, 1.0)};
  cases.back().is_trusted = false;
  const std::vector<LeakAgreement> both = leak_agreements(cases);
  ASSERT_EQ(both.size(), 2U);
  const LeakAgreement& seen = both[0];
  EXPECT_EQ(seen.measure, "guess");
  EXPECT_EQ(seen.large, 2);  // -20 and +10 %
  EXPECT_DOUBLE_EQ(seen.bias_percent, -5.0);
  EXPECT_DOUBLE_EQ(seen.sd_percent, 15.0);
  EXPECT_DOUBLE_EQ(seen.median_percent, 15.0);
  EXPECT_DOUBLE_EQ(seen.worst_percent, 20.0);
  EXPECT_EQ(seen.small, 2);
  EXPECT_DOUBLE_EQ(seen.small_mean_mm2, 1.1);
  EXPECT_DOUBLE_EQ(seen.small_worst_mm2, 1.5);
  EXPECT_EQ(seen.flips, 2);
  EXPECT_EQ(seen.unsafe, 1);
  EXPECT_EQ(seen.outside, 2);
  EXPECT_EQ(seen.with_error, 4);
  EXPECT_EQ(both[1].valves, "held out");
  EXPECT_EQ(both[1].large, 1);
  EXPECT_EQ(both[1].flips, 0);
}

TEST(LeakAgreement, WithoutAPrintedErrorNothingIsOutsideIt) {
  const LeakAgreement only =
      leak_agreements({made(0, 10.0, 1.0, std::numeric_limits<double>::quiet_NaN())}).front();
  EXPECT_EQ(only.outside, 0);
  EXPECT_EQ(only.with_error, 0);
}

TEST(LeaksCsv, LeavesEmptyWhatIsUnknown) {
  LeakCase lost = made(1, 0.0, 0.0, 0.0);
  lost.is_trusted = false;
  lost.areas.clear();
  const std::string csv =
      leaks_csv({made(0, 2.0, 1.5, std::numeric_limits<double>::quiet_NaN()), lost});
  EXPECT_EQ(csv,
            "number,valve,repair,held_out,triangles,trusted,reference_mm2,surface_mm2,primal_mm2,"
            "dual_mm2,"
            "coarser_mm2,openings,cells,widened,seconds,guess_mm2,guess_error_mm2\n"
            "0,\"made\",none,false,0,true,2.000,0.000,0.000,0.000,,0,0,0,0.0,1.500,\n"
            "1,\"made\",none,true,0,false\n");
}

TEST(DrawnValve, IsThePresetFirstAndThenRepairedInTurn) {
  EXPECT_EQ(drawn_valve(0, 1).name, "porcine-1");
  const DrawnValve clip = drawn_valve(17, 1);
  EXPECT_EQ(clip.repair, "clip");
  EXPECT_FALSE(clip.valve.ties.empty());
  EXPECT_EQ(drawn_valve(18, 1).repair, "neochordae");
}

TEST(LeakStudy, ClosesAndOpensTheSameValves) {
  // The reference reads 0.22 mm² at 0.5 mm, 0.11 at 0.25 and 0.125: a trace that voxels must be fine for.
  const LeakCase closed = study_leaks({.count = 1, .finest_mm = 0.25}).front();
  EXPECT_TRUE(closed.is_trusted);
  EXPECT_LT(closed.reference.area_mm2, 0.2);
  EXPECT_EQ(closed.areas.back().measure, "leak");
  EXPECT_NEAR(closed.areas.back().area_mm2, closed.reference.area_mm2, 0.1);
  const LeakCase opened = study_leaks({.count = 1, .finest_mm = 0.5, .opened = true}).front();
  EXPECT_EQ(opened.valve, closed.valve);
  EXPECT_GT(opened.reference.area_mm2, 300.0);
  EXPECT_NEAR(opened.areas.back().area_mm2, opened.reference.area_mm2,
              0.05 * opened.reference.area_mm2);
}

}  // namespace
}  // namespace coapt
