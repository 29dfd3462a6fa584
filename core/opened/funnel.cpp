#include "core/opened/funnel.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/metrics/exact_orifice.h"
#include "core/metrics/outline.h"
#include "core/metrics/section.h"

namespace coapt {
namespace {

constexpr double kPlane_mm = 0.5;
constexpr int kBins = 720;
constexpr double kBin = 2.0 * std::numbers::pi / kBins;

struct Axis {
  Vec3 from_mm = Vec3::Zero(), along = -Vec3::UnitZ(), x = Vec3::UnitX(), y = Vec3::UnitY();
};

Vec2 across(const Axis& axis, const Vec3& point_mm) {
  return {axis.x.dot(point_mm - axis.from_mm), axis.y.dot(point_mm - axis.from_mm)};
}

/// Of a line, whatever the distances of its points.
struct MeanByLength {
  Vec3 sum = Vec3::Zero();
  double length_mm = 0.0;
  void add(const Vec3& from, const Vec3& to) {
    sum += 0.5 * (to - from).norm() * (from + to);
    length_mm += (to - from).norm();
  }
  Vec3 mean() const { return sum / length_mm; }
};

std::vector<std::array<int, 2>> free_edges(const Valve& valve) {
  std::vector<std::array<int, 2>> edges;
  std::vector<bool> on_annulus(valve.rest_mm.rows(), false);
  for (const int vertex : valve.annulus) on_annulus[vertex] = true;
  std::vector<std::array<int, 3>> faces;
  for (const auto& face : valve.faces.rowwise()) faces.push_back({face[0], face[1], face[2]});
  for (const std::vector<int>& walk : outline(faces))
    for (std::size_t i = 0; i < walk.size(); ++i) {
      const int a = walk[i], b = walk[(i + 1) % walk.size()];
      if (!(on_annulus[a] && on_annulus[b])) edges.push_back({a, b});
    }
  return edges;
}

Axis funnel_axis(const Valve& valve, const Points& open_mm) {
  Axis axis;
  MeanByLength annulus, edges;
  const Eigen::Index count = valve.annulus_mm.rows();
  for (Eigen::Index i = 0; i < count; ++i)
    annulus.add(valve.annulus_mm.row(i), valve.annulus_mm.row((i + 1) % count));
  for (const auto& [a, b] : free_edges(valve)) edges.add(open_mm.row(a), open_mm.row(b));
  axis.from_mm = annulus.mean();
  if (edges.length_mm > 0.0) axis.along = (edges.mean() - axis.from_mm).normalized();
  axis.x = axis.along.unitOrthogonal();
  axis.y = axis.along.cross(axis.x);
  return axis;
}

/// How far a line turns about the axis, radians, positive from x to y; and where its middle lies.
struct Turn {
  double by = 0.0, middle = 0.0;
};

Turn turn_of(const std::vector<Vec2>& line) {
  Turn turn;
  std::vector<double> passed = {0.0};
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Vec2 &a = line[i - 1], &b = line[i];
    turn.by += std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
    passed.push_back(turn.by);
  }
  turn.middle = std::atan2(line.front().y(), line.front().x()) + 0.5 * turn.by;
  return turn;
}

/// The leaflets in one plane: lines that surround the axis, in order, all running the same way.
struct Crossing {
  std::vector<std::vector<Vec2>> lines;
  bool closed = false;  ///< one line, that surrounds the axis by itself
};

Crossing crossing_at(const Valve& valve, const Points& open_mm, const Axis& axis, double depth_mm) {
  Crossing crossing;
  std::vector<std::pair<double, std::vector<Vec2>>> open;
  for (const SectionLine& line :
       cut(valve.faces, open_mm, {axis.from_mm + depth_mm * axis.along, axis.along})) {
    std::vector<Vec2> flat;
    for (const Vec3& point : line.points_mm) flat.push_back(across(axis, point));
    const bool ends = (flat.front() - flat.back()).norm() > 1e-9;
    Turn turn = turn_of(flat);
    if (turn.by < 0.0) std::reverse(flat.begin(), flat.end());
    if (!ends) {  // around the axis, or a pocket beside it
      if (std::abs(turn.by) < std::numbers::pi) continue;
      crossing.lines = {std::move(flat)};
      crossing.closed = true;
      return crossing;
    }
    open.emplace_back(std::remainder(turn.middle, 2.0 * std::numbers::pi), std::move(flat));
  }
  std::sort(open.begin(), open.end(),
            [](const auto& a, const auto& b) { return a.first < b.first; });
  for (auto& [middle, line] : open) crossing.lines.push_back(std::move(line));
  return crossing;
}

std::vector<Vec2> outline_of(const Crossing& crossing) {
  std::vector<Vec2> outline;
  for (const std::vector<Vec2>& line : crossing.lines)
    outline.insert(outline.end(), line.begin(), line.end());
  return outline;
}

double angle_of(const Vec2& point) { return std::atan2(point.y(), point.x()); }

/// From a to b the way that lines run, [0, 2 pi).
double angle_between(const Vec2& a, const Vec2& b) {
  const double angle = std::remainder(angle_of(b) - angle_of(a), 2.0 * std::numbers::pi);
  return angle < 0.0 ? angle + 2.0 * std::numbers::pi : angle;
}

/// A chord that joins the end of a line to the start of the next.
struct Gap {
  Vec2 from, to;
};

std::vector<Gap> gaps_of(const Crossing& crossing) {
  std::vector<Gap> gaps;
  if (crossing.closed) return gaps;
  for (std::size_t i = 0; i < crossing.lines.size(); ++i)
    gaps.push_back(
        {crossing.lines[i].back(), crossing.lines[(i + 1) % crossing.lines.size()].front()});
  return gaps;
}

/// An outline as distances from the axis, kBins to a turn.
using Radii = std::vector<double>;

Radii radii_of(const std::vector<Vec2>& outline) {
  Radii radii(kBins, 0.0);
  for (std::size_t i = 0; i < outline.size(); ++i) {
    Vec2 a = outline[i], b = outline[(i + 1) % outline.size()];
    double turn = std::remainder(angle_of(b) - angle_of(a), 2.0 * std::numbers::pi);
    if (turn < 0.0) {
      std::swap(a, b);
      turn = -turn;
    }
    const double from = (angle_of(a) + std::numbers::pi) / kBin;
    for (int bin = static_cast<int>(std::ceil(from)); bin <= from + turn / kBin; ++bin) {
      const double angle = bin * kBin - std::numbers::pi;
      const Vec2 ray(std::cos(angle), std::sin(angle)), edge = b - a;
      const double along = edge.x() * ray.y() - edge.y() * ray.x();
      if (along == 0.0) continue;
      const double radius = (edge.x() * a.y() - edge.y() * a.x()) / along;
      double& kept = radii[static_cast<std::size_t>(bin % kBins)];
      kept = std::max(kept, radius);
    }
  }
  return radii;
}

/// Of the strip from the outline above to a chord kPlane_mm below it.
double strip_mm2(const Gap& gap, const Radii& above, double thickness_mm) {
  const double length_mm = (gap.to - gap.from).norm();
  if (length_mm <= thickness_mm) return 0.0;
  const double from = (angle_of(gap.from) + std::numbers::pi) / kBin;
  const double to = from + angle_between(gap.from, gap.to) / kBin;
  double swept_mm2 = 0.0;
  for (int bin = static_cast<int>(std::ceil(from)); bin < to; ++bin) {
    const double angle = bin * kBin - std::numbers::pi;
    const Vec2 ray(std::cos(angle), std::sin(angle)), edge = gap.to - gap.from;
    const double radius = (edge.x() * gap.from.y() - edge.y() * gap.from.x()) /
                          (edge.x() * ray.y() - edge.y() * ray.x());
    const double outside = above[static_cast<std::size_t>(bin % kBins)];
    swept_mm2 += 0.5 * kBin * std::max(0.0, outside * outside - radius * radius);
  }
  return (1.0 - thickness_mm / length_mm) * Vec2(swept_mm2, kPlane_mm * length_mm).norm();
}

/// Where the smallest surface ends at the leaflets: its plane's lines, and between them the free edges above it.
std::vector<Vec3> rim_of(const Crossing& crossing, const Valve& valve, const Points& open_mm,
                         const Axis& axis, double depth_mm) {
  std::vector<Vec3> above_mm;
  if (!crossing.closed)
    for (const auto& [vertex, next] : free_edges(valve)) {
      const Vec3 point_mm = open_mm.row(vertex);
      if (axis.along.dot(point_mm - axis.from_mm) < depth_mm) above_mm.push_back(point_mm);
    }
  std::vector<Vec3> rim_mm;
  const std::vector<Gap> gaps = gaps_of(crossing);
  for (std::size_t i = 0; i < crossing.lines.size(); ++i) {
    for (const Vec2& point : crossing.lines[i])
      rim_mm.push_back(axis.from_mm + depth_mm * axis.along + point.x() * axis.x +
                       point.y() * axis.y);
    if (crossing.closed) break;
    const Gap& gap = gaps[i];
    std::vector<std::pair<double, Vec3>> edge;
    for (const Vec3& point_mm : above_mm) {
      const double angle = angle_between(gap.from, across(axis, point_mm));
      if (angle < angle_between(gap.from, gap.to)) edge.emplace_back(angle, point_mm);
    }
    std::sort(edge.begin(), edge.end(),
              [](const auto& a, const auto& b) { return a.first < b.first; });
    for (const auto& [angle, point_mm] : edge) rim_mm.push_back(point_mm);
  }
  return rim_mm;
}

/// Whether no gap lets the axis out.
bool surrounds_axis(const Crossing& crossing) {
  if (crossing.closed) return true;
  const std::vector<Gap> gaps = gaps_of(crossing);
  return !gaps.empty() && std::all_of(gaps.begin(), gaps.end(), [](const Gap& gap) {
    return angle_between(gap.from, gap.to) < std::numbers::pi;
  });
}

}  // namespace

FunnelPassage narrowest_passage(const Valve& valve, const Points& open_mm) {
  const Axis axis = funnel_axis(valve, open_mm);
  const auto depth = [&](const auto& point) {
    return axis.along.dot(point.transpose() - axis.from_mm);
  };
  double top_mm = -1e300, bottom_mm = -1e300;
  for (const auto& point : valve.annulus_mm.rowwise()) top_mm = std::max(top_mm, depth(point));
  for (const auto& point : open_mm.rowwise()) bottom_mm = std::max(bottom_mm, depth(point));
  const double thickness_mm = valve.tissue.thickness_mm;
  std::vector<Vec2> ring = annulus_polygon(valve, annulus_frame(valve, AnnulusAxis::Commissures));
  ring.push_back(ring.front());
  FunnelPassage found{free_area_mm2(ring, {ring}, 0.5 * thickness_mm), 0.0, axis.along, {}};
  Crossing narrowest;
  double sideways_mm2 = 0.0;
  Radii above;
  for (double at_mm = top_mm + 0.5 * kPlane_mm; at_mm < bottom_mm; at_mm += kPlane_mm) {
    Crossing crossing = crossing_at(valve, open_mm, axis, at_mm);
    if (!surrounds_axis(crossing)) break;
    if (!above.empty())
      for (const Gap& gap : gaps_of(crossing)) sideways_mm2 += strip_mm2(gap, above, thickness_mm);
    if (sideways_mm2 >= found.area_mm2) break;  // and only grows further down
    const std::vector<Vec2> outline = outline_of(crossing);
    above = radii_of(outline);
    const double area_mm2 =
        free_area_mm2(outline, crossing.lines, 0.5 * thickness_mm) + sideways_mm2;
    if (std::isnan(area_mm2)) return {area_mm2, at_mm, axis.along, {}};
    if (area_mm2 < found.area_mm2) {
      found.area_mm2 = area_mm2;
      found.depth_mm = at_mm;
      narrowest = std::move(crossing);
    }
  }
  found.outline_mm = rim_of(narrowest, valve, open_mm, axis, found.depth_mm);
  if (narrowest.lines.empty())
    for (const auto& point : valve.annulus_mm.rowwise()) found.outline_mm.push_back(point);
  return found;
}

}  // namespace coapt
