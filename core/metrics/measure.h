// Everything coapt says about a closed valve, in one value.
#pragma once

#include <limits>

#include "core/closure/closure_result.h"
#include "core/metrics/annulus.h"
#include "core/metrics/coaptation.h"
#include "core/metrics/exact_orifice.h"
#include "core/metrics/leaflet_measure.h"
#include "core/valve/valve.h"

namespace coapt {

/// Of one closure (area_error.h).
struct AreaErrors {
  double orifice_mm2 = std::numeric_limits<double>::quiet_NaN();
  double gap_mm2 = std::numeric_limits<double>::quiet_NaN();
  double leak_mm2 = std::numeric_limits<double>::quiet_NaN();
};

struct ValveMeasure {
  OrificeMeasure orifice;
  Coaptation coaptation;
  AreaErrors error;  ///< NaN of a closure that is not converged uncrossed, or not mitral
  AnnulusMeasure annulus;
  double tenting_height_mm = 0.0;  ///< annular line to coaptation point, mid-valve section
  double tenting_area_mm2 = 0.0;   ///< annular line to leaflets there; both < 0 where they billow
  /// Of either leaflet from the annulus to the coaptation point, mid-valve section; NaN unless they touch there.
  double anterior_length_mm = std::numeric_limits<double>::quiet_NaN();
  double posterior_length_mm = std::numeric_limits<double>::quiet_NaN();
  double tension_max_n = 0.0;
  double tension_sum_n = 0.0;  ///< over segments that leave a papillary head
  double strain_circumferential_max = 0.0, strain_radial_max = 0.0;  ///< 99th percentile over faces
  /// Of a valve that is not mitral, in the order of Valve::leaflets; its coaptation, tenting and
  /// places of orifices are unknown.
  std::vector<LeafletMeasure> leaflets;
};

/// Of a closure whose points are not finite only the annulus is known; all else is NaN.
ValveMeasure measure(const Valve& valve, const ClosureResult& closure);

/// The larger of the orifice in the atrial view and the gap in three dimensions, mm2: what a
/// competent valve keeps near zero; the orifice alone where the valve is not mitral. NaN for a
/// closure that flew apart.
double leak_mm2(const ValveMeasure& measure);
double leak_mm2(double orifice_mm2, double gap_mm2);

}  // namespace coapt
