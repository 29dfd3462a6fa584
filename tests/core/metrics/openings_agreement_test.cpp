// Openings by unions of polygons and by scan lines, two programs for one figure, on closed valves.
#include <gtest/gtest.h>

#include <numbers>
#include <random>

#include "core/closure/closure.h"
#include "core/metrics/openings.h"
#include "core/metrics/openings_clipper.h"
#include "core/metrics/openings_sweep.h"
#include "core/metrics/projection.h"
#include "core/metrics/silhouette.h"
#include "core/presets/presets.h"
#include "core/valve/remodel.h"
#include "tests/scenes/small_preset.h"

namespace coapt {
namespace {

/// Those that are not specks.
std::vector<Opening> wide(const std::vector<Opening>& openings) {
  std::vector<Opening> found;
  for (const Opening& opening : openings)
    if (opening.area_mm2 > 0.1) found.push_back(opening);
  return found;
}

/// Measured: areas differ by 5e-4 mm2 at most, centroids by 6e-5 mm.
void expect_same(const std::vector<Opening>& clipped, const std::vector<Opening>& swept) {
  EXPECT_NEAR(total_mm2(clipped), total_mm2(swept), 1e-3);
  const std::vector<Opening> ours = wide(swept), theirs = wide(clipped);
  ASSERT_EQ(ours.size(), theirs.size());
  for (std::size_t i = 0; i < ours.size(); ++i) {
    EXPECT_NEAR(ours[i].area_mm2, theirs[i].area_mm2, 1e-3);
    EXPECT_LT(
        (ours[i].moment_mm3 / ours[i].area_mm2 - theirs[i].moment_mm3 / theirs[i].area_mm2).norm(),
        1e-3);
    double enclosed_mm2 = 0.0;
    for (const std::vector<Vec2>& contour_mm : ours[i].contours_mm)
      enclosed_mm2 += polygon_area(contour_mm);
    EXPECT_NEAR(enclosed_mm2, ours[i].area_mm2, 0.03) << "contours are for drawing";
  }
}

TEST(OpeningsAgreement, OfClippingAndSweepingOnEveryPresetAndDisplacedVariants) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  int sealed = 0, leaking = 0;
  for (const std::string& name : preset_names()) {
    for (int variant = 0; variant < 2; ++variant) {
      Remodelling change;
      if (variant > 0) {
        change.ap_dilation_percent = 30.0 * share(random);
        for (Vec3* tip_mm : {&change.anterolateral_mm, &change.posteromedial_mm})
          for (double& coordinate : *tip_mm) coordinate = 6.0 / std::numbers::sqrt3 * share(random);
      }
      const Expected<Valve> valve = remodel(small_preset(name), change);
      ASSERT_TRUE(valve);
      SCOPED_TRACE(name + " " + std::to_string(variant));
      const Points closed_mm = close_valve(*valve).closed_mm;
      const Projection projection =
          project_valve(*valve, closed_mm, annulus_frame(*valve, AnnulusAxis::Commissures));
      const FlatTissue tissue = silhouette(*valve, projection);
      const double half_thickness_mm = 0.5 * valve->tissue.thickness_mm;
      const Openings clipped = clipped_openings(projection.annulus, tissue, half_thickness_mm);
      const Openings swept = swept_openings(projection.annulus, tissue, half_thickness_mm);
      expect_same(*clipped.bare, *swept.bare);
      expect_same(*clipped.grown, *swept.grown);
      ++(total_mm2(clipped.grown) > 0.0 ? leaking : sealed);
    }
  }
  EXPECT_GT(sealed, 5);
  EXPECT_GT(leaking, 5);
}

}  // namespace
}  // namespace coapt
