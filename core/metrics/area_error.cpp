#include "core/metrics/area_error.h"

#include <cmath>

#include "core/closure/accuracy.h"

namespace coapt {
namespace {

constexpr double kClosed_mm2 = 0.7, kRim_mm = 0.65, kTriangles = 650.0, kPower = 0.6;

double mesh_error_mm2(double area_mm2, int triangles) {
  return (kClosed_mm2 + kRim_mm * std::sqrt(area_mm2)) * std::pow(kTriangles / triangles, kPower);
}

/// Of the tightest tier that is not tighter than these tolerances; of the loosest beyond all.
double stopping_error_mm2(const AreaPrecision& precision) {
  const AccuracyTier* kept = &accuracy_tiers().front();
  for (const AccuracyTier& tier : accuracy_tiers())
    if (tier.residual_tolerance >= precision.residual_tolerance &&
        tier.way_tolerance_mm >= precision.way_tolerance_mm)
      kept = &tier;
  return error_of(*kept, precision.membrane).p99_mm2;
}

}  // namespace

AreaPrecision precision_of(const Valve& valve, const ClosureResult& closure) {
  return {static_cast<int>(valve.faces.rows()), closure.membrane, closure.residual_tolerance,
          closure.way_tolerance_mm};
}

double area_error_mm2(double area_mm2, const AreaPrecision& precision) {
  return Vec2(mesh_error_mm2(area_mm2, precision.triangles), stopping_error_mm2(precision)).norm();
}

}  // namespace coapt
