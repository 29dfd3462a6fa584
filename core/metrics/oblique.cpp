#include "core/metrics/oblique.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "core/metrics/exact_orifice.h"

namespace coapt {
namespace {

// On the preset with a prolapse 20 degrees see 0.4 mm2, 30 degrees 10, 50 degrees 26, 60 degrees
// 18.
constexpr double kTiltStep_deg = 10.0, kMostTilt_deg = 60.0, kAzimuthStep_deg = 45.0;

}  // namespace

AnnulusFrame tilted(const AnnulusFrame& plane, double tilt_deg, double azimuth_deg) {
  constexpr double kRadians = std::numbers::pi / 180.0;
  const double azimuth = azimuth_deg * kRadians;
  const Vec3 leaning = plane.x * std::cos(azimuth) + plane.y * std::sin(azimuth);
  const Eigen::AngleAxisd turn(tilt_deg * kRadians, plane.normal.cross(leaning));
  return {plane.origin_mm, turn * plane.x, turn * plane.y, turn * plane.normal};
}

ObliqueOrifice oblique_orifice(const Valve& valve, const Points& closed_mm,
                               double half_thickness_mm) {
  const AnnulusFrame plane = annulus_frame(valve, AnnulusAxis::Commissures);
  const auto area_mm2 = [&](const AnnulusFrame& view) {
    return exact_orifice(valve, project_valve(valve, closed_mm, view), half_thickness_mm).area_mm2;
  };
  ObliqueOrifice widest{area_mm2(plane), 0.0, 0.0};
  for (double tilt = kTiltStep_deg; tilt <= kMostTilt_deg; tilt += kTiltStep_deg)
    for (double azimuth = 0.0; azimuth < 360.0; azimuth += kAzimuthStep_deg) {
      const double area = area_mm2(tilted(plane, tilt, azimuth));
      if (area > widest.area_mm2) widest = {area, tilt, azimuth};
    }
  return widest;
}

}  // namespace coapt
