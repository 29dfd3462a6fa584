// What images do not show of a valve, as numbers that a fit may change: how slack the chordae are, where the papillary
// tips are, how far the tissue is stretched in the unpressurised heart, how stiff it is beyond its transition, how much of the
// leaflets hides in coaptation.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "core/valve/valve.h"

namespace coapt {

/// Chordae whose lengths change by one factor.
struct ChordalGroup {
  std::vector<int> chordae;  ///< into Valve::chordae
};

/// All heads of one muscle, along one axis of the valve's frame; lengths of chordae stay.
struct TipPlace {
  std::vector<int> heads;  ///< into Valve::heads
  int axis = 0;
};

/// Tissue::circumferential_prestretch or radial_prestretch.
struct Prestretch {
  bool radial = false;
};

/// Tissue::circumferential_post_kpa and radial_post_kpa, by one factor.
struct Stiffness {};

/// Leaflet below half its height, which coaptation hides: longer by so much at the free edge, less above.
struct HiddenHeight {
  Points per_mm;  ///< |V| x 3, by which each vertex of Valve::rest_mm moves
};

struct FitParameter {
  std::string name;  ///< "slack_anterior_AL", "tip_AL_x", ...
  std::string unit;  ///< "mm" or "1"
  double prior = 0.0, prior_sd = 0.0;
  double lower = 0.0, upper = 0.0;  ///< that the fit keeps
  std::variant<ChordalGroup, TipPlace, Prestretch, Stiffness, HiddenHeight> changes;
};

/// Which of them are unknown.
struct FitUnknowns {
  bool slack = true;
  bool tips = true;
  bool prestretch = true;  ///< of tissue whose reference is InVivo; an excised one has none
  bool stiffness = true;   ///< of the leaflets, beyond their transition
  bool hidden = true;      ///< of mitral leaflets
  double slack_sd = 0.06;  ///< of the factor; assumed
  double tip_sd_mm = 1.0;  ///< of each coordinate: a tip that was seen in an echo; assumed
  /// What peak strains of ovine anterior leaflets differ by: 5.0 +- 2.7 % and 7.8 +- 4.3 % (57 sheep, PMC3111015).
  double circumferential_prestretch_sd = 0.027, radial_prestretch_sd = 0.043;
  /// Of the factor, within the bounds that draws of the model have, too (search/model_draw.h): 0.5 to 3.
  double stiffness_sd = 0.6;
  double hidden_sd_mm = 1.5;  ///< assumed
};

/// In the order slack, tips, prestretch, stiffness, hidden. Muscles of a valve that is not mitral are heads less than 5 mm from one
/// another, named by their first: slack_septal_8598, tip_8598_x. Bounds: three standard deviations (of the stiffness: those of draws of the model), and where validate() would refuse.
std::vector<FitParameter> fit_parameters(const Valve& valve, const FitUnknowns& unknowns);

/// The valve with its parameters at these values. Errors: what validate() refuses.
/// @pre values.size() == parameters.size(), which are the valve's.
Expected<Valve> with_parameters(const Valve& valve, const std::vector<FitParameter>& parameters,
                                const std::vector<double>& values);

}  // namespace coapt
