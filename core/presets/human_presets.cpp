#include "core/presets/human_presets.h"

#include <cmath>

#include "core/presets/taut_valve.h"
#include "core/valve/remodel.h"

namespace coapt {
namespace {

// Annular areas over those of controls. Degenerative: 15.0 and 13.3 against 10.6 cm2 (Barlow,
// fibroelastic deficiency; Cardiovasc Ultrasound 2016, s12947-016-0073-4). Functional, in systole:
// 802 against 608 mm2 (17 patients, 15 controls; Aquila 2016, Medicine 95:e5387).
constexpr double kBarlowArea = 15.0 / 10.6;
constexpr double kFibroelasticArea = 13.3 / 10.6;
constexpr double kFunctionalArea = 802.0 / 608.0;

// How far systole moves annulus and tips. Change of the annulus's area in controls, fibroelastic deficiency and Barlow's disease:
// 9.7, 6.8 and 4.4 % (the first source above); functional regurgitation: 17.1 / 29.9 of controls' (Aquila 2016). Muscles that
// approach each other less make the valve leak (Kalra 2014, JACC 64:1867); by how much less is assumed.
constexpr SystolicMotion kDegenerativeSystole = {0.07, 0.30}, kBarlowSystole = {0.04, 0.30},
                         kWeakSystole = {0.06, 0.25};

ParametricValve human() {
  ParametricValve d;
  d.slack = kPresetSlacks;
  d.asymmetry.tip_mm = Vec3(0.5, 0.5, 0.0);
  d.asymmetry.leaflet_height = 0.03;
  return d;
}

/// An annulus of `area` times the area: by half as the whole valve grew, by half as it dilated
/// backwards. Heights that are not set grow with it.
Remodelling dilate(double area, ParametricValve& d) {
  const double half = std::sqrt(area);
  d.ap_mm *= std::sqrt(half);
  d.al_pm_mm *= std::sqrt(half);
  Remodelling change;
  change.ap_dilation_percent = 100.0 * (half - 1.0);
  return change;
}

void set_heights(double anterior, double posterior, ParametricValve& d) {
  const Proportions normal;
  d.anterior_height_mm = anterior * normal.anterior_height_mm;
  d.posterior_height_mm = posterior * normal.posterior_height_mm;
  d.lateral_height_mm = posterior * normal.lateral_height_mm;
  d.commissure_height_mm = posterior * normal.commissure_height_mm;
}

/// A tenth longer, posterior marginal ones 15 % more.
ChordalSlack long_chordae() {
  const double slack = 1.1 * kPresetSlack;
  return {slack, 1.15 * slack, 1.15 * slack, slack, slack};
}

}  // namespace

Expected<Valve> make_human_valve(const HumanValve& human) {
  Expected<Valve> valve = make_taut_valve(human.dimensions);
  if (!valve) return valve;
  if (!human.change) return valve;
  Expected<Valve> remodelled = remodel(*valve, *human.change);
  if (remodelled && !human.disease.empty()) remodelled->provenance.push_back(human.disease);
  return remodelled;
}

HumanValve human_normal() { return {human(), {}, ""}; }

HumanValve human_p2_prolapse() {
  // A flail scallop in an annulus of normal size lies against the anterior leaflet and does not
  // leak; degenerative annuli are dilated.
  Remodelling change;
  change.ap_dilation_percent = 12.0;
  change.ruptured = {Segment::P2};
  ParametricValve d = human();
  d.systole = kDegenerativeSystole;
  return {d, change,
          "degenerative prolapse: marginal chordae of P2 ruptured, annulus dilated 12 % in its "
          "anteroposterior diameter"};
}

HumanValve human_functional_mr() {
  // Annulus 36 x 44 mm (PMC7368231): the transverse diameter as it is, the anteroposterior one
  // dilated from 30 mm; leaflets a little larger than normal, as in chronic dilation; tips
  // further away.
  ParametricValve d = human();
  d.ap_mm = 30.0;
  d.al_pm_mm = 44.0;
  d.anterior_height_mm = 24.5;
  d.posterior_height_mm = 15.5;
  d.lateral_height_mm = 14.5;
  d.commissure_height_mm = 9.2;
  d.saddle_height_mm = 6.8;
  d.tip_spread_mm = 28.0;
  d.systole = kWeakSystole;
  Remodelling change;
  change.ap_dilation_percent = 20.0;
  change.annular_height_percent = 70.0;
  change.anterolateral_mm = Vec3(1.0, 2.0, 2.0);
  change.posteromedial_mm = Vec3(2.0, 3.0, 4.0);
  return {d, change,
          "functional regurgitation: annulus dilated 20 % in its anteroposterior diameter and "
          "flattened to 70 %, anterolateral tip displaced by 1, 2, 2 mm and posteromedial tip by "
          "2, 3, 4 mm (transverse, posterior, apical)"};
}

HumanValve barlow() {
  ParametricValve d = human();
  Remodelling change = dilate(kBarlowArea, d);
  change.elongated = {{Segment::P2, 40.0}};
  set_heights(1.2, 1.2, d);
  d.saddle_height_mm = 0.12 * d.al_pm_mm;
  d.slack = long_chordae();
  d.tissue.thickness_mm = 2.0;
  change_tissue({.extension_percent = 200.0,
                 .circumferential_stiffness_percent = 50.0,
                 .radial_stiffness_percent = 50.0},
                d.tissue);
  d.systole = kBarlowSystole;
  return {d, change,
          "Barlow's disease: annulus of 15.0 / 10.6 times the area (Cardiovasc Ultrasound 2016, "
          "s12947-016-0073-4); assumed: leaflets a fifth taller, 2 mm thick, twice as extensible "
          "until their transition and half as stiff beyond it, chordae a tenth longer, posterior "
          "ones 15 % and P2's 40 % more, a flat saddle of 12 % of the width before it dilates"};
}

HumanValve fibroelastic_flail() {
  ParametricValve d = human();
  Remodelling change = dilate(kFibroelasticArea, d);
  change.ruptured = {Segment::P2};
  d.tissue.thickness_mm = 0.7;
  d.systole = kDegenerativeSystole;
  return {d, change,
          "fibroelastic deficiency: annulus of 13.3 / 10.6 times the area (Cardiovasc Ultrasound "
          "2016, s12947-016-0073-4), marginal chordae of P2 ruptured; assumed: leaflets 0.7 mm "
          "thick, as tall as the annulus before it dilated asks for"};
}

HumanValve marfan() {
  ParametricValve d = human();
  d.ap_mm *= 1.05;
  d.al_pm_mm *= 1.05;
  set_heights(1.25, 1.25, d);
  d.slack = long_chordae();
  d.tissue.thickness_mm = 0.8;
  change_tissue({.extension_percent = 150.0,
                 .circumferential_stiffness_percent = 70.0,
                 .radial_stiffness_percent = 70.0},
                d.tissue);
  d.systole = kBarlowSystole;
  Remodelling change;
  change.ap_dilation_percent = 15.0;
  change.elongated = {{Segment::P2, 30.0}};
  return {d, change,
          "Marfan syndrome with prolapse: large leaflets that billow in an annulus that expands in "
          "systole, posterior chordae that hold them late (Pini 1989, Circulation 80:915; no sizes "
          "there); assumed: annulus 5 % wider, 15 % dilated in its anteroposterior diameter under "
          "pressure, leaflets a quarter taller and 0.8 mm thick, 1.5 times as extensible and 0.7 "
          "times as stiff, chordae a tenth longer, posterior ones 15 % and P2's 30 % more"};
}

HumanValve secondary_mr() {
  ParametricValve d = human();
  Remodelling change = dilate(kFunctionalArea, d);
  set_heights(1.1, 1.1, d);
  d.systole = kWeakSystole;
  d.tissue.thickness_mm = 1.1;
  d.tissue.circumferential_post_kpa *= 0.6;
  d.tissue.radial_post_kpa *= 2.0;
  // 8.0 against 13.5 % of the width in mid-systole (43 patients, 42 controls).
  change.annular_height_percent = 100.0 * 8.0 / 13.5;
  change.anterolateral_mm = Vec3(1.0, 2.0, 2.0);
  change.posteromedial_mm = Vec3(2.0, 4.0, 4.0);
  return {d, change,
          "secondary regurgitation: annulus of 802 / 608 times the area (Aquila 2016, Medicine "
          "95:e5387), saddle of 8.0 / 13.5 of its height (Topilsky 2013, JAHA 2:e000039), leaflets "
          "thicker, softer along and stiffer across the fibres, which makes the radial direction "
          "the stiffer one (Vandemaele 2022, Front Cardiovasc Med 9:876006); assumed: by how much "
          "(1.1, 0.6, 2.0 times), leaflets a tenth taller, tips displaced by 1, 2, 2 and 2, 4, 4 "
          "mm (anterolateral, posteromedial; transverse, posterior, apical)"};
}

HumanValve hypertrophic() {
  ParametricValve d = human();
  set_heights(26.0 / 19.0, 14.0 / 10.0, d);
  d.tip_spread_mm *= 13.0 / 18.0;
  d.tip_posterior_mm = 0.0;
  change_tissue({.extension_percent = 130.0,
                 .circumferential_stiffness_percent = 50.0,
                 .radial_stiffness_percent = 50.0},
                d.tissue);
  return {d, Remodelling{},
          "hypertrophic cardiomyopathy: leaflets of 26 / 19 and 14 / 10 times the length (Maron "
          "2011, Circulation 124:40), papillary tips 13 / 18 as far apart (Hwang 2011, Eur J "
          "Echocardiogr) and further forward (Kim 2010, Circulation 122:1298), tissue softer (Prot "
          "2010, PMID 20129416); assumed: tips 4 mm forward, tissue 1.3 times as extensible and "
          "half as stiff; systolic anterior motion is not modelled"};
}

}  // namespace coapt
