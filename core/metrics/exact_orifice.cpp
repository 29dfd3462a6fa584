#include "core/metrics/exact_orifice.h"

#include <algorithm>
#include <clipper.hpp>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "core/metrics/edge_heights.h"
#include "core/metrics/free_area.h"
#include "core/metrics/outline.h"

namespace coapt {
namespace {

using ClipperLib::IntPoint, ClipperLib::Path, ClipperLib::Paths;

constexpr double kPerMm = 1 << 20;  // 2^30 is the most that Clipper takes at full speed
constexpr double kFarthest_mm = 1000.0;
constexpr double kArcTolerance_mm = 1e-4;  // 1e-3 would save a sixth of the time
/// Narrower faces can vanish in the union's rounding: their longest edge is grown apart from it.
constexpr double kEdgeOn_mm = 1e-4;
constexpr double kCorner_mm = 0.01;  // of outlines that are drawn

IntPoint to_grid(const Vec2& point_mm) {
  const auto round = [](double mm) {
    return std::llround(std::clamp(mm, -kFarthest_mm, kFarthest_mm) * kPerMm);
  };
  return {round(point_mm.x()), round(point_mm.y())};
}

Vec2 from_grid(const IntPoint& point) {
  return Vec2(static_cast<double>(point.X), static_cast<double>(point.Y)) / kPerMm;
}

/// Twice the area, exact, positive when counter-clockwise.
ClipperLib::cInt turn(const IntPoint& a, const IntPoint& b, const IntPoint& c) {
  return (b.X - a.X) * (c.Y - a.Y) - (b.Y - a.Y) * (c.X - a.X);
}

/// The leaflets on the grid.
struct Silhouette {
  Paths outlines;  ///< wind round each point as often as there are faces over it
  Paths edge_on;   ///< the longest edge of faces that hardly cover anything
};

/// Appends the longest edge of a face that is seen edge-on.
void add_if_edge_on(Paths& edges, const std::array<IntPoint, 3>& corners, double twice_area) {
  double longest_squared = 0.0;
  std::size_t longest = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const IntPoint &a = corners[i], &b = corners[(i + 1) % 3];
    const double x = static_cast<double>(b.X - a.X), y = static_cast<double>(b.Y - a.Y);
    if (x * x + y * y > longest_squared) {
      longest_squared = x * x + y * y;
      longest = i;
    }
  }
  constexpr double kWidth = kEdgeOn_mm * kPerMm;
  if (twice_area * twice_area <= kWidth * kWidth * longest_squared)
    edges.push_back({corners[longest], corners[(longest + 1) % 3]});
}

Silhouette make_silhouette(const Valve& valve, const Projection& projection) {
  std::vector<std::array<int, 3>> towards, away;
  std::vector<IntPoint> grid(valve.rest_mm.rows());
  Silhouette tissue;
  for (std::size_t f = 0; f < projection.faces.size(); ++f) {
    std::array<int, 3> face = {valve.faces(f, 0), valve.faces(f, 1), valve.faces(f, 2)};
    std::array<IntPoint, 3> corners;
    for (std::size_t i = 0; i < 3; ++i) {
      corners[i] = to_grid(projection.faces[f][i]);
      grid[face[i]] = corners[i];
    }
    const ClipperLib::cInt twice_area = turn(corners[0], corners[1], corners[2]);
    add_if_edge_on(tissue.edge_on, corners, std::abs(static_cast<double>(twice_area)));
    if (twice_area < 0) std::swap(face[1], face[2]);
    if (twice_area != 0) (twice_area > 0 ? towards : away).push_back(face);
  }
  for (const auto* faces : {&towards, &away})
    for (const std::vector<int>& walk : outline(*faces)) {
      Path path;
      for (const int vertex : walk) path.push_back(grid[vertex]);
      tissue.outlines.push_back(std::move(path));
    }
  return tissue;
}

std::optional<Paths> united(const Paths& paths) {
  ClipperLib::Clipper clipper;
  Paths result;
  if (!clipper.AddPaths(paths, ClipperLib::ptSubject, true)) return result;  // all without area
  if (!clipper.Execute(ClipperLib::ctUnion, result, ClipperLib::pftNonZero)) return std::nullopt;
  return result;
}

Paths grown(const Paths& outlines, const Paths& edge_on, double radius_mm) {
  ClipperLib::ClipperOffset offset;
  offset.ArcTolerance = kArcTolerance_mm * kPerMm;
  offset.AddPaths(outlines, ClipperLib::jtRound, ClipperLib::etClosedPolygon);
  offset.AddPaths(edge_on, ClipperLib::jtRound, ClipperLib::etOpenRound);
  Paths result;
  offset.Execute(result, radius_mm * kPerMm);
  return result;
}

/// A region's outer boundary with the boundaries of its islands.
struct Opening {
  double area_mm2 = 0.0;
  Vec2 moment_mm3 = Vec2::Zero();  ///< centroid times area
  Paths contours = {};             ///< outer first
};

void add_contour(Opening& opening, const Path& contour) {
  const Vec2 origin = from_grid(contour.front());
  for (std::size_t i = 0; i < contour.size(); ++i) {
    const Vec2 a = from_grid(contour[i]) - origin;
    const Vec2 b = from_grid(contour[(i + 1) % contour.size()]) - origin;
    const double area = 0.5 * (a.x() * b.y() - b.x() * a.y());
    opening.area_mm2 += area;
    opening.moment_mm3 += area * (origin + (a + b) / 3.0);
  }
  opening.contours.push_back(contour);
}

Path path_of(const std::vector<Vec2>& line) {
  Path path;
  for (const Vec2& point : line) path.push_back(to_grid(point));
  return path;
}

/// What `tissue` leaves open of what a closed line surrounds, largest first.
std::optional<std::vector<Opening>> openings(const std::vector<Vec2>& outline,
                                             const Paths& tissue) {
  ClipperLib::Clipper clipper;
  std::vector<Opening> result;
  if (!clipper.AddPath(path_of(outline), ClipperLib::ptSubject, true)) return result;
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

double total_mm2(const std::optional<std::vector<Opening>>& openings) {
  if (!openings) return std::numeric_limits<double>::quiet_NaN();
  double total = 0.0;
  for (const Opening& opening : *openings) total += opening.area_mm2;
  return total;
}

/// What the view shows open; none where the union failed.
struct Seen {
  std::optional<std::vector<Opening>> raw, open;  ///< bare mid-surfaces; grown
};

Seen look(const Valve& valve, const Projection& projection, double half_thickness_mm) {
  const Silhouette tissue = make_silhouette(valve, projection);
  const std::optional<Paths> bare = united(tissue.outlines);
  Seen seen;
  if (!bare) return seen;
  seen.raw = openings(projection.annulus, *bare);
  seen.open = half_thickness_mm > 0.0
                  ? openings(projection.annulus, grown(*bare, tissue.edge_on, half_thickness_mm))
                  : seen.raw;
  return seen;
}

}  // namespace

ExactOrifice exact_orifice(const Valve& valve, const Projection& projection,
                           double half_thickness_mm) {
  const auto [raw, open] = look(valve, projection, half_thickness_mm);
  ExactOrifice exact{total_mm2(open), total_mm2(raw), {}};
  if (!open) return exact;
  for (const Opening& opening : *open) {
    if (!(opening.area_mm2 > 0.0)) continue;
    const Vec2 centroid_mm = opening.moment_mm3 / opening.area_mm2;
    exact.orifices.push_back({opening.area_mm2, unproject(projection.plane, centroid_mm),
                              nearest_segment(valve, projection, centroid_mm)});
  }
  return exact;
}

std::vector<OrificeOutline> orifice_outlines(const Valve& valve, const Points& closed_mm,
                                             double half_thickness_mm) {
  const Projection projection = project_valve(valve, closed_mm, annular_plane(valve));
  const EdgeHeights edges(valve.faces, closed_mm, projection.plane);
  std::vector<OrificeOutline> outlines;
  const Seen seen = look(valve, projection, half_thickness_mm);
  if (!seen.open) return outlines;
  for (const Opening& opening : *seen.open) {
    if (!(opening.area_mm2 > 0.0)) continue;
    OrificeOutline outline{opening.area_mm2, {}};
    for (Path contour : opening.contours) {
      ClipperLib::CleanPolygon(contour, kCorner_mm * kPerMm);
      if (contour.size() < 3) continue;  // a speck
      Points& points_mm = outline.contours_mm.emplace_back(std::ssize(contour), 3);
      for (std::size_t i = 0; i < contour.size(); ++i) {
        const Vec2 seen_mm = from_grid(contour[i]);
        const Vec3 lifted_mm =
            unproject(projection.plane, seen_mm) + edges.at(seen_mm) * projection.plane.normal;
        points_mm.row(i) = lifted_mm.transpose();
      }
    }
    if (!outline.contours_mm.empty()) outlines.push_back(std::move(outline));
  }
  return outlines;
}

ExactOrifice exact_orifice(const Valve& valve, const Points& closed_mm, double half_thickness_mm) {
  return exact_orifice(valve, project_valve(valve, closed_mm, annular_plane(valve)),
                       half_thickness_mm);
}

double free_area_mm2(const std::vector<Vec2>& outline, const std::vector<std::vector<Vec2>>& tissue,
                     double half_thickness_mm) {
  Paths lines;
  if (half_thickness_mm > 0.0)
    for (const std::vector<Vec2>& line : tissue) lines.push_back(path_of(line));
  return total_mm2(openings(outline, lines.empty() ? lines : grown({}, lines, half_thickness_mm)));
}

OrificeMeasure measure_orifice(const Valve& valve, const ClosureResult& closure) {
  const double half_thickness_mm = 0.5 * valve.tissue.thickness_mm;
  const AnnularPlane plane = annular_plane(valve);
  const auto seen = [&](const Points& closed_mm) {
    return exact_orifice(valve, project_valve(valve, closed_mm, plane), half_thickness_mm);
  };
  ExactOrifice end = seen(closure.closed_mm);
  OrificeMeasure measure{end.area_mm2, end.area_raw_mm2, end.area_mm2, std::move(end.orifices)};
  if (closure.samples_mm.empty()) return measure;
  measure.area_mean_mm2 = 0.0;
  for (const Points& sample_mm : closure.samples_mm)
    measure.area_mean_mm2 +=
        sample_mm == closure.closed_mm ? measure.area_mm2 : seen(sample_mm).area_mm2;
  measure.area_mean_mm2 /= static_cast<double>(closure.samples_mm.size());
  return measure;
}

}  // namespace coapt
