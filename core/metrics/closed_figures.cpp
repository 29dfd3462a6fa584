#include "core/metrics/closed_figures.h"

namespace coapt {

const std::array<ClosedFigure, kClosedFigures>& closed_figures() {
  static constexpr std::array<ClosedFigure, kClosedFigures> kFigures = {
      {{Figure::Coaptation, "coaptation_a2_p2_mm", coaptation_a2_p2_mm},
       {Figure::Tension, "tension_max_n", [](const ValveMeasure& m) { return m.tension_max_n; }},
       {Figure::LeafletRatio, "leaflet_ratio", leaflet_ratio},
       {Figure::CircumferentialStrain, "strain_circumferential_max",
        [](const ValveMeasure& m) { return m.strain_circumferential_max; }},
       {Figure::RadialStrain, "strain_radial_max",
        [](const ValveMeasure& m) { return m.strain_radial_max; }}}};
  return kFigures;
}

ClosedFigures closed_figures_of(const ValveMeasure& measure) {
  ClosedFigures figures{};
  for (std::size_t i = 0; i < kClosedFigures; ++i) figures[i] = closed_figures()[i].of(measure);
  return figures;
}

std::array<Estimate, kClosedFigures> closed_estimates(const ValveMeasure& measure, int triangles) {
  std::array<Estimate, kClosedFigures> estimates;
  for (std::size_t i = 0; i < kClosedFigures; ++i) {
    const ClosedFigure& figure = closed_figures()[i];
    const double value = figure.of(measure);
    estimates[i] = {value};
    if (triangles > 0) estimates[i].numerical = figure_interval(figure.figure, value, triangles);
  }
  return estimates;
}

}  // namespace coapt
