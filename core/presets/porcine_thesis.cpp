#include "core/presets/porcine_thesis.h"

namespace coapt {
namespace {

/// Moduli above the transition, over thesis table 2.1's.
void stiffen(double factor, Tissue& tissue) {
  tissue.circumferential_post_kpa *= factor;
  tissue.radial_post_kpa *= factor;
}

}  // namespace

ParametricValve porcine_thesis_tables() {
  ParametricValve d;
  d.name = "porcine-thesis-tables";
  d.ap_mm = 26.391;
  d.al_pm_mm = 41.3;
  d.saddle_height_mm = 6.4123;
  d.anterior_height_mm = 17.971;
  d.posterior_height_mm = 17;
  d.lateral_height_mm = 11.207;
  d.commissure_height_mm = 4.5178;
  d.cleft_depth_mm = 0.5;
  d.anterior_arc = 0.42137;
  d.trigone_share = 0.66038;
  d.inclination_deg = 9.1337;
  d.tip_depth_mm = 28;
  d.tip_spread_mm = 31.855;
  d.tip_posterior_mm = 3.858;
  d.slack = 1.0715;
  d.posterior_slack = 0.90113;
  d.strut_slack = 0.92;
  d.basal_slack = 1.0792;
  d.asymmetry.tip_mm = Vec3(2.2185, 1.0923, -0.17376);
  d.asymmetry.leaflet_height = -0.077527;
  d.asymmetry.slack = -0.025703;
  d.tissue.circumferential_transition = 0.12296;
  d.tissue.radial_transition = 0.25167;
  d.tissue.reference = TissueReference::Excised;
  stiffen(2.6447, d.tissue);
  return d;
}

ParametricValve porcine_thesis() {
  ParametricValve d;
  d.name = "porcine-thesis";
  d.ap_mm = 26.613;
  d.al_pm_mm = 41.3;
  d.saddle_height_mm = 5.9155;
  d.anterior_height_mm = 23.212;
  d.posterior_height_mm = 15.113;
  d.lateral_height_mm = 9.4324;
  d.commissure_height_mm = 5.3434;
  d.cleft_depth_mm = 0.5;
  d.anterior_arc = 0.37156;
  d.trigone_share = 0.66023;
  d.inclination_deg = 8;
  d.tip_depth_mm = 27.97;
  d.tip_spread_mm = 28.777;
  d.tip_posterior_mm = 6.5278;
  d.slack = 1.0039;
  d.posterior_slack = 0.90753;
  d.strut_slack = 0.9289;
  d.basal_slack = 0.92;
  d.asymmetry.tip_mm = Vec3(0.54496, 4, 1.1944);
  d.asymmetry.leaflet_height = -0.020109;
  d.asymmetry.slack = -0.040834;
  d.tissue.circumferential_transition = 0.1275;
  d.tissue.radial_transition = 0.18594;
  d.tissue.reference = TissueReference::Excised;
  stiffen(2.9468, d.tissue);
  return d;
}

}  // namespace coapt
