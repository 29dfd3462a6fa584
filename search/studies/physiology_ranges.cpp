#include "search/studies/physiology_ranges.h"

#include <algorithm>

namespace coapt {
namespace {

constexpr const char* kAnnularDepth =
    "Gogoladze 2010, Ann Thorac Surg 89:1158: 5.0 ± 0.7 in 10 normal, 8.6 ± 0.7 mm in 10 "
    "functional valves (3D TEE; reference line not stated; two sd)";
constexpr const char* kCoaptation =
    "Gogoladze 2010, Ann Thorac Surg 89:1158: anterior leaflet, mean of three places 3.1 ± 0.4 in "
    "10 normal and 1.7 ± 0.4 mm in 10 functional valves; at A2 3.2 ± 0.7 in the normal ones, not "
    "published of the functional ones (3D TEE; two sd)";
constexpr const char* kMuscles =
    "Askov 2013, 8 pigs: 5.9 and 5.8 N at 90 mmHg, 1.7 times the closing force; lower end assumed";
constexpr const char* kStrain =
    "ovine anterior leaflet at the peak, 57 sheep (PMC3111015): radial 7.8 ± 4.3, circumferential "
    "5.0 ± 2.7, areal 13.8 ± 6.3 % (one sd)";
constexpr const char* kRings =
    "pigs with functional regurgitation, seven sizes (Gaidulis and Padala 2023, PMC10826925): "
    "above "
    "32 mm not effective, 32 and below close; numbers assumed";
constexpr const char* kHerrmann =
    "96 patients, Herrmann 2009, EuroIntervention 4:437: 6.0 ± 1.3 to 3.6 ± 1.2 cm2, 1.7 to 4.1 ± "
    "2.2 mmHg; one and two clips alike";

}  // namespace

const char* to_string(ValveKind kind) {
  switch (kind) {
    case ValveKind::Healthy:
      return "healthy";
    case ValveKind::Functional:
      return "functional";
    case ValveKind::Prolapse:
      return "prolapse";
  }
  return "";
}

const char* to_string(Species species) {
  switch (species) {
    case Species::Human:
      return "human";
    case Species::Porcine:
      return "porcine";
  }
  return "";
}

const std::vector<PhysiologyRange>& physiology_ranges() {
  using enum ValveKind;
  using enum Species;
  const std::vector<ValveKind> healthy = {Healthy}, functional = {Functional},
                               prolapse = {Prolapse}, regurgitant = {Functional, Prolapse},
                               any = {Healthy, Functional, Prolapse};
  const std::vector<Species> human = {Human}, both = {Human, Porcine};
  constexpr const char* kCompetent = "competent: less than a trivial leak (assumed)";
  constexpr const char* kPressures =
      "functional: decreases with increasing closing force (He 1997, Circulation 96:1826); by how "
      "much is "
      "assumed";
  static const std::vector<PhysiologyRange> ranges = {
      {"leak", healthy, both, 0.0, 1.0, kCompetent},
      {"leak", functional, human, 20.0, 60.0,
       "effective orifice of 20 mm2 and more is moderate to severe (Zoghbi 2017, J Am Soc "
       "Echocardiogr 30:303); upper end assumed"},
      {"leak", prolapse, human, 20.0, 100.0,
       "effective orifice of 40 mm2 and more is severe, 20 to 39 moderate (Zoghbi 2017, J Am Soc "
       "Echocardiogr 30:303); upper end assumed"},
      {"coaptation_length", healthy, human, 1.8, 4.6, kCoaptation},
      {"coaptation_height", healthy, human, 2.3, 3.9, kCoaptation},
      {"coaptation_height", functional, human, 0.9, 2.5, kCoaptation},
      {"depth_plane", healthy, human, 3.6, 6.4, kAnnularDepth},
      {"depth_plane", functional, human, 7.2, 10.0, kAnnularDepth},
      {"tenting_area", healthy, human, 60.0, 200.0,
       "95 ± 20 without regurgitation (Magne), 164 ± 47 and 202 ± 68 mm2 in 480 healthy women and "
       "men (Dwivedi; both in a table of Open Heart); sources differ, so their whole range is "
       "accepted"},
      {"tenting_area", functional, human, 190.0, 380.0,
       "280 ± 80 in 240 (von Stumm), 300 ± 30 mm2 in 48 severe functional valves (Nappi; table of "
       "Open Heart; one sd)"},
      {"strut_over_marginal", any, both, 1.0, 10.0,
       "when struts are cut, anterior marginal chordae take over three quarters of their new "
       "tension "
       "from them (He and Jowers 2008, J Heart Valve Dis 17:628): struts carried more; ends "
       "assumed"},
      {"struts_cut_ratio",
       {Healthy, Functional},
       both,
       2.0,
       4.4,
       "both struts cut, anterior marginal tension 0.09 to 0.40 and 0.11 to 0.48 N in 12 porcine "
       "valves at 120 mmHg (He and Jowers 2008, J Heart Valve Dis 17:628); lower end assumed"},
      {"muscle_anterolateral", healthy, both, 2.0, 6.0, kMuscles},
      {"muscle_posteromedial", healthy, both, 2.0, 6.0, kMuscles},
      {"muscle_share", healthy, both, 0.8, 1.7, kMuscles},
      {"annular_force", healthy, both, 3.2, 7.2,
       "six sheep at 125 mmHg, muscle of the annulus included, which is not modelled: 5.2 ± 1.0 N "
       "(Siefert 2012, Ann Thorac Surg 94:59; two sd)"},
      {"a2_radial", healthy, both, 3.5, 12.1, kStrain},
      {"a2_circumferential", healthy, both, 2.3, 7.7, kStrain},
      {"a2_areal", healthy, both, 7.5, 20.1, kStrain},
      {"papillary_diastole", functional, human, 17.0, 30.0,
       "22 to 25 mm in the mean in patients before a clip (TTE, PMID 30790417); 5 mm to either "
       "side "
       "assumed"},
      {"leak_60", healthy, both, 0.0, 1.0, kCompetent},
      {"leak_90", healthy, both, 0.0, 1.0, kCompetent},
      {"leak_200", healthy, both, 0.0, 1.0, kCompetent},
      {"leak_200_over_60", functional, both, 0.3, 0.9, kPressures},
      {"leak_200_over_60", prolapse, both, 0.8, 2.0,
       "prolapse: constant or increasing with pressure (Schwammenthal 1994, Circulation 90:307); "
       "by how "
       "much is assumed"},
      {"ring_40", functional, human, 20.0, 100.0, kRings},
      {"ring_36", functional, human, 5.0, 60.0, kRings},
      {"ring_34", functional, human, 2.0, 10.0, kRings},
      {"ring_32", functional, human, 0.0, 5.0, kRings},
      {"ring_30", functional, human, 0.0, 2.0, kRings},
      {"opening", healthy, human, 400.0, 600.0,
       "normal 4 to 6 cm2 (Baumgartner 2009, J Am Soc Echocardiogr 22:1)"},
      {"opening", regurgitant, human, 470.0, 730.0, kHerrmann},
      {"gradient", regurgitant, human, 0.5, 3.0,
       "1.7 mmHg before a clip (Herrmann 2009, EuroIntervention 4:437); spread assumed"},
      {"ring_opening_share", any, both, 0.0, 1.02,
       "a ring cannot widen the opening (geometry); each area has an error of 2 %"},
      {"gradient_slope", any, human, 0.09, 0.36,
       "0.18 mmHg a mm in true-sized rings (Tomsic 2019); half to twice accepted"},
      {"clip_share", regurgitant, human, 0.4, 0.8, kHerrmann},
      {"two_clips_share", regurgitant, human, 0.75, 1.25, kHerrmann},
      {"clip_gradient", regurgitant, human, 1.9, 6.3, kHerrmann}};
  return ranges;
}

const PhysiologyRange* find_range(const std::string& quantity, ValveKind kind, Species species) {
  for (const PhysiologyRange& range : physiology_ranges())
    if (range.quantity == quantity &&
        std::find(range.kinds.begin(), range.kinds.end(), kind) != range.kinds.end() &&
        std::find(range.species.begin(), range.species.end(), species) != range.species.end())
      return &range;
  return nullptr;
}

}  // namespace coapt
