// Figures of a closure beside its leak, by the names that documents have for them, each with what is known of its error.
#pragma once

#include <array>

#include "core/metrics/estimate.h"
#include "core/metrics/figure_error.h"
#include "core/metrics/measure.h"

namespace coapt {

struct ClosedFigure {
  Figure figure;
  const char* name;
  double (*of)(const ValveMeasure&);  ///< NaN: not known
};

inline constexpr std::size_t kClosedFigures = 5;

/// Coaptation of A2 with P2, the highest tension, the leaflet ratio, strains.
const std::array<ClosedFigure, kClosedFigures>& closed_figures();

/// In the order of closed_figures().
using ClosedFigures = std::array<double, kClosedFigures>;
ClosedFigures closed_figures_of(const ValveMeasure& measure);

/// With their numerical errors. @param triangles of the leaflets; 0: of a closure whose errors are not known (not trusted, not mitral)
std::array<Estimate, kClosedFigures> closed_estimates(const ValveMeasure& measure, int triangles);

}  // namespace coapt
