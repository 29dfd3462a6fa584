#include "core/metrics/openings_clipper.h"

#include <algorithm>
#include <clipper.hpp>

#include "core/metrics/openings.h"
#include "core/metrics/plane_grid.h"

namespace coapt {
namespace {

using ClipperLib::IntPoint, ClipperLib::Path, ClipperLib::Paths;

constexpr double kArcTolerance_mm = 1e-4;  // 1e-3 would save a sixth of the time

Path path_of(const std::vector<Vec2>& line_mm) {
  Path path;
  path.reserve(line_mm.size());
  for (const Vec2& point_mm : line_mm) {
    const GridPoint point = to_grid(point_mm);
    path.push_back({point.x, point.y});
  }
  return path;
}

Paths paths_of(const std::vector<std::vector<Vec2>>& lines_mm) {
  Paths paths;
  paths.reserve(lines_mm.size());
  for (const std::vector<Vec2>& line_mm : lines_mm) paths.push_back(path_of(line_mm));
  return paths;
}

std::optional<Paths> united(const Paths& paths) {
  ClipperLib::Clipper clipper;
  Paths result;
  if (!clipper.AddPaths(paths, ClipperLib::ptSubject, true)) return result;  // all without area
  if (!clipper.Execute(ClipperLib::ctUnion, result, ClipperLib::pftNonZero)) return std::nullopt;
  return result;
}

Paths grown(const Paths& outlines, const Paths& lines, double radius_mm) {
  ClipperLib::ClipperOffset offset;
  offset.ArcTolerance = kArcTolerance_mm * kGridPerMm;
  offset.AddPaths(outlines, ClipperLib::jtRound, ClipperLib::etClosedPolygon);
  offset.AddPaths(lines, ClipperLib::jtRound, ClipperLib::etOpenRound);
  Paths result;
  offset.Execute(result, radius_mm * kGridPerMm);
  return result;
}

void add_contour(Opening& opening, const Path& path) {
  std::vector<Vec2>& contour_mm = opening.contours_mm.emplace_back();
  contour_mm.reserve(path.size());
  for (const IntPoint& point : path) contour_mm.push_back(from_grid({point.X, point.Y}));
  const Vec2 origin = contour_mm.front();
  for (std::size_t i = 0; i < contour_mm.size(); ++i) {
    const Vec2 a = contour_mm[i] - origin;
    const Vec2 b = contour_mm[(i + 1) % contour_mm.size()] - origin;
    const double area = 0.5 * (a.x() * b.y() - b.x() * a.y());
    opening.area_mm2 += area;
    opening.moment_mm3 += area * (origin + (a + b) / 3.0);
  }
}

std::optional<std::vector<Opening>> left_open(const Path& outline, const Paths& tissue) {
  ClipperLib::Clipper clipper;
  std::vector<Opening> result;
  if (!clipper.AddPath(outline, ClipperLib::ptSubject, true)) return result;
  clipper.AddPaths(tissue, ClipperLib::ptClip, true);
  ClipperLib::PolyTree tree;
  if (!clipper.Execute(ClipperLib::ctDifference, tree, ClipperLib::pftNonZero,
                       ClipperLib::pftNonZero))
    return std::nullopt;
  for (const ClipperLib::PolyNode* node = tree.GetFirst(); node; node = node->GetNext()) {
    if (node->IsHole()) continue;
    Opening& opening = result.emplace_back();
    add_contour(opening, node->Contour);
    for (const ClipperLib::PolyNode* island : node->Childs) add_contour(opening, island->Contour);
  }
  std::stable_sort(result.begin(), result.end(),
                   [](const Opening& a, const Opening& b) { return a.area_mm2 > b.area_mm2; });
  return result;
}

}  // namespace

Openings clipped_openings(const std::vector<Vec2>& outline_mm, const FlatTissue& tissue,
                          double radius_mm) {
  const Path outline = path_of(outline_mm);
  const std::optional<Paths> bare = united(paths_of(tissue.outlines_mm));
  if (!bare) return {};
  Openings found;
  found.bare = left_open(outline, *bare);
  found.grown = radius_mm > 0.0
                    ? left_open(outline, grown(*bare, paths_of(tissue.lines_mm), radius_mm))
                    : found.bare;
  return found;
}

}  // namespace coapt
