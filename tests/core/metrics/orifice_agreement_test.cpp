// The exact orifice and its image, two programs for one figure, on closed valves.
#include <gtest/gtest.h>

#include <numbers>
#include <random>

#include "core/closure/closure.h"
#include "core/metrics/exact_orifice.h"
#include "core/metrics/orifice.h"
#include "core/presets/presets.h"
#include "core/valve/remodel.h"
#include "tests/core/metrics/orifice_scene.h"
#include "tests/scenes/small_preset.h"

namespace coapt {
namespace {

/// A pixel's centre is at most half its diagonal from any of its points. Pixels that count lie in
/// the opening of leaflets thinner by that much, and they cover the opening of thicker ones.
void expect_agreement(const Valve& valve, const Points& closed_mm, const ImageSize& size) {
  const double half_thickness_mm = 0.5 * valve.tissue.thickness_mm;
  const OrificeView view = view_orifices(valve, closed_mm, half_thickness_mm, size);
  const double half_diagonal_mm = view.mm_per_pixel / std::numbers::sqrt2;
  const double widest =
      exact_orifice(valve, closed_mm, half_thickness_mm - half_diagonal_mm).area_mm2;
  const ExactOrifice exact = exact_orifice(valve, closed_mm, half_thickness_mm);
  const double narrowest =
      exact_orifice(valve, closed_mm, half_thickness_mm + half_diagonal_mm).area_mm2;
  // The annulus's own pixels, counted for the scale, are a matter of sampling also.
  const double square_mm2 =
      total_mm2(view) / view.pixel_area_mm2 * view.mm_per_pixel * view.mm_per_pixel;
  EXPECT_LE(narrowest, square_mm2 + 1e-3);
  EXPECT_GE(widest, square_mm2 - 1e-3);
  // Errors along an outline cancel: of the interval above a tenth is left. Those of a slit
  // that is narrower than a pixel everywhere do not.
  if (narrowest > 0.0) {
    EXPECT_NEAR(total_mm2(view), exact.area_mm2, 0.01 + 0.1 * (widest - narrowest));
  }
  const double raw = total_mm2(view_orifices(valve, closed_mm, 0.0, size));
  const double less = exact_orifice(valve, closed_mm, half_diagonal_mm).area_mm2;
  EXPECT_LE(less, 1.002 * raw);  // scale as above
  if (less > 0.0) {              // again no slit that is narrower than a pixel everywhere
    EXPECT_NEAR(raw, exact.area_raw_mm2, 0.01 + 0.2 * (exact.area_raw_mm2 - less));
  }
  EXPECT_LE(exact.area_mm2, exact.area_raw_mm2);
}

TEST(OrificeAgreement, OfImageAndExactAreaOnEveryPresetAndDisplacedVariants) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> share(0.0, 1.0);
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
      const ClosureResult closed = close_valve(*valve);
      expect_agreement(*valve, closed.closed_mm, {400, 300});
      expect_agreement(*valve, closed.closed_mm, {200, 150});
    }
  }
}

}  // namespace
}  // namespace coapt
