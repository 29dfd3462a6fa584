// The annulus's own axes under pressure, for what changes its shape: dilation, flattening, rings.
#pragma once

#include "core/valve/valve.h"

namespace coapt {

/// Right-handed: transverse x anterior = normal. The plane is that of the principal components of
/// the annulus vertices (thesis 4.2.1), through their mean; `anterior` points from mid-posterior to
/// the saddle peak within it, `normal` to the atrium.
struct AnnulusFrame {
  Vec3 origin_mm = Vec3::Zero();
  Vec3 transverse = Vec3::UnitX();
  Vec3 anterior = Vec3::UnitY();
  Vec3 normal = Vec3::UnitZ();
};

/// Of Valve::annulus under pressure.
AnnulusFrame annulus_frame(const Valve& valve);

/// (transverse, anterior, normal) coordinates of a point, and the point with such coordinates.
Vec3 into_frame(const AnnulusFrame& frame, const Vec3& point_mm);
Vec3 out_of_frame(const AnnulusFrame& frame, const Vec3& coordinates_mm);

/// Anteroposterior diameter: from the saddle peak to mid-posterior within the plane.
double ap_diameter_mm(const Valve& valve, const AnnulusFrame& frame);

/// Extent of the annulus along `transverse`.
double transverse_diameter_mm(const Valve& valve, const AnnulusFrame& frame);

}  // namespace coapt
