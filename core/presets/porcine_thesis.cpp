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
  d.ap_mm = 27.671;
  d.al_pm_mm = 41.3;
  d.saddle_height_mm = 4.5;
  d.anterior_height_mm = 26.0;
  d.posterior_height_mm = 14.762;
  d.lateral_height_mm = 11.275;
  d.commissure_height_mm = 4.5;
  d.cleft_depth_mm = 0.5;
  d.anterior_arc = 0.36395;
  d.trigone_share = 0.65843;
  d.inclination_deg = 8.0;
  d.tip_depth_mm = 28.0;
  d.tip_spread_mm = 26.452;
  d.tip_posterior_mm = 3.9134;
  d.slack = 0.95364;
  d.posterior_slack = 0.9;
  d.strut_slack = 0.98034;
  d.basal_slack = 0.96079;
  d.asymmetry.tip_mm = Vec3(1.893, 2.8496, -0.24373);
  d.asymmetry.leaflet_height = -0.040779;
  d.asymmetry.slack = -0.047646;
  d.tissue.circumferential_transition = 0.10892;
  d.tissue.radial_transition = 0.12712;
  d.tissue.reference = TissueReference::Excised;
  stiffen(3.0, d.tissue);
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
