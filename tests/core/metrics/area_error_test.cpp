#include "core/metrics/area_error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/closure/closure.h"
#include "core/metrics/measure.h"
#include "tests/scenes/small_preset.h"

namespace coapt {
namespace {

TEST(AreaError, FallsWithTheMeshAndGrowsWithTheAreaAndTheTolerances) {
  for (const Membrane membrane : {Membrane::Springs, Membrane::Continuum}) {
    double before = std::numeric_limits<double>::infinity();
    for (const int triangles : {60, 325, 400, 650, 1300, 2600, 5200, 10400, 40000}) {
      const AreaPrecision precision{triangles, membrane};
      const double open = area_error_mm2(50.0, precision);
      EXPECT_LT(open, before) << triangles;
      EXPECT_LT(area_error_mm2(0.0, precision), open) << triangles;
      EXPECT_GT(area_error_mm2(0.0, precision), 0.0) << triangles;
      before = open;
    }
    const AreaPrecision loose{650, membrane, 0.1, 0.4};
    EXPECT_GT(area_error_mm2(10.0, loose), area_error_mm2(10.0, {650, membrane}));
  }
}

TEST(AreaError, BetweenTwoMeshesLiesBetweenTheirErrors) {
  const double coarse = area_error_mm2(20.0, {650}), fine = area_error_mm2(20.0, {1300});
  const double between = area_error_mm2(20.0, {900});
  EXPECT_LT(between, coarse);
  EXPECT_GT(between, fine);
}

TEST(AreaError, OfWhatIsNotKnownIsNotKnown) {
  EXPECT_TRUE(std::isnan(area_error_mm2(std::nan(""), {650})));
}

TEST(AreaError, OfAClosureIsThatOfItsMeshAndTolerances) {
  const Valve& valve = small_preset("human-functional-mr");
  ClosureOptions options;
  options.residual_tolerance = 0.1;
  options.way_tolerance_mm = 0.4;
  ClosureResult closure = close_valve(valve, options);
  const ValveMeasure measured = measure(valve, closure);
  const AreaPrecision precision{static_cast<int>(valve.faces.rows()), Membrane::Continuum, 0.1,
                                0.4};
  EXPECT_EQ(measured.leak_error_mm2, area_error_mm2(measured.leak.area_mm2, precision));

  closure.crossing = true;
  EXPECT_TRUE(std::isnan(measure(valve, closure).leak_error_mm2)) << "its areas mean nothing";
}

}  // namespace
}  // namespace coapt
