#include "search/studies/valve_calibration.h"

#include <gtest/gtest.h>

#include <limits>

namespace coapt {
namespace {

const PhysiologyQuantity* quantity(const char* name) { return find_quantity(name); }

/// The healthy valve alone, by the slack of its struts; they are to bear at least 1 N.
CalibrationProblem taut_struts() {
  CalibrationProblem problem;
  problem.unknowns = {{.low = 0.85, .high = 1.2, .start = 1.15}};
  problem.valves_at = [](const std::vector<double>& values) -> Expected<CalibrationValves> {
    CalibrationValves valves;
    valves.dimensions.slack = {1.15, 1.15, 1.15, values[0], 1.15};
    valves.valves = {{.name = "healthy"}};
    return valves;
  };
  problem.bands = {
      {.quantity = quantity("strut"), .low = 1.0, .high = 2.0, .scale = 0.2, .weight = 2.0}};
  return problem;
}

TEST(BandCost, IsNothingInsideASquareNearbyAndLinearFarOff) {
  const CalibrationBand band{.low = 1.0, .high = 3.0, .scale = 0.5, .weight = 2.0};
  EXPECT_EQ(band_cost(band, 1.0), 0.0);
  EXPECT_EQ(band_cost(band, 3.0), 0.0);
  EXPECT_DOUBLE_EQ(band_cost(band, 3.25), 2.0 * 0.25);
  EXPECT_DOUBLE_EQ(band_cost(band, 0.0), 2.0 * 3.0);  // two scales: 2 x 2 - 1
  EXPECT_EQ(band_cost(band, 1e9), 60.0);
  EXPECT_EQ(band_cost(band, std::numeric_limits<double>::quiet_NaN()), 60.0);
}

TEST(BandCosts, OfAValveThatCannotBeMadeAreTheMost) {
  CalibrationProblem problem = taut_struts();
  EXPECT_EQ(band_costs(problem, {9.0}), std::vector{60.0});
  problem.valves_at = [](const std::vector<double>&) -> Expected<CalibrationValves> {
    return Error{ErrorCode::OutOfRange, "", ""};
  };
  EXPECT_EQ(band_costs(problem, {1.0}), std::vector{60.0});
}

TEST(CalibrateValves, TautensStrutsUntilTheyBear) {
  ValveCalibrationOptions options;
  options.evaluations = 20;
  options.threads = 2;
  const ValveCalibration found = calibrate_valves(taut_struts(), options);
  EXPECT_EQ(found.stop, CalibrationStop::EvaluationLimit);
  EXPECT_GT(found.cost_before, 1.0);
  EXPECT_LT(found.cost, 0.1);
  EXPECT_LT(found.values[0], 1.12);
  EXPECT_NEAR(band_costs(taut_struts(), found.values)[0], found.cost, 1e-9);
  options.threads = 1;
  EXPECT_EQ(calibrate_valves(taut_struts(), options).values, found.values);
}

TEST(CalibrateValves, EndsWhenCancelledOrOutOfTime) {
  ValveCalibrationOptions options;
  options.seconds = 0.0;
  EXPECT_EQ(calibrate_valves(taut_struts(), options).stop, CalibrationStop::TimeLimit);
  const std::atomic<bool> cancelled = true;
  options.cancelled = &cancelled;
  EXPECT_EQ(calibrate_valves(taut_struts(), options).stop, CalibrationStop::Cancelled);
}

TEST(MakeCalibrated, RemodelsTheOneHealthyValveWhoseChordaeStay) {
  CalibrationValves valves;
  valves.valves = {{.name = "healthy"},
                   {.name = "sick", .change = Remodelling{.ap_dilation_percent = 15.0}},
                   {.name = "impossible", .change = Remodelling{.ap_dilation_percent = 1500.0}}};
  const std::vector<Expected<Valve>> made = make_calibrated(valves, 300);
  ASSERT_EQ(made.size(), 3u);
  ASSERT_TRUE(made[0] && made[1]);
  EXPECT_FALSE(made[2]);
  EXPECT_EQ(made[1]->name, "sick");
  for (std::size_t c = 0; c < made[0]->chordae.size(); ++c)
    EXPECT_EQ(made[0]->chordae[c], made[1]->chordae[c]);
  EXPECT_NE(made[0]->annulus_mm, made[1]->annulus_mm);
}

}  // namespace
}  // namespace coapt
