// A scallop that no chorda holds, behind a ring: it flips into the atrium.
#include <gtest/gtest.h>

#include "core/closure/closure.h"
#include "core/metrics/measure.h"
#include "core/presets/presets.h"
#include "core/repair/apply_plan.h"
#include "core/valve/remodel.h"
#include "core/valve/ruptures.h"

namespace coapt {
namespace {

/// Small enough that the anterior leaflet may catch P2 from below: where leaflets came three times as fast, it leaked 0.1 mm2.
Valve flail_p2_in_a_small_ring() {
  Remodelling change;
  change.anterolateral_mm = change.posteromedial_mm = {0.0, 0.0, 3.0};
  const Valve valve = *remodel(*make_preset("human-p2-prolapse"), change);
  return *apply_plan(valve, {{Annuloplasty{CatalogueRing{"generic-etlogix-like", 28.0}}}});
}

double leak_mm2(const Valve& valve, double speed) {
  ClosureOptions options;
  options.speed = speed;
  return measure(valve, close_valve(valve, options)).leak.area_mm2;
}

TEST(FlailScallop, FlipsAtFullAndHalfSpeed) {
  const Valve valve = flail_p2_in_a_small_ring();
  EXPECT_NEAR(leak_mm2(valve, 1.0), 22.5, 1.5);
  EXPECT_NEAR(leak_mm2(valve, 0.5), 22.5, 1.5);
}

TEST(FlailScallop, IsHeldByANeochorda) {
  const Valve valve = flail_p2_in_a_small_ring();
  EXPECT_FALSE(holds_all_scallops(valve));
  const Neochorda neochorda{valve.heads.front().id, {Leaflet::Posterior, 0.5, 1.0}, 20.0};
  const Valve repaired = *apply_plan(valve, {{neochorda}});
  EXPECT_TRUE(holds_all_scallops(repaired));
}

}  // namespace
}  // namespace coapt
