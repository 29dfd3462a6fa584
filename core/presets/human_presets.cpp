#include "core/presets/human_presets.h"

#include "core/presets/taut_valve.h"

namespace coapt {
namespace {

HumanValve diseased(const Remodelling& change, const char* disease) {
  return {human_normal().dimensions, change, disease};
}

}  // namespace

Expected<Valve> make_human_valve(const HumanValve& human) {
  Expected<Valve> valve = make_taut_valve(human.dimensions);
  if (!valve || !human.change) return valve;
  Expected<Valve> remodelled = remodel(*valve, *human.change);
  if (remodelled && !human.disease.empty()) remodelled->provenance.push_back(human.disease);
  return remodelled;
}

HumanValve human_normal() {
  ParametricValve d;
  d.ap_mm = 26.14;
  d.al_pm_mm = 33.0133;
  d.saddle_height_mm = 7.4486;
  d.anterior_arc = 0.388849;
  d.anterior_height_mm = 22.8;
  d.posterior_height_mm = 13.129;
  d.lateral_height_mm = 12.8;
  d.commissure_height_mm = 8.6;
  d.cleft_depth_mm = 0.525;
  d.posterior_fold_mm = 4.815;
  d.anterior_fold_mm = 4.133;
  d.anterior_inclination_deg = -4.53782;
  d.posterior_inclination_deg = 8.487;
  d.tip_depth_mm = 25.2;
  d.tip_spread_mm = 20.0;
  d.tip_posterior_mm = 6.0008;
  d.slack = {1.095, 1.104, 0.95, 0.849036, 1.02};
  d.asymmetry.tip_mm = Vec3(0.5, 0.5, 0.0);
  d.asymmetry.leaflet_height = 0.03;
  // Extension that the unpressurised heart leaves, and stiffness over the default's.
  d.tissue.circumferential_prestretch = (1.0 + d.tissue.circumferential_transition) / 1.0589781;
  d.tissue.radial_prestretch = (1.0 + d.tissue.radial_transition) / 1.0538171;
  d.tissue.circumferential_post_kpa *= 0.82988;
  d.tissue.radial_post_kpa *= 1.71961;
  return {d, {}, ""};
}

HumanValve human_functional_mr() {
  Remodelling change;
  change.ap_dilation_percent = 17.0;
  change.annular_height_percent = 75.7219;
  change.anterolateral_mm = Vec3(4.12527, 3.8582, 0.77249);
  change.posteromedial_mm = Vec3(4.6076, 2.96508, 1.03272);
  return diseased(
      change,
      "functional regurgitation of the healthy preset: annulus dilated and flattened, "
      "papillary tips displaced outwards and backwards, calibrated to leak, tenting and what "
      "rings leave (examples/calibration)");
}

HumanValve human_p2_prolapse() {
  Remodelling change;
  change.ap_dilation_percent = 8.0;
  change.ruptured = {Segment::P2};
  return diseased(
      change,
      "degenerative prolapse of the healthy preset: marginal chordae of P2 ruptured, annulus "
      "dilated 8 % in its anteroposterior diameter");
}

HumanValve barlow() {
  Remodelling change;
  change.growth_percent = 9.0677;  // half of the annulus's growth, the other half by dilation
  change.ap_dilation_percent = 18.9577;
  change.annular_height_percent = 60.0;
  change.leaflet_growth_percent = 10.0;
  change.chordal_elongation_percent = 11.0;
  change.elongated = {
      {Segment::A2, 10.0}, {Segment::P1, 10.0}, {Segment::P2, 35.0}, {Segment::P3, 10.0}};
  change.tissue = {200.0, 150.0, 60.0, 60.0};
  change.systole = SystolicMotion{.annular_contraction = 0.044};
  return diseased(
      change,
      "Barlow's disease of the healthy preset: annulus of 15.0 / 10.6 times the area that "
      "changes by 4.4 % (Cardiovasc Ultrasound 2016, s12947-016-0073-4); assumed: half of that "
      "growth of the whole valve, leaflets a further 10 % taller, twice as thick, half as "
      "extensible again and 0.6 times as stiff, chordae 11 % longer, those of A2, P1, P2 and "
      "P3 a further 10, 10, 35 and 10 %, a saddle flattened to 60 %");
}

HumanValve fibroelastic_flail() {
  Remodelling change;
  change.growth_percent = 6.5;
  change.ap_dilation_percent = 10.5;
  change.leaflet_growth_percent = 2.0;
  change.ruptured = {Segment::P2};
  change.tissue.thickness_percent = 90.0;
  change.systole = SystolicMotion{.annular_contraction = 0.068};
  return diseased(
      change,
      "fibroelastic deficiency of the healthy preset: annulus of 13.3 / 10.6 times the area "
      "that changes by 6.8 % (Cardiovasc Ultrasound 2016, s12947-016-0073-4), marginal chordae "
      "of P2 ruptured; assumed: half of that growth of the whole valve, leaflets a further 2 % "
      "taller and a tenth thinner");
}

HumanValve marfan() {
  Remodelling change;
  change.growth_percent = 4.0;
  change.ap_dilation_percent = 15.0;
  change.leaflet_growth_percent = 15.0;
  change.chordal_elongation_percent = 15.0;
  change.elongated = {
      {Segment::A2, 25.0}, {Segment::P1, 5.0}, {Segment::P2, 35.0}, {Segment::P3, 5.0}};
  change.tissue = {120.0, 125.0, 80.0, 80.0};
  change.systole = SystolicMotion{.annular_contraction = 0.044};
  return diseased(
      change,
      "Marfan syndrome with prolapse of the healthy preset: large leaflets that billow in an "
      "annulus that expands in systole, posterior chordae that hold them late (Pini 1989, "
      "Circulation 80:915; no sizes there); assumed: the whole valve 4 % larger, annulus 15 % "
      "dilated in its anteroposterior diameter, leaflets 15 % taller, 1.2 times as thick, 0.8 "
      "times as stiff, 1.25 times as extensible, chordae 15 % longer, those of A2, P1, P2 and "
      "P3 a further 25, 5, 35 and 5 %");
}

HumanValve secondary_mr() {
  Remodelling change;
  change.growth_percent = 5.0;
  change.ap_dilation_percent = 19.0;
  // 8.0 against 13.5 % of the width in mid-systole (43 patients, 42 controls).
  change.annular_height_percent = 60.0;
  change.leaflet_growth_percent = 2.5;
  change.anterolateral_mm = Vec3(2.0, 2.5, 1.0);
  change.posteromedial_mm = Vec3(3.0, 4.0, 2.0);
  change.tissue.thickness_percent = 110.0;
  change.tissue.circumferential_stiffness_percent = 60.0;
  change.tissue.radial_stiffness_percent = 200.0;
  return diseased(
      change,
      "secondary regurgitation of the healthy preset: annulus of 802 / 608 times the area "
      "(Aquila 2016, Medicine 95:e5387), saddle of 8.0 / 13.5 of its height (Topilsky 2013, "
      "JAHA 2:e000039), leaflets thicker, softer along and stiffer across the fibres, which "
      "makes the radial direction the stiffer one (Vandemaele 2022, Front Cardiovasc Med "
      "9:876006); assumed: by how much (1.1, 0.6, 2.0 times), the whole valve 5 % larger and "
      "leaflets a further 2.5 % taller, tips displaced by 2, 2.5, 1 and 3, 4, 2 mm "
      "(anterolateral, posteromedial; transverse, posterior, apical)");
}

HumanValve hypertrophic() {
  Remodelling change;
  change.leaflet_growth_percent = 38.5;
  // 13 / 18 of the distance between the tips.
  change.anterolateral_mm = Vec3(-3.0, -4.0, 0.0);
  change.posteromedial_mm = Vec3(-3.0, -4.0, 0.0);
  change.tissue = {100.0, 110.0, 70.0, 70.0};
  return diseased(
      change,
      "hypertrophic cardiomyopathy of the healthy preset: leaflets 38.5 % taller (26 / 19 and "
      "14 / 10 times the length: Maron 2011, Circulation 124:40), papillary tips 13 / 18 as "
      "far apart (Hwang 2011, Eur J Echocardiogr) and further forward (Kim 2010, Circulation "
      "122:1298), tissue softer (Prot 2010, PMID 20129416); assumed: tips 4 mm forward, tissue "
      "1.1 times as extensible and 0.7 times as stiff; systolic anterior motion is not modelled");
}

}  // namespace coapt
