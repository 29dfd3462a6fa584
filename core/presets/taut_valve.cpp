#include "core/presets/taut_valve.h"

#include <optional>
#include <string>

#include "core/closure/closure.h"
#include "core/closure/tauten.h"
#include "core/valve/leaflet_of.h"
#include "core/valve/number_text.h"
#include "core/valve/ruptures.h"
#include "core/valve/validate.h"

namespace coapt {
namespace {

constexpr int kLengthTriangles = 650;  // the mesh that chordae lengths are taken from

std::string lengths_in_words(const ParametricValve& d) {
  const auto both_sides = [&](double slack) {
    const double al = slack * (1.0 - d.asymmetry.slack), pm = slack * (1.0 + d.asymmetry.slack);
    return std::to_string(al) + (al == pm ? "" : " / " + std::to_string(pm));
  };
  std::string words = "chordae lengths: distances in the closed, pressurised valve times ";
  const ChordalSlack& slack = d.slack;
  if (slack.posterior == slack.anterior && slack.commissural == slack.anterior &&
      slack.strut == slack.anterior && slack.basal == slack.anterior)
    return words + both_sides(slack.anterior);
  return words + "(anterolateral / posteromedial) anterior " + both_sides(slack.anterior) +
         ", posterior " + both_sides(slack.posterior) + ", commissural " +
         both_sides(slack.commissural) + ", strut " + both_sides(slack.strut) + ", basal " +
         both_sides(slack.basal);
}

double side_of(const ParametricValve& d, const Valve& valve, const Chorda& chorda) {
  const bool medial = valve.heads[chorda.head].side == Side::Posteromedial;
  return 1.0 + (medial ? 1.0 : -1.0) * d.asymmetry.slack;
}

}  // namespace

double slack_of(const ChordalSlack& slack, const Valve& valve, const Chorda& chorda) {
  if (chorda.kind == ChordaKind::Strut) return slack.strut;
  if (chorda.kind == ChordaKind::Basal) return slack.basal;
  const std::optional<Segment> held = held_by(valve, chorda);
  if (!held) return slack.commissural;
  return leaflet_of(*held) == Leaflet::Anterior ? slack.anterior : slack.posterior;
}

Expected<Valve> taut_when_closed(const Valve& valve, const ClosureBudget& budget) {
  ClosureOptions to_rest;
  to_rest.budget = budget;
  to_rest.residual_tolerance = 1e-4;
  to_rest.way_tolerance_mm = 1e-3;
  const ClosureResult closed = close_valve(valve, to_rest);
  if (closed.unfinished)
    return Error{ErrorCode::OutOfRange, "",
                 "the closure that determines chordal lengths takes more than " +
                     shown(budget.vertex_steps) + " steps times vertices; use a coarser mesh"};
  if (!trusted(closed))
    return Error{ErrorCode::BadGeometry, "",
                 "its leaflets cross when it closes, so chordal lengths cannot be determined from "
                 "its closed state"};
  return tauten(valve, closed, 1.0);
}

Expected<Valve> make_taut_valve(const ParametricValve& dimensions, const ClosureBudget& budget) {
  Expected<Valve> made = make_parametric_valve(dimensions);
  if (!made) return made;
  ParametricValve coarse = dimensions;
  coarse.triangles = kLengthTriangles;
  Expected<Valve> open = make_parametric_valve(coarse);
  if (!open) return open;
  if (Errors errors = validate(*open); !errors.empty()) return errors;
  const Expected<Valve> taut = taut_when_closed(*open, budget);
  if (!taut) return taut;
  for (std::size_t c = 0; c < taut->chordae.size(); ++c) {
    const Chorda& chorda = taut->chordae[c];
    const double slack =
        slack_of(dimensions.slack, *open, chorda) * side_of(dimensions, *open, chorda);
    for (std::size_t s = 0; s < chorda.segments.size(); ++s)
      made->chordae[c].segments[s].rest_length_mm = slack * chorda.segments[s].rest_length_mm;
  }
  made->provenance.push_back(lengths_in_words(dimensions));
  if (Errors errors = validate(*made); !errors.empty()) return errors;
  return made;
}

}  // namespace coapt
