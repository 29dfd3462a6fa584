// What a search remembers of one closure.
#pragma once

#include <limits>

#include "search/evaluator.h"

namespace coapt {

/// Of one plan under one disturbance. Numbers may be NaN or infinite where the valve flew apart.
struct PlanClosure {
  ClosureStatus status = ClosureStatus::Converged;
  bool crossing = false;
  double leak_mm2 = 0.0;         ///< as it was measured: within a search an estimate (LeakBy)
  double coaptation_mm = 0.0;    ///< height of A2 with P2: mean of the three middle sections
  double distance_max_mm = 0.0;  ///< see Coaptation
  double tension_max_n = 0.0;
  double leaflet_ratio = std::numeric_limits<double>::
      quiet_NaN();  ///< anterior over posterior, annulus to coaptation; NaN: they do not touch
};

/// Of PlanClosure::leaflet_ratio; below it systolic anterior motion is a risk (Maslow 1999, Popa 2013).
inline constexpr double kLowLeafletRatio = 1.3;

/// Whether a repair makes it one: the ratio is below kLowLeafletRatio and less than `before` the repair, by more than 0.05 (NaN: not known).
bool raises_sam_risk(double ratio, double before);

PlanClosure plan_closure(const Evaluation& evaluation);

/// Converged, uncrossed, its leak a number.
bool trusted(const PlanClosure& closure);

/// That a leak measured on so many triangles is less than kMildLeak_mm2: of a normal distribution about it, as wide as the mesh's error
/// (core/metrics/area_error.h).
double probability_mild(double leak_mm2, int triangles);

}  // namespace coapt
