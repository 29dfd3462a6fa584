// The annulus's own axes under pressure: for what changes its shape (dilation, flattening, rings) and for what is measured and
// drawn on its plane.
#pragma once

#include "core/valve/valve.h"

namespace coapt {

/// What lies along an axis of the frame, projected on the plane. The two differ where a valve is not symmetric.
enum class AnnulusAxis {
  Commissures,  ///< x, from the anterolateral to the posteromedial one; of a valve that is not mitral its own x
  SaddlePeak,  ///< y, from mid-posterior to the saddle peak
};

/// Right-handed axes on the plane of the principal components of the annulus vertices (thesis 4.2.1), through their mean.
/// They follow the valve when it is moved or turned: `x` is posteromedial, `y` anterior, `normal` points to the atrium,
/// from where the loop runs counter-clockwise.
struct AnnulusFrame {
  Vec3 origin_mm = Vec3::Zero();
  Vec3 x = Vec3::UnitX(), y = Vec3::UnitY(), normal = Vec3::UnitZ();
};

/// Of Valve::annulus under pressure.
AnnulusFrame annulus_frame(const Valve& valve, AnnulusAxis axis);

/// (x, y, normal) coordinates of a point, and the point with such coordinates.
Vec3 into_frame(const AnnulusFrame& frame, const Vec3& point_mm);
Vec3 out_of_frame(const AnnulusFrame& frame, const Vec3& coordinates_mm);

/// The same on the plane, along x and y.
Vec2 project(const AnnulusFrame& frame, const Vec3& point_mm);
Vec3 unproject(const AnnulusFrame& frame, const Vec2& coordinates_mm);

/// Anteroposterior diameter: from the saddle peak to mid-posterior within the plane.
double ap_diameter_mm(const Valve& valve);

/// Extent of the annulus along x of the frame whose y runs to the saddle peak.
double transverse_diameter_mm(const Valve& valve);

}  // namespace coapt
