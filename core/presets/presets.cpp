#include "core/presets/presets.h"

#include <algorithm>
#include <utility>

#include "core/closure/closure.h"
#include "core/closure/tauten.h"
#include "core/presets/porcine_thesis.h"
#include "core/valve/remodel.h"
#include "core/valve/validate.h"

namespace coapt {
namespace {

constexpr int kLengthTriangles = 650;  // the mesh that chordae lengths are taken from

// Lengths of chordae over those of the first closing, in which the leaflets hang too low: with it
// the mid-valve section tents by 6 to 8 mm.
constexpr double kSlack = 1.15;

/// A porcine valve of thesis table 2.2: measured diameters, everything else in proportion to them.
/// Leaflet heights are not in the table. `reserve` scales them so that the valve is competent on
/// every mesh and begins to leak at about 10 % of anteroposterior dilation, as the thesis's does
/// (figure 4.5): 1.05 to 1.07 for the larger valves (23.4 and 14.8 mm on 28 mm), more for the small
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
  d.slack = kSlack;
  d.triangles = triangles;
  return d;
}

/// Length of a chorda over its length in the closed, pressurised valve.
double slack_of(const ParametricValve& d, const Valve& valve, const Chorda& chorda) {
  const bool medial = valve.heads[chorda.head].side == Side::Posteromedial;
  const double side = d.slack * (1.0 + (medial ? 1.0 : -1.0) * d.asymmetry.slack);
  if (chorda.kind == ChordaKind::Strut) return side * d.strut_slack;
  if (chorda.kind == ChordaKind::Basal) return side * d.basal_slack;
  const int face = chorda.segments.back().insertion.face;
  const Segment at = valve.segments[face];
  const bool posterior = at == Segment::P1 || at == Segment::P2 || at == Segment::P3;
  return posterior ? side * d.posterior_slack : side;
}

std::string lengths_in_words(const ParametricValve& d) {
  const auto both_sides = [&](double factor) {
    const double al = d.slack * (1.0 - d.asymmetry.slack), pm = d.slack * (1.0 + d.asymmetry.slack);
    return std::to_string(al * factor) + (al == pm ? "" : " / " + std::to_string(pm * factor));
  };
  std::string words = "chordae lengths: distances in the closed, pressurised valve times ";
  if (d.posterior_slack == 1.0 && d.strut_slack == 1.0 && d.basal_slack == 1.0)
    return words + both_sides(1.0);
  return words + "(anterolateral / posteromedial) anterior and commissural " + both_sides(1.0) +
         ", posterior " + both_sides(d.posterior_slack) + ", strut " + both_sides(d.strut_slack) +
         ", basal " + both_sides(d.basal_slack);
}

ParametricValve human() {
  ParametricValve d;
  d.name = "human-normal";
  d.slack = kSlack;
  d.asymmetry.tip_mm = Vec3(0.5, 0.5, 0.0);
  d.asymmetry.leaflet_height = 0.03;
  return d;
}

}  // namespace

Expected<Valve> make_taut_valve(const ParametricValve& dimensions) {
  Expected<Valve> made = make_parametric_valve(dimensions);
  if (!made) return made;
  ParametricValve coarse = dimensions;
  coarse.triangles = kLengthTriangles;
  Expected<Valve> open = make_parametric_valve(coarse);
  if (!open) return open;
  if (Errors errors = validate(*open); !errors.empty()) return errors;
  ClosureOptions to_rest;
  to_rest.residual_tolerance = 1e-4;
  to_rest.way_tolerance_mm = 1e-3;
  const ClosureResult closed = close_valve(*open, to_rest);
  if (closed.status != ClosureStatus::Converged || closed.crossing)
    return Error{ErrorCode::BadGeometry, "",
                 "a valve of these dimensions does not close without leaflets passing through each "
                 "other: chordae lengths cannot be taken from it"};
  const Valve taut = tauten(*open, closed, 1.0);
  for (std::size_t c = 0; c < taut.chordae.size(); ++c)
    for (std::size_t s = 0; s < taut.chordae[c].segments.size(); ++s)
      made->chordae[c].segments[s].rest_length_mm =
          slack_of(dimensions, *open, taut.chordae[c]) * taut.chordae[c].segments[s].rest_length_mm;
  made->provenance.push_back(lengths_in_words(dimensions));
  if (Errors errors = validate(*made); !errors.empty()) return errors;
  return made;
}

const std::vector<std::string>& preset_names() {
  static const std::vector<std::string> names = {"porcine-1",
                                                 "porcine-2",
                                                 "porcine-3",
                                                 "porcine-4",
                                                 "porcine-5",
                                                 "porcine-thesis",
                                                 "porcine-thesis-tables",
                                                 "human-normal",
                                                 "human-functional-mr",
                                                 "human-p2-prolapse"};
  return names;
}

Expected<Valve> make_preset(const std::string& name, int triangles) {
  const auto taut = [triangles](ParametricValve d) {
    if (triangles > 0) d.triangles = triangles;
    return make_taut_valve(d);
  };
  if (name == "porcine-1") return taut(porcine(name, 28.1, 37.7, 621, 1.05));
  if (name == "porcine-2") return taut(porcine(name, 28.4, 36.2, 655, 1.05));
  if (name == "porcine-3") return taut(porcine(name, 25.9, 41.3, 624, 1.07));
  if (name == "porcine-4") return taut(porcine(name, 18.4, 27.1, 611, 1.12));
  if (name == "porcine-5") return taut(porcine(name, 18.3, 21.4, 736, 1.12));
  if (name == "porcine-thesis" || name == "porcine-thesis-tables") {
    Expected<Valve> valve =
        taut(name == "porcine-thesis" ? porcine_thesis() : porcine_thesis_tables());
    if (valve)
      valve->provenance.emplace_back(
          "fitted to orifices published in the thesis, tissue included: no measured anatomy "
          "(docs/porcine-thesis.md)");
    return valve;
  }
  if (name == "human-normal") return taut(human());
  if (name == "human-p2-prolapse") {
    Expected<Valve> valve = taut(human());
    if (!valve) return valve;
    valve->name = name;
    for (Chorda& chorda : valve->chordae)
      if (chorda.kind == ChordaKind::Marginal && chorda.id.find("-P2-") != std::string::npos)
        chorda.ruptured = true;
    // A flail scallop in an annulus of normal size lies against the anterior leaflet and does not
    // leak; degenerative annuli are dilated.
    Remodelling change;
    change.ap_dilation_percent = 12.0;
    Expected<Valve> remodelled = remodel(*valve, change);
    if (remodelled)
      remodelled->provenance.push_back(
          "degenerative prolapse: marginal chordae of P2 ruptured, annulus dilated 12 % in its "
          "anteroposterior diameter");
    return remodelled;
  }
  if (name == "human-functional-mr") {
    // Annulus 36 x 44 mm (PMC7368231): the transverse diameter as it is, the anteroposterior one
    // dilated from 30 mm; leaflets a little larger than normal, as in chronic dilation; tips
    // further away.
    ParametricValve d = human();
    d.name = name;
    d.ap_mm = 30.0;
    d.al_pm_mm = 44.0;
    d.anterior_height_mm = 24.5;
    d.posterior_height_mm = 15.5;
    d.lateral_height_mm = 14.5;
    d.commissure_height_mm = 9.2;
    d.saddle_height_mm = 6.8;
    d.tip_spread_mm = 28.0;
    Expected<Valve> valve = taut(d);
    if (!valve) return valve;
    Remodelling change;
    change.ap_dilation_percent = 20.0;
    change.annular_height_percent = 70.0;
    change.anterolateral_mm = Vec3(1.0, 2.0, 2.0);
    change.posteromedial_mm = Vec3(2.0, 3.0, 4.0);
    Expected<Valve> remodelled = remodel(*valve, change);
    if (remodelled)
      remodelled->provenance.push_back(
          "functional regurgitation: annulus dilated 20 % in its anteroposterior diameter and "
          "flattened to 70 %, anterolateral tip displaced by 1, 2, 2 mm and posteromedial tip by "
          "2, 3, 4 mm (transverse, posterior, apical)");
    return remodelled;
  }
  std::string accepted;
  for (const std::string& preset : preset_names())
    accepted += (accepted.empty() ? "" : ", ") + preset;
  return Error{ErrorCode::Unsupported, "", "unknown preset '" + name + "', accepted: " + accepted};
}

}  // namespace coapt
