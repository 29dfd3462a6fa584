#include "core/repair/ring_sizing.h"

#include <gtest/gtest.h>

#include "core/presets/presets.h"
#include "core/repair/apply_plan.h"
#include "core/repair/limits.h"
#include "core/valve/annulus_frame.h"
#include "tests/scenes/small_preset.h"

namespace coapt {
namespace {

TEST(RingSizing, TheTrueSizeIsThatOfTheAnteriorLeafletOnAnyMesh) {
  for (const int triangles : {200, 650}) {
    const Valve& valve = shared_preset("human-normal", triangles);
    EXPECT_NEAR(anterior_height_mm(valve), 22.8, 0.2) << triangles;  // its own dimension
    EXPECT_NEAR(true_ring_size_mm(valve), 30.4, 0.3);
    EXPECT_LT(true_ring_size_mm(valve), transverse_diameter_mm(valve));
  }
}

TEST(RingSizing, NoRingIsWiderThanTheAnnulus) {
  const Valve& valve = shared_preset("hypertrophic", 200);  // leaflets of 32 mm, for a ring of 42
  EXPECT_EQ(true_ring_size_mm(valve), transverse_diameter_mm(valve));
}

TEST(RingSizing, TheSizeNextToTheAnnulusIsNotTooWide) {
  const Valve& valve = shared_preset("human-normal", 200);
  const double width_mm = transverse_diameter_mm(valve);
  for (const double beside_mm : {-8.0, 0.0, 0.5 * kRingSizeStep_mm})
    EXPECT_FALSE(is_too_wide(valve, width_mm + beside_mm)) << beside_mm;
  EXPECT_TRUE(is_too_wide(valve, width_mm + 0.5 * kRingSizeStep_mm + 0.1));
}

TEST(RingSizing, SizesAreCountedByAreaAndFromTheTrueSize) {
  const Valve& valve = shared_preset("human-normal", 650);
  const auto below = [&](const std::string& shape, double size_mm) {
    return ring_sizes_below(valve,
                            *apply_plan(valve, {{Annuloplasty{CatalogueRing{shape, size_mm}}}}));
  };
  EXPECT_EQ(below("generic-classic", 32.0), 0.0) << "larger than the true size";
  EXPECT_NEAR(below("generic-classic", 26.0), 2.2, 0.2);
  EXPECT_GT(below("generic-etlogix-like", 26.0), below("generic-classic", 26.0) + 0.3)
      << "as wide, less deep";
}

TEST(RingSizing, ADilatedAnnulusKeepsItsTrueSize) {
  Valve dilated = shared_preset("human-normal", 200);
  dilated.annulus_mm *= 1.2;
  EXPECT_EQ(true_ring_size_mm(dilated), true_ring_size_mm(shared_preset("human-normal", 200)));
}

}  // namespace
}  // namespace coapt
