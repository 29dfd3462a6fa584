// Where the long-axis section lies in its panel: its coordinates, its extent, its scale.
#pragma once

#include "core/closed/closed_valve.h"
#include "core/metrics/section.h"
#include "io/picture/view_frame.h"

namespace coapt {

/// Section coordinates in pixels: right is posterior, up is atrial.
struct SectionMap {
  Vec3 origin_mm, right, up, out;
  Vec2 origin_px;
  double pixels_per_mm;
  Vec2 operator()(const Vec3& point) const {
    const Vec3 offset = point - origin_mm;
    return {origin_px.x() + pixels_per_mm * offset.dot(right),
            origin_px.y() - pixels_per_mm * offset.dot(up)};
  }
  double off_plane_mm(const Vec3& point) const { return std::abs((point - origin_mm).dot(out)); }
};

/// The middle of the annular line a fifth below the top and in the middle of the panel, or as near
/// to that as lets the leaflets, the tips and their labels into the box.
SectionMap section_map(const ViewFrame& frame, const ClosedValve& closed);

/// The largest scale at which the section down to the papillary tips fits into a box.
double section_scale(const Box& box, const ClosedValve& closed);

}  // namespace coapt
