// Everything coapt says about a closed valve, in one value.
#pragma once

#include <limits>

#include "core/closure/closure_result.h"
#include "core/metrics/annulus.h"
#include "core/metrics/coaptation.h"
#include "core/metrics/leaflet_measure.h"
#include "core/metrics/leak.h"
#include "core/valve/valve.h"

namespace coapt {

/// How the leak is measured.
enum class LeakBy {
  Surface,   ///< leak.h
  Estimate,  ///< leak_estimate.h, for closures of which none is printed: no bounds, no openings
};

struct ValveMeasure {
  Leak leak;
  /// Of its area (area_error.h); NaN of a closure that is not converged uncrossed, or not mitral.
  double leak_error_mm2 = std::numeric_limits<double>::quiet_NaN();
  Coaptation coaptation;
  AnnulusMeasure annulus;
  double tenting_height_mm = 0.0;  ///< annular line to coaptation point, mid-valve section
  double tenting_area_mm2 = 0.0;   ///< annular line to leaflets there; both < 0 where they billow
  /// Of either leaflet from the annulus to the coaptation point, mid-valve section; NaN unless they touch there.
  double anterior_length_mm = std::numeric_limits<double>::quiet_NaN();
  double posterior_length_mm = std::numeric_limits<double>::quiet_NaN();
  double tension_max_n = 0.0;
  double tension_sum_n = 0.0;  ///< over segments that leave a papillary head
  double strain_circumferential_max = 0.0, strain_radial_max = 0.0;  ///< 99th percentile over faces
  /// Of a valve that is not mitral, in the order of Valve::leaflets; its coaptation and
  /// tenting are unknown.
  std::vector<LeafletMeasure> leaflets;
};

/// Of a closure whose points are not finite only the annulus is known; all else is NaN.
ValveMeasure measure(const Valve& valve, const ClosureResult& closure,
                     LeakBy leak_by = LeakBy::Surface);

/// Height of coaptation of A2 with P2: mean of the three middle sections; NaN of a valve that is not mitral.
double coaptation_a2_p2_mm(const ValveMeasure& measure);

/// Anterior over posterior leaflet length, annulus to coaptation; NaN: they do not touch in the middle.
double leaflet_ratio(const ValveMeasure& measure);

}  // namespace coapt
