#include "search/model_draw.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <string>

#include "core/valve/validate.h"
#include "search/latin_hypercube.h"

namespace coapt {
namespace {

/// Indices of model_parameters().
enum ModelIndex : std::size_t {
  kBending,
  kZone,
  kThickness,
  kPreModuli,
  kPostModuli,
  kCircumferentialTransition,
  kRadialTransition,
  kChordalModulus,
  kChordalLength
};

/// The transition moved so that what is left of it, counted from the valve's shape in its file,
/// changes by the factor: of an excised valve the transition strain, of one in vivo that beyond its
/// prestretch.
void move_transition(double factor, double stretch, double& transition) {
  const double left = (1.0 + transition) / stretch - 1.0;
  transition += (factor - 1.0) * left * stretch;
}

void change_tissue(const std::array<double, kModelParameters>& factor, Tissue& tissue) {
  const auto [along, across] = prestretch(tissue);
  tissue.bending_n_mm *= factor[kBending];
  tissue.thickness_mm *= factor[kThickness];
  tissue.circumferential_pre_kpa *= factor[kPreModuli];
  tissue.radial_pre_kpa *= factor[kPreModuli];
  tissue.circumferential_post_kpa *= factor[kPostModuli];
  tissue.radial_post_kpa *= factor[kPostModuli];
  move_transition(factor[kCircumferentialTransition], along, tissue.circumferential_transition);
  move_transition(factor[kRadialTransition], across, tissue.radial_transition);
  tissue.chordae_kpa *= factor[kChordalModulus];
}

/// @param own_kpa of the unchanged valve.
void change_chorda(const std::array<double, kModelParameters>& factor, double own_kpa,
                   Chorda& chorda) {
  const bool suture = chorda.kind == ChordaKind::Neochorda;
  for (ChordaSegment& segment : chorda.segments) {
    segment.zone_mm *= factor[kZone];
    if (!suture) segment.rest_length_mm *= factor[kChordalLength];
    if (suture && segment.modulus_kpa == 0.0) segment.modulus_kpa = own_kpa;
    if (!suture) segment.modulus_kpa *= factor[kChordalModulus];
  }
}

/// Whether a fit has found parameters whose names begin so: its own draws move them (fit/fitted_draw.h).
bool is_fitted(const Valve& valve, const char* prefix) {
  return valve.fitted &&
         std::any_of(valve.fitted->parameters.begin(), valve.fitted->parameters.end(),
                     [&](const std::string& name) { return name.starts_with(prefix); });
}

}  // namespace

const std::array<ModelParameter, kModelParameters>& model_parameters() {
  static constexpr std::array<ModelParameter, kModelParameters> kParameters = {
      {// 0.006 N mm, excised mitral tissue below its transition, to 0.066, porcine aortic cusps in
       // flexure (docs/researcher/model.md; Merryman 2006), around 0.03.
       {"bending rigidity", 0.2, 2.2},
       // From one fan of chordae a segment, 1.3 mm as a cone, instead of the 2.0 mm that hold the
       // counted share of the leaflet (docs/researcher/model.md); as much upwards: assumed.
       {"insertion zone", 0.65, 1.35},
       // From 0.65 mm, the human tricuspid leaflets of Texas TriValve (texas-trivalve.md), around
       // the 1 mm of thesis table 2.1; as much upwards: assumed.
       {"leaflet thickness", 0.65, 1.35},
       // To 90 kPa, excised mitral tissue below its transition (that of the lower end of the bending
       // rigidity), around the 11 along the fibres of thesis table 2.1; downwards: assumed.
       {"moduli below the transition", 0.5, 8.0},
       // To three times those of thesis table 2.1, what its own tables ask for
       // (docs/porcine-thesis.md: 2.6 and 3.0); downwards: assumed.
       {"moduli above the transition", 0.5, 3.0},
       // 5 % are left in vivo as ovine leaflets strain at the peak of systole (valve.h); no spread
       // is given: assumed as for the radial one.
       {"circumferential transition", 0.65, 1.35},
       // From 7.8 % left in vivo, the ovine peak strain, around 12 % (valve.h); as much upwards:
       // assumed.
       {"radial transition", 0.65, 1.35},
       // 21 to 183 MPa, human tricuspid chordae (texas-trivalve.md), around 40.
       {"chordal modulus", 0.5, 4.6},
       // The mid-valve section tents by 6 to 8 mm, the range that chordae of the presets were chosen
       // by (presets.cpp): at 1.034 and 0.942 of the length in human-normal, 1.07 and 0.966 in
       // porcine-1.
       {"chordal length", 0.95, 1.05}}};
  return kParameters;
}

const ModelParameter& post_moduli() { return model_parameters()[kPostModuli]; }

double model_factor(const ModelParameter& parameter, double share) {
  const double end = share < 0.5 ? parameter.lower : parameter.upper;
  return std::pow(end, std::abs(2.0 * share - 1.0));
}

Expected<Valve> with_model(const Valve& valve, const std::vector<double>& shares) {
  assert(shares.size() == kModelParameters);
  std::array<double, kModelParameters> factor{};
  for (std::size_t i = 0; i < factor.size(); ++i)
    factor[i] = model_factor(model_parameters()[i], shares[i]);
  if (is_fitted(valve, "slack_")) factor[kChordalLength] = 1.0;
  if (is_fitted(valve, "stiffness")) factor[kPostModuli] = 1.0;
  if (is_fitted(valve, "prestretch_"))
    factor[kCircumferentialTransition] = factor[kRadialTransition] = 1.0;
  Valve drawn = valve;
  change_tissue(factor, drawn.tissue);
  for (Chorda& chorda : drawn.chordae) change_chorda(factor, valve.tissue.chordae_kpa, chorda);
  if (Errors errors = validate(drawn); !errors.empty()) return errors;
  return drawn;
}

std::vector<std::vector<double>> model_draws(int count, std::uint64_t seed) {
  return latin_hypercube(count, kModelParameters, seed);
}

}  // namespace coapt
