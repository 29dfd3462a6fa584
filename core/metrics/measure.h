// Everything coapt says about a closed valve, in one value.
#pragma once

#include <array>
#include <vector>

#include "core/closure/closure.h"
#include "core/valve/valve.h"

namespace coapt {

/// One connected opening of the atrial view.
struct Orifice {
  double area_mm2 = 0.0;
  Vec3 centroid_mm = Vec3::Zero();  ///< on the annular plane
  Segment segment = Segment::A2;    ///< of the leaflet nearest to the centroid in that view
};

/// Regurgitant orifice after thesis 4.2.1.
struct OrificeMeasure {
  double area_mm2 = 0.0;          ///< leaflets with their half thickness
  double area_raw_mm2 = 0.0;      ///< leaflets as bare mid-surfaces
  double area_mean_mm2 = 0.0;     ///< mean of area_mm2 over the closely spaced end states
  std::vector<Orifice> orifices;  ///< with half thickness, largest first
};

/// One of nine sections across the line of coaptation.
struct CoaptationSection {
  double along = 0.0;        ///< 0 anterolateral commissure, 1 posteromedial
  double height_mm = 0.0;    ///< length of contact of the anterior with the posterior side
  double distance_mm = 0.0;  ///< smallest of the mid-surfaces; infinite without anterior tissue
  bool contact = false;
};

struct Coaptation {
  std::array<CoaptationSection, 9> sections;
  double height_min_mm = 0.0, height_mean_mm = 0.0, height_p10_mm = 0.0;
  double distance_max_mm = 0.0;  ///< the widest of the sections' smallest distances: hidden gaps
  /// Opening between the sides in three dimensions: (smallest distance - leaflet thickness), where
  /// positive and out of contact, integrated from commissure to commissure. A prolapsing leaflet
  /// that overlaps the other in the atrial view leaks here and not in the orifice.
  double gap_area_mm2 = 0.0;
};

struct AnnulusMeasure {
  double ap_mm = 0.0;     ///< saddle peak to mid-posterior, projected on the annulus's PCA plane
  double al_pm_mm = 0.0;  ///< widest extent along the direction from commissure to commissure
  double circumference_mm = 0.0;
  double area_mm2 = 0.0;          ///< projected on that plane
  double saddle_height_mm = 0.0;  ///< extent along that plane's normal
};

struct ValveMeasure {
  OrificeMeasure orifice;
  Coaptation coaptation;
  AnnulusMeasure annulus;
  double tenting_height_mm = 0.0;  ///< annular line to coaptation point, mid-valve section
  double tenting_area_mm2 = 0.0;   ///< annular line to leaflets there; both < 0 where they billow
  double tension_max_n = 0.0;
  double tension_sum_n = 0.0;  ///< over segments that leave a papillary head
  double strain_circumferential_max = 0.0, strain_radial_max = 0.0;  ///< 99th percentile over faces
};

/// Of a closure whose points are not finite only the annulus is known; all else is NaN.
ValveMeasure measure(const Valve& valve, const ClosureResult& closure);

/// The larger of the orifice in the atrial view and the gap in three dimensions, mm2: what a
/// competent valve keeps near zero. NaN for a closure that flew apart.
double leak_mm2(const ValveMeasure& measure);

}  // namespace coapt
