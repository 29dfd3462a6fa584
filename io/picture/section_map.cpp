#include "io/picture/section_map.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>

#include "core/metrics/coaptation.h"

namespace coapt {
namespace {

using Bounds = Eigen::AlignedBox2d;  // of section coordinates: pixels or millimetres, y down

// Pixels that must stay free around the drawing: for labels, and for the width of strokes.
constexpr double kBeside = 85.0;     // of the leaflets: "anterior", "posterior"
constexpr double kTipRadius = 12.0;  // beside the tips
constexpr double kAbove = 62.0;      // "left atrium" and the tenting
constexpr double kBelow = 72.0;      // "papillary tips" above the row of the scale bar

struct Extents {
  Bounds leaflets, tips;
};

Extents extents(const ClosedValve& closed, const SectionMap& map) {
  const Valve& valve = closed.valve;
  Extents found;
  found.leaflets.extend(map(annulus_position_mm(valve, valve.landmarks.saddle_peak)));
  found.leaflets.extend(map(annulus_position_mm(valve, valve.landmarks.mid_posterior)));
  for (const SectionLine& line : cut(valve.faces, closed.closure.closed_mm, mid_valve_plane(valve)))
    for (const Vec3& point : line.points_mm) found.leaflets.extend(map(point));
  for (const PapillaryHead& head : valve.heads) found.tips.extend(map(head.tip_mm));
  for (const SutureMark& suture : closed.repair.sutures)
    found.tips.extend(map(suture.tip_before_mm));
  return found;
}

struct Flank {
  double reach_mm, labels;  // from the origin; pixels beyond that
};

/// The parts on either side of the origin, in one direction: left or right.
std::array<Flank, 2> sides(const Extents& mm, bool right) {
  const auto reach = [right](const Bounds& extent) {
    if (extent.isEmpty()) return 0.0;
    return std::max(0.0, right ? extent.max().x() : -extent.min().x());
  };
  return {{{reach(mm.leaflets), kBeside}, {reach(mm.tips), kTipRadius}}};
}

double needed(const std::array<Flank, 2>& parts, double pixels_per_mm) {
  return std::max(parts[0].labels + parts[0].reach_mm * pixels_per_mm,
                  parts[1].labels + parts[1].reach_mm * pixels_per_mm);
}

SectionMap unplaced(const Valve& valve) {
  const SectionPlane plane = mid_valve_plane(valve);
  const Vec3 up = annulus_frame(valve, AnnulusAxis::Commissures).normal;
  const Vec3 middle_mm = 0.5 * (annulus_position_mm(valve, valve.landmarks.saddle_peak) +
                                annulus_position_mm(valve, valve.landmarks.mid_posterior));
  return {middle_mm, plane.normal.cross(up), up, plane.normal, Vec2::Zero(), 1.0};
}

/// Top and bottom of leaflets and tips together, mm below the origin.
std::pair<double, double> depth_mm(const Extents& mm) {
  const Bounds both = mm.leaflets.merged(mm.tips);
  return {both.min().y(), std::max(12.0, both.max().y())};
}

}  // namespace

SectionMap section_map(const ViewFrame& frame, const ClosedValve& closed) {
  const Box& box = frame.box;
  SectionMap map = unplaced(closed.valve);
  const Extents mm = extents(closed, map);
  const double scale = map.pixels_per_mm = frame.pixels_per_mm;
  const auto between = [](double wanted, double low, double high) {
    return std::max(low, std::min(wanted, high));
  };
  const auto [top_mm, bottom_mm] = depth_mm(mm);
  map.origin_px = {between(box.x + 0.5 * box.width, box.x + needed(sides(mm, false), scale),
                           box.x + box.width - needed(sides(mm, true), scale)),
                   between(box.y + 0.2 * box.height, box.y + kAbove - top_mm * scale,
                           box.y + box.height - kBelow - bottom_mm * scale)};
  return map;
}

double section_scale(const Box& box, const ClosedValve& closed) {
  if (!closed.closure.closed_mm.allFinite()) return ViewFrame{}.pixels_per_mm;
  const Extents mm = extents(closed, unplaced(closed.valve));
  const auto [top_mm, bottom_mm] = depth_mm(mm);
  double scale = (box.height - kAbove - kBelow) / (bottom_mm - top_mm);
  for (const Flank& left : sides(mm, false))
    for (const Flank& right : sides(mm, true))
      scale = std::min(scale, (box.width - left.labels - right.labels) /
                                  std::max(1.0, left.reach_mm + right.reach_mm));
  return scale;
}

}  // namespace coapt
