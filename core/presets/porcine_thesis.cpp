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
  d.ap_mm = 28.4;
  d.al_pm_mm = 41.3;
  d.saddle_height_mm = 4.5;
  d.anterior_height_mm = 21.751;
  d.posterior_height_mm = 17;
  d.lateral_height_mm = 12.188;
  d.commissure_height_mm = 4.5;
  d.cleft_depth_mm = 0.5;
  d.anterior_arc = 0.39568;
  d.trigone_share = 0.58012;
  d.anterior_inclination_deg = d.posterior_inclination_deg = 8;
  d.tip_depth_mm = 28;
  d.tip_spread_mm = 32;
  d.tip_posterior_mm = 8;
  d.slack = {0.92, 1.007492, 1.007492, 0.9913, 0.8737516};
  d.asymmetry.tip_mm = Vec3(1.5348, 0.31016, -3.3425);
  d.asymmetry.leaflet_height = -0.11416;
  d.asymmetry.slack = -0.0098454;
  d.tissue.circumferential_transition = 0.1251;
  d.tissue.radial_transition = 0.14023;
  d.tissue.reference = TissueReference::Excised;
  stiffen(2.99, d.tissue);
  return d;
}

ParametricValve porcine_thesis() {
  ParametricValve d;
  d.name = "porcine-thesis";
  d.ap_mm = 27.21;
  d.al_pm_mm = 40.302;
  d.saddle_height_mm = 5.5109;
  d.anterior_height_mm = 20.102;
  d.posterior_height_mm = 16.213;
  d.lateral_height_mm = 10.137;
  d.commissure_height_mm = 5.3782;
  d.cleft_depth_mm = 0.5;
  d.anterior_arc = 0.4246;
  d.trigone_share = 0.62352;
  d.anterior_inclination_deg = d.posterior_inclination_deg = 13.179;
  d.tip_depth_mm = 28;
  d.tip_spread_mm = 32;
  d.tip_posterior_mm = 5.8258;
  d.slack = {1.027, 0.95615754, 0.95615754, 0.94484, 1.0121085};
  d.asymmetry.tip_mm = Vec3(0.78621, 1.4361, -0.49848);
  d.asymmetry.leaflet_height = -0.045865;
  d.asymmetry.slack = -0.030205;
  d.tissue.circumferential_transition = 0.11987;
  d.tissue.radial_transition = 0.24072;
  d.tissue.reference = TissueReference::Excised;
  stiffen(2.4846, d.tissue);
  return d;
}

}  // namespace coapt
