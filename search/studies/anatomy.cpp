#include "search/studies/anatomy.h"

namespace coapt {

const std::array<AnatomyParameter, kAnatomyParameters>& anatomy_parameters() {
  static constexpr std::array<AnatomyParameter, kAnatomyParameters> kParameters = {
      {{"annulus, anteroposterior mm", 25.9, 28.4, 28.2},
       {"annulus, transverse mm", 36.2, 41.3, 37.0},
       {"saddle height mm", 4.5, 9.5, 7.4},
       {"anterior height mm", 17.0, 27.0, 22.0},
       {"posterior height mm", 9.0, 17.0, 13.5},
       {"lateral height mm", 7.5, 16.0, 12.5},
       {"commissure height mm", 4.5, 11.0, 8.0},
       {"cleft depth mm", 0.5, 3.0, 0.8},
       {"anterior share of the annulus", 0.33, 0.45, 0.38},
       {"trigones, share from saddle peak to commissure", 0.55, 0.9, 0.66},
       {"inclination of the leaflets deg", 8.0, 40.0, 20.0},
       {"tip depth mm", 18.0, 28.0, 22.0},
       {"tip spread mm", 15.0, 32.0, 24.0},
       {"tips behind the centre mm", -3.0, 8.0, 3.0},
       {"slack of chordae", 0.92, 1.25, 1.1},
       {"slack of posterior marginal chordae", 0.9, 1.15, 1.0},
       {"slack of strut chordae", 0.92, 1.3, 1.0},
       {"slack of basal chordae", 0.92, 1.3, 1.0},
       {"tip asymmetry, transverse mm", -4.0, 4.0, 0.0},
       {"tip asymmetry, posterior mm", -4.0, 4.0, 0.0},
       {"tip asymmetry, apical mm", -4.0, 4.0, 0.0},
       {"asymmetry of leaflet height", -0.25, 0.25, 0.0},
       {"asymmetry of slack", -0.06, 0.06, 0.0},
       {"circumferential transition strain", 0.04, 0.14, 0.10},
       {"radial transition strain", 0.08, 0.34, 0.22},
       {"modulus above transition, factor", 1.0, 3.0, 1.0}}};
  return kParameters;
}

Anatomy typical_anatomy() {
  Anatomy anatomy{};
  for (std::size_t i = 0; i < anatomy.size(); ++i) anatomy[i] = anatomy_parameters()[i].typical;
  return anatomy;
}

Anatomy anatomy_at(const std::vector<double>& shares) {
  Anatomy anatomy{};
  for (std::size_t i = 0; i < anatomy.size(); ++i) {
    const AnatomyParameter& p = anatomy_parameters()[i];
    anatomy[i] = p.lower + shares[i] * (p.upper - p.lower);
  }
  return anatomy;
}

ParametricValve parametric_valve(const Anatomy& anatomy, const std::string& name) {
  auto next = anatomy.begin();
  ParametricValve d;
  d.name = name;
  d.tissue.reference = TissueReference::Excised;
  d.ap_mm = *next++;
  d.al_pm_mm = *next++;
  d.saddle_height_mm = *next++;
  d.anterior_height_mm = *next++;
  d.posterior_height_mm = *next++;
  d.lateral_height_mm = *next++;
  d.commissure_height_mm = *next++;
  d.cleft_depth_mm = *next++;
  d.anterior_arc = *next++;
  d.trigone_share = *next++;
  d.anterior_inclination_deg = d.posterior_inclination_deg = *next++;
  d.tip_depth_mm = *next++;
  d.tip_spread_mm = *next++;
  d.tip_posterior_mm = *next++;
  const double slack = *next++;
  d.slack = {slack, slack * next[0], slack * next[0], slack * next[1], slack * next[2]};
  next += 3;
  for (int axis = 0; axis < 3; ++axis) d.asymmetry.tip_mm(axis) = *next++;
  d.asymmetry.leaflet_height = *next++;
  d.asymmetry.slack = *next++;
  d.tissue.circumferential_transition = *next++;
  d.tissue.radial_transition = *next++;
  const double stiffer = *next++;
  d.tissue.circumferential_post_kpa *= stiffer;
  d.tissue.radial_post_kpa *= stiffer;
  return d;
}

}  // namespace coapt
