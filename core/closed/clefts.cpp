#include "core/closed/clefts.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "core/valve/leaflet_point.h"
#include "core/valve/turns.h"

namespace coapt {
namespace {

constexpr std::array<std::pair<Segment, Segment>, 2> kBetween = {
    {{Segment::P1, Segment::P2}, {Segment::P2, Segment::P3}}};

/// The cleft whose root is nearest to a place, if it is nearer than that cleft is deep.
Cleft* nearest_of(std::vector<Cleft>& clefts, const std::vector<Vec3>& roots_mm,
                  const Vec3& place_mm) {
  Cleft* nearest = nullptr;
  double least_mm = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < clefts.size(); ++i) {
    const double away_mm = (roots_mm[i] - place_mm).norm();
    if (away_mm > clefts[i].depth_mm || away_mm >= least_mm) continue;
    least_mm = away_mm;
    nearest = &clefts[i];
  }
  return nearest;
}

/// Gives each cleft what lies of an opening beside it; of one without a surface all or nothing, by its centroid.
void add_leak(const LeakOpening& opening, const std::vector<Vec3>& roots_mm,
              std::vector<Cleft>& clefts) {
  const Points& points_mm = opening.surface.points_mm;
  const Faces& faces = opening.surface.faces;
  const auto area = [&](Index f) {
    const Vec3 a = points_mm.row(faces(f, 0)), b = points_mm.row(faces(f, 1)),
               c = points_mm.row(faces(f, 2));
    return (b - a).cross(c - a).norm();
  };
  double all = 0.0;
  for (Index f = 0; f < faces.rows(); ++f) all += area(f);
  if (!(all > 0.0)) {
    if (Cleft* const of = nearest_of(clefts, roots_mm, opening.centroid_mm))
      of->leak_mm2 += opening.area_mm2;
    return;
  }
  for (Index f = 0; f < faces.rows(); ++f) {
    const Vec3 middle =
        (points_mm.row(faces(f, 0)) + points_mm.row(faces(f, 1)) + points_mm.row(faces(f, 2))) /
        3.0;
    if (Cleft* const of = nearest_of(clefts, roots_mm, middle))
      of->leak_mm2 += opening.area_mm2 * area(f) / all;
  }
}

/// Vertices of one height, 0 (the annulus) or 1 (the free edge), in the order in which they lie around the valve.
class Rim {
 public:
  Rim(const LeafletCoordinates& coordinates, double height) {
    for (std::size_t v = 0; v < coordinates.height.size(); ++v)
      if (coordinates.height[v] == height)
        at_.emplace_back(coordinates.around[v], static_cast<Index>(v));
    std::sort(at_.begin(), at_.end());
  }

  /// Between the vertices beside `around`, of a shape.
  Vec3 place_mm(double around, const Points& shape_mm) const {
    const auto after = std::upper_bound(at_.begin(), at_.end(), std::pair(around, shape_mm.rows()));
    const auto& [to, to_vertex] = after == at_.end() ? at_.front() : *after;
    const auto& [from, from_vertex] = after == at_.begin() ? at_.back() : *(after - 1);
    const double span = turn_fraction(to - from);
    const double share = span > 0.0 ? turn_fraction(around - from) / span : 0.0;
    const Vec3 before = shape_mm.row(from_vertex), behind = shape_mm.row(to_vertex);
    return (1.0 - share) * before + share * behind;
  }

 private:
  std::vector<std::pair<double, Index>> at_;
};

/// The height of the posterior leaflet, from the annulus straight to the free edge, along it.
class Heights {
 public:
  explicit Heights(const Valve& valve)
      : valve_(valve),
        coordinates_(leaflet_coordinates(valve)),
        annulus_(coordinates_, 0.0),
        edge_(coordinates_, 1.0) {}

  double at(double along) const {
    const double place = around({Leaflet::Posterior, along, 1.0});
    return (edge_.place_mm(place, valve_.rest_mm) - annulus_.place_mm(place, valve_.rest_mm))
        .norm();
  }

  double middle_of(Segment segment) const { return middle_along(valve_, coordinates_, segment); }

  Vec3 edge_mm(double along, const Points& closed_mm) const {
    return edge_.place_mm(around({Leaflet::Posterior, along, 1.0}), closed_mm);
  }

 private:
  const Valve& valve_;
  LeafletCoordinates coordinates_;
  Rim annulus_, edge_;
};

/// As deep as the free edge lies below the line between the middles of two scallops; its root is the middle of what lies half as deep.
Cleft cleft_between(const Heights& heights, Segment first, Segment second) {
  constexpr int kPlaces = 60;
  const double from = heights.middle_of(first), to = heights.middle_of(second);
  const double from_mm = heights.at(from), to_mm = heights.at(to);
  Cleft cleft{first, second};
  std::vector<double> depth_mm;
  for (int i = 0; i <= kPlaces; ++i) {
    const double part = static_cast<double>(i) / kPlaces;
    const double level_mm = from_mm + part * (to_mm - from_mm);
    depth_mm.push_back(level_mm - heights.at(from + part * (to - from)));
    if (depth_mm.back() <= cleft.depth_mm) continue;
    cleft.depth_mm = depth_mm.back();
    cleft.share = cleft.depth_mm / level_mm;
  }
  const auto deep = [&](double depth) { return depth >= 0.5 * cleft.depth_mm; };
  const auto begins = std::find_if(depth_mm.begin(), depth_mm.end(), deep);
  const auto ends = std::find_if(depth_mm.rbegin(), depth_mm.rend(), deep).base() - 1;
  const double middle =
      0.5 * static_cast<double>((begins - depth_mm.begin()) + (ends - depth_mm.begin()));
  cleft.along = from + middle / kPlaces * (to - from);
  return cleft;
}

}  // namespace

std::vector<Cleft> leaking_clefts(const Valve& valve, const Points& closed_mm,
                                  const ValveMeasure& measure, double least_mm2) {
  std::vector<Cleft> clefts;
  if (measure.leak.area_mm2 <= least_mm2) return clefts;
  const Heights heights(valve);
  const auto has = [&valve](Segment segment) {
    return std::find(valve.segments.begin(), valve.segments.end(), segment) != valve.segments.end();
  };
  std::vector<Vec3> roots_mm;
  for (const auto& [first, second] : kBetween) {
    if (!has(first) || !has(second)) continue;
    const Cleft cleft = cleft_between(heights, first, second);
    if (cleft.share < kDeepCleft) continue;
    clefts.push_back(cleft);
    roots_mm.push_back(heights.edge_mm(cleft.along, closed_mm));
  }
  for (const LeakOpening& opening : measure.leak.openings) add_leak(opening, roots_mm, clefts);
  std::erase_if(clefts, [&](const Cleft& cleft) { return cleft.leak_mm2 <= least_mm2; });
  return clefts;
}

double leak_through(const std::vector<Cleft>& clefts) {
  double leak_mm2 = 0.0;
  for (const Cleft& cleft : clefts) leak_mm2 += cleft.leak_mm2;
  return leak_mm2;
}

}  // namespace coapt
