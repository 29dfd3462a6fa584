// The annulus under pressure: its plane of best fit and its dimensions.
#pragma once

#include <vector>

#include "core/valve/valve.h"

namespace coapt {

/// Right-handed axes on the annulus's plane of best fit (principal components of its vertices).
/// They follow the valve when it is moved or turned: `x` runs from the anterolateral to the
/// posteromedial commissure, `y` is anterior, `normal` points to the atrium, from where the loop
/// runs counter-clockwise. Of a valve that is not mitral `x` is that of its frame.
struct AnnularPlane {
  Vec3 origin_mm = Vec3::Zero();  ///< mean of the annulus vertices
  Vec3 x = Vec3::UnitX(), y = Vec3::UnitY(), normal = Vec3::UnitZ();
};

AnnularPlane annular_plane(const Valve& valve);

/// Coordinates along x and y.
Vec2 project(const AnnularPlane& plane, const Vec3& point_mm);

/// The point of the plane with these coordinates.
Vec3 unproject(const AnnularPlane& plane, const Vec2& coordinates_mm);

/// Projected annulus, |A| points, counter-clockwise.
std::vector<Vec2> annulus_polygon(const Valve& valve, const AnnularPlane& plane);

/// Shoelace formula (thesis equation 4.1), positive when counter-clockwise.
double polygon_area(const std::vector<Vec2>& polygon);

struct AnnulusMeasure {
  /// Saddle peak to mid-posterior, projected on the annulus's PCA plane; of a valve that is not
  /// mitral its extent along y.
  double ap_mm = 0.0;
  double al_pm_mm = 0.0;  ///< widest extent along the direction from commissure to commissure
  double circumference_mm = 0.0;
  double area_mm2 = 0.0;          ///< projected on that plane
  double saddle_height_mm = 0.0;  ///< extent along that plane's normal
};

AnnulusMeasure measure_annulus(const Valve& valve);

}  // namespace coapt
