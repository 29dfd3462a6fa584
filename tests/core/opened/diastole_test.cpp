#include "core/opened/diastole.h"

#include <gtest/gtest.h>

#include "core/metrics/annulus.h"
#include "core/repair/apply_plan.h"
#include "tests/scenes/small_preset.h"

namespace coapt {
namespace {

double tip_distance_mm(const Valve& valve) {
  return (papillary_tip_mm(valve, Side::Posteromedial) -
          papillary_tip_mm(valve, Side::Anterolateral))
      .norm();
}

TEST(Diastole, AnnulusHasTheAreaThatContractionTookAwayAndKeepsItsHeight) {
  Valve valve = small_preset("human-normal");
  valve.systole = {0.36, 0.0};
  const Valve open = *in_diastole(valve);
  const AnnulusMeasure systole = measure_annulus(valve), diastole = measure_annulus(open);
  EXPECT_NEAR(diastole.area_mm2, systole.area_mm2 / 0.64, 1e-6 * systole.area_mm2);
  EXPECT_NEAR(diastole.al_pm_mm, systole.al_pm_mm / 0.8, 1e-6);
  EXPECT_NEAR(diastole.saddle_height_mm, systole.saddle_height_mm, 1e-6);
  EXPECT_EQ(open.rest_mm, valve.rest_mm);
}

TEST(Diastole, TipsAreFurtherApartAboutTheSameMiddle) {
  Valve valve = small_preset("human-normal");
  valve.systole = {0.0, 0.25};
  const Valve open = *in_diastole(valve);
  EXPECT_NEAR(tip_distance_mm(open), tip_distance_mm(valve) / 0.75, 1e-9);
  const auto middle = [](const Valve& of) {
    return Vec3(0.5 * (papillary_tip_mm(of, Side::Posteromedial) +
                       papillary_tip_mm(of, Side::Anterolateral)));
  };
  EXPECT_NEAR((middle(open) - middle(valve)).norm(), 0.0, 1e-9);
  EXPECT_NEAR((open.annulus_mm - valve.annulus_mm).cwiseAbs().maxCoeff(), 0.0, 1e-9);
}

TEST(Diastole, ARingHoldsTheAnnulus) {
  const Valve& valve = small_preset("human-functional-mr");
  EXPECT_GT(valve.systole.annular_contraction, 0.0);
  const Valve ringed = *apply_plan(valve, {{Annuloplasty{CatalogueRing{"generic-classic", 28.0}}}});
  const Valve open = *in_diastole(ringed);
  EXPECT_NEAR((open.annulus_mm - ringed.annulus_mm).cwiseAbs().maxCoeff(), 0.0, 1e-9);
  EXPECT_GT(tip_distance_mm(open), tip_distance_mm(ringed));
}

}  // namespace
}  // namespace coapt
