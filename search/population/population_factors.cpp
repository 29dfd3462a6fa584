#include "search/population/population_factors.h"

#include <cmath>

namespace coapt {
namespace {

enum Anatomic {
  Ap,
  AlPm,
  SaddleHeight,
  AnteriorHeight,
  PosteriorHeight,
  LateralHeight,
  CommissureHeight,
  AnteriorArc,
  TrigoneShare,
  TipDepth,
  TipSpread,
  TipPosterior,
  Slack,
  PosteriorSlack,
  TipAsymmetryTransverse,
  TipAsymmetryPosterior,
  TipAsymmetryApical,
  HeightAsymmetry,
  Thickness,
  Stiffness
};

enum Lesional {
  ApGrowth,
  TransverseGrowth,
  LeafletGrowth,
  ChordaeGrowth,
  PosteriorChordaeGrowth,
  P2Slack,
  Ruptured,
  ThicknessGrowth,
  ApDilation,
  AnnularHeight,
  AnterolateralTip,      // three
  PosteromedialTip = 13  // three
};

/// The healthy valve's slacks, each times so much, posterior ones times `posterior` more.
ChordalSlack times(ChordalSlack slack, double all, double posterior) {
  for (double* group :
       {&slack.anterior, &slack.posterior, &slack.commissural, &slack.strut, &slack.basal})
    *group *= all;
  slack.posterior *= posterior;
  return slack;
}

}  // namespace

const std::array<PopulationFactor, kAnatomyFactors>& anatomy_factors() {
  static const std::array<PopulationFactor, kAnatomyFactors> kFactors = [] {
    const ParametricValve d = human_normal().dimensions;
    return std::array<PopulationFactor, kAnatomyFactors>{
        {{"ap_mm", "annulus, anteroposterior", d.ap_mm, 8.0, 80.0},
         {"al_pm_mm", "annulus, transverse", d.al_pm_mm, 8.0, 100.0},
         {"saddle_height_mm", "annulus, height of the saddle", *d.saddle_height_mm, 0.0, 20.0},
         {"anterior_height_mm", "leaflet height, A2", *d.anterior_height_mm, 4.0, 60.0},
         {"posterior_height_mm", "leaflet height, P2", *d.posterior_height_mm, 3.0, 60.0},
         {"lateral_height_mm", "leaflet height, P1 and P3", *d.lateral_height_mm, 3.0, 60.0},
         {"commissure_height_mm", "leaflet height, commissures", *d.commissure_height_mm, 2.0,
          30.0},
         {"anterior_arc", "anterior share of the annulus", d.anterior_arc, 0.25, 0.5},
         {"trigone_share", "trigones, share from peak to commissure", d.trigone_share, 0.3, 1.0},
         {"tip_depth_mm", "papillary tips below the annulus", d.tip_depth_mm, 8.0, 60.0},
         {"tip_spread_mm", "distance of the papillary tips", d.tip_spread_mm, 4.0, 60.0},
         {"tip_posterior_mm", "papillary tips behind the centre", d.tip_posterior_mm, -20.0, 20.0},
         {"slack", "slack of the chordae over the healthy valve's, factor", 1.0, 0.7, 1.3},
         {"posterior_slack", "slack of posterior chordae, factor", 1.0, 0.8, 1.5},
         {"tip_asymmetry_transverse_mm", "asymmetry of tips, transverse", d.asymmetry.tip_mm.x(),
          -10.0, 10.0},
         {"tip_asymmetry_posterior_mm", "asymmetry of tips, posterior", d.asymmetry.tip_mm.y(),
          -10.0, 10.0},
         {"tip_asymmetry_apical_mm", "asymmetry of tips, apical", d.asymmetry.tip_mm.z(), -10.0,
          10.0},
         {"height_asymmetry", "asymmetry of the leaflet height", d.asymmetry.leaflet_height, -0.4,
          0.4},
         {"thickness_mm", "leaflet thickness", d.tissue.thickness_mm, 0.3, 4.0},
         {"stiffness", "stiffness of the leaflets, factor", 1.0, 0.1, 10.0}}};
  }();
  return kFactors;
}

const std::array<PopulationFactor, kLesionFactors>& lesion_factors() {
  static constexpr std::array<PopulationFactor, kLesionFactors> kFactors = {
      {{"ap_growth", "anteroposterior growth of the whole valve, factor", 1.0, 0.5, 2.0},
       {"transverse_growth", "transverse growth of the whole valve, factor", 1.0, 0.5, 2.0},
       {"leaflet_growth", "growth of the leaflets' height, factor", 1.0, 0.5, 2.0},
       {"chordae_growth", "growth of all chordae, factor", 1.0, 0.8, 1.3},
       {"posterior_chordae_growth", "further growth of posterior marginal chordae, factor", 1.0,
        0.8, 1.3},
       {"p2_slack", "further growth of P2's marginal chordae, factor", 1.0, 0.5, 3.0},
       {"ruptured_chordae", "ruptured marginal chordae of P2, of two", 0.0, 0.0, 2.0},
       {"thickness_growth", "leaflet thickness, factor", 1.0, 0.3, 4.0},
       {"ap_dilation_percent", "anteroposterior dilation, %", 0.0, -50.0, 100.0},
       {"annular_height_percent", "height of the saddle left, %", 100.0, 0.0, 200.0},
       {"anterolateral_transverse_mm", "anterolateral tip outwards, mm", 0.0, -30.0, 30.0},
       {"anterolateral_posterior_mm", "anterolateral tip backwards, mm", 0.0, -30.0, 30.0},
       {"anterolateral_apical_mm", "anterolateral tip apically, mm", 0.0, -30.0, 30.0},
       {"posteromedial_transverse_mm", "posteromedial tip outwards, mm", 0.0, -30.0, 30.0},
       {"posteromedial_posterior_mm", "posteromedial tip backwards, mm", 0.0, -30.0, 30.0},
       {"posteromedial_apical_mm", "posteromedial tip apically, mm", 0.0, -30.0, 30.0}}};
  return kFactors;
}

AnatomyValues usual_anatomy() {
  AnatomyValues values{};
  for (std::size_t f = 0; f < values.size(); ++f) values[f] = anatomy_factors()[f].usual;
  return values;
}

LesionValues no_lesions() {
  LesionValues values{};
  for (std::size_t f = 0; f < values.size(); ++f) values[f] = lesion_factors()[f].usual;
  return values;
}

HumanValve healthy_valve(const AnatomyValues& anatomy) {
  HumanValve human = human_normal();
  ParametricValve& d = human.dimensions;
  d.ap_mm = anatomy[Ap];
  d.al_pm_mm = anatomy[AlPm];
  d.saddle_height_mm = anatomy[SaddleHeight];
  d.anterior_height_mm = anatomy[AnteriorHeight];
  d.posterior_height_mm = anatomy[PosteriorHeight];
  d.lateral_height_mm = anatomy[LateralHeight];
  d.commissure_height_mm = anatomy[CommissureHeight];
  d.anterior_arc = anatomy[AnteriorArc];
  d.trigone_share = anatomy[TrigoneShare];
  d.tip_depth_mm = anatomy[TipDepth];
  d.tip_spread_mm = anatomy[TipSpread];
  d.tip_posterior_mm = anatomy[TipPosterior];
  d.slack = times(d.slack, anatomy[Slack], anatomy[PosteriorSlack]);
  d.asymmetry.tip_mm = Vec3(anatomy[TipAsymmetryTransverse], anatomy[TipAsymmetryPosterior],
                            anatomy[TipAsymmetryApical]);
  d.asymmetry.leaflet_height = anatomy[HeightAsymmetry];
  d.tissue.thickness_mm = anatomy[Thickness];
  d.tissue.circumferential_post_kpa *= anatomy[Stiffness];
  d.tissue.radial_post_kpa *= anatomy[Stiffness];
  return human;
}

HumanValve diseased_valve(Aetiology aetiology, const AnatomyValues& anatomy,
                          const LesionValues& lesions) {
  HumanValve human = healthy_valve(anatomy);
  ParametricValve& d = human.dimensions;
  d.ap_mm *= lesions[ApGrowth];
  d.al_pm_mm *= lesions[TransverseGrowth];
  for (std::optional<double>* height : {&d.anterior_height_mm, &d.posterior_height_mm,
                                        &d.lateral_height_mm, &d.commissure_height_mm})
    **height *= lesions[LeafletGrowth];
  d.slack = times(d.slack, lesions[ChordaeGrowth], lesions[PosteriorChordaeGrowth]);
  Remodelling& change = human.change.emplace();
  if (aetiology == Aetiology::Barlow) {
    // How myxomatous tissue differs is one of the preset's assumptions.
    change.tissue = barlow().change->tissue;
    change.systole = barlow().change->systole;
  }
  change.tissue.thickness_percent = 100.0 * lesions[ThicknessGrowth];
  change.elongated = {{Segment::P2, 100.0 * (lesions[P2Slack] - 1.0)}};
  change.ap_dilation_percent = lesions[ApDilation];
  change.annular_height_percent = lesions[AnnularHeight];
  for (int axis = 0; axis < 3; ++axis) {
    change.anterolateral_mm(axis) = lesions[static_cast<std::size_t>(AnterolateralTip + axis)];
    change.posteromedial_mm(axis) = lesions[static_cast<std::size_t>(PosteromedialTip + axis)];
  }
  human.disease = std::string(to_string(aetiology)) +
                  " disease, drawn from a population; population.json lists its lesions";
  return human;
}

int ruptured_chordae(const LesionValues& lesions) {
  return static_cast<int>(std::lround(lesions[Ruptured]));
}

}  // namespace coapt
