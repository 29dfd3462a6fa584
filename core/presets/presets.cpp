#include "core/presets/presets.h"

#include <utility>

#include "core/presets/human_presets.h"
#include "core/presets/porcine_thesis.h"

namespace coapt {
namespace {

/// A porcine valve of thesis table 2.2: measured diameters, sizes in proportion to them, slacks, tissue and inclinations of the
/// healthy human valve.
/// Leaflet heights are not in the table. `reserve` scales them so that the valve is competent on
/// every mesh and begins to leak at about 10 % of anteroposterior dilation, as the thesis's does
/// (figure 4.5): 1.06 to 1.08 for the larger valves (23.6 and 14.9 mm on 28 mm), more for the small
/// ones, whose leaflets are as thick.
ParametricValve porcine(std::string name, double ap_mm, double al_pm_mm, int triangles,
                        double reserve) {
  ParametricValve d;
  d.name = std::move(name);
  d.ap_mm = ap_mm;
  d.al_pm_mm = al_pm_mm;
  d.saddle_height_mm = 0.2 * al_pm_mm;  // thesis figure 4.1
  d.anterior_height_mm = 0.793 * reserve * ap_mm;
  d.posterior_height_mm = 0.50 * reserve * ap_mm;
  d.lateral_height_mm = 0.48 * reserve * ap_mm;
  d.commissure_height_mm = 0.29 * reserve * ap_mm;
  d.cleft_depth_mm = 0.02 * ap_mm;
  d.tip_depth_mm = 0.81 * ap_mm;
  d.tip_spread_mm = 0.65 * al_pm_mm;
  d.tip_posterior_mm = 0.14 * ap_mm;
  const ParametricValve human = human_normal().dimensions;
  d.anterior_inclination_deg = human.anterior_inclination_deg;
  d.posterior_inclination_deg = human.posterior_inclination_deg;
  d.posterior_fold_mm = human.posterior_fold_mm * ap_mm / human.ap_mm;
  d.anterior_fold_mm = human.anterior_fold_mm * ap_mm / human.ap_mm;
  d.slack = human.slack;
  d.tissue = human.tissue;
  d.triangles = triangles;
  return d;
}

Expected<Valve> thesis(ParametricValve dimensions, int triangles) {
  if (triangles > 0) dimensions.triangles = triangles;
  Expected<Valve> valve = make_taut_valve(dimensions);
  if (valve)
    valve->provenance.emplace_back(
        "fitted to orifices published in the thesis, tissue included: no measured anatomy "
        "(docs/porcine-thesis.md)");
  return valve;
}

struct Preset {
  std::string name;
  Expected<Valve> (*make)(const std::string& name, int triangles);  ///< triangles 0: its own number
};

template <HumanValve (*Human)()>
Expected<Valve> human(const std::string& name, int triangles) {
  HumanValve valve = Human();
  valve.dimensions.name = name;
  if (triangles > 0) valve.dimensions.triangles = triangles;
  return make_human_valve(valve);
}

/// Of thesis table 2.2.
template <int Heart>
Expected<Valve> porcine_heart(const std::string& name, int triangles) {
  struct Row {
    double ap_mm, al_pm_mm;
    int triangles;
    double reserve;
  };
  constexpr Row kRows[] = {{28.1, 37.7, 621, 1.06},
                           {28.4, 36.2, 655, 1.06},
                           {25.9, 41.3, 624, 1.08},
                           {18.4, 27.1, 611, 1.13},
                           {18.3, 21.4, 736, 1.13}};
  const Row& row = kRows[Heart - 1];
  return make_taut_valve(porcine(name, row.ap_mm, row.al_pm_mm,
                                 triangles > 0 ? triangles : row.triangles, row.reserve));
}

const std::vector<Preset>& presets() {
  static const std::vector<Preset> all = {
      {"porcine-1", porcine_heart<1>},
      {"porcine-2", porcine_heart<2>},
      {"porcine-3", porcine_heart<3>},
      {"porcine-4", porcine_heart<4>},
      {"porcine-5", porcine_heart<5>},
      {"porcine-thesis",
       [](const std::string&, int triangles) { return thesis(porcine_thesis(), triangles); }},
      {"porcine-thesis-tables",
       [](const std::string&, int triangles) {
         return thesis(porcine_thesis_tables(), triangles);
       }},
      {"human-normal", human<human_normal>},
      {"human-functional-mr", human<human_functional_mr>},
      {"human-p2-prolapse", human<human_p2_prolapse>},
      {"barlow", human<barlow>},
      {"fibroelastic-flail", human<fibroelastic_flail>},
      {"marfan", human<marfan>},
      {"secondary-mr", human<secondary_mr>},
      {"hypertrophic", human<hypertrophic>}};
  return all;
}

}  // namespace

const std::vector<std::string>& preset_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const Preset& preset : presets()) all.push_back(preset.name);
    return all;
  }();
  return names;
}

Expected<Valve> make_preset(const std::string& name, int triangles) {
  std::string accepted;
  for (const Preset& preset : presets()) {
    if (preset.name == name) return preset.make(name, triangles);
    accepted += (accepted.empty() ? "" : ", ") + preset.name;
  }
  return Error{ErrorCode::Unsupported, "", "unknown preset '" + name + "', accepted: " + accepted};
}

}  // namespace coapt
