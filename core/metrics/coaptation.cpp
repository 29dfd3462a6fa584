#include "core/metrics/coaptation.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

#include "core/metrics/leaflet_sides.h"
#include "core/metrics/quantile.h"
#include "core/metrics/surface_tree.h"

namespace coapt {
namespace {

CoaptationOptions with_contact_distance(CoaptationOptions options, const Valve& valve) {
  if (options.contact_distance_mm == 0.0)
    options.contact_distance_mm = kContactThicknesses * valve.tissue.thickness_mm;
  return options;
}

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// One piece of a cut, in equal parts no longer than `sample_mm`; `visit(middle, length)` for each.
template <class Visit>
void sample(const Vec3& from, const Vec3& to, double sample_mm, const Visit& visit) {
  const double length = (to - from).norm();
  const int parts = std::max(1, static_cast<int>(std::ceil(std::min(length / sample_mm, 1e4))));
  for (int i = 0; i < parts; ++i) visit(from + (i + 0.5) / parts * (to - from), length / parts);
}

/// `visit(i, line)` for each piece of the cuts that lies on the anterior side.
template <class Visit>
void for_anterior_pieces(const std::vector<SectionLine>& lines, const std::vector<Leaflet>& sides,
                         const Visit& visit) {
  for (const SectionLine& line : lines)
    for (std::size_t i = 0; i < line.faces.size(); ++i)
      if (sides[line.faces[i]] == Leaflet::Anterior) visit(line, i);
}

/// What has been measured at one point says of others that they cannot be nearer than this: the
/// distance changes by no more than the way from one to the other.
struct MeasuredPoint {
  Vec3 at_mm = Vec3::Zero();
  TreePoint nearest;
  double least_mm(const Vec3& point) const {
    return nearest.face < 0 ? 0.0 : nearest.distance_mm - (point - at_mm).norm();
  }
};

/// Where the cuts' corners on the anterior side are nearest: a bound of what matters between them.
CoaptationSection nearest_corner(const std::vector<SectionLine>& lines,
                                 const std::vector<Leaflet>& sides, const SurfaceTree& posterior) {
  CoaptationSection section;
  section.distance_mm = kInfinity;
  MeasuredPoint last;
  for_anterior_pieces(lines, sides, [&](const SectionLine& line, std::size_t i) {
    for (const Vec3& point : {line.points_mm[i], line.points_mm[i + 1]}) {
      if (last.least_mm(point) >= section.distance_mm) continue;
      last = {point, posterior.nearest(point, kInfinity, last.nearest.face)};
      if (last.nearest.distance_mm >= section.distance_mm) continue;
      section.distance_mm = last.nearest.distance_mm;
      section.nearest_mm = {point, last.nearest.point_mm};
    }
  });
  return section;
}

CoaptationSection measure_section(const std::vector<SectionLine>& lines,
                                  const std::vector<Leaflet>& sides, const SurfaceTree& posterior,
                                  const CoaptationOptions& options) {
  CoaptationSection section = nearest_corner(lines, sides, posterior);
  const double contact_mm = options.contact_distance_mm;
  MeasuredPoint last;
  for_anterior_pieces(lines, sides, [&](const SectionLine& line, std::size_t i) {
    sample(line.points_mm[i], line.points_mm[i + 1], options.sample_mm,
           [&](const Vec3& point, double length) {
             const double least_mm = last.least_mm(point);
             if (least_mm > std::max(section.distance_mm, contact_mm)) return;
             // In contact with the triangle that was nearest a little before, a point matters only
             // if it may be nearer than all others.
             const bool touches = posterior.distance_mm(point, last.nearest.face) <= contact_mm;
             if (!touches || least_mm < section.distance_mm) {
               last = {point, posterior.nearest(point, kInfinity, last.nearest.face)};
               if (last.nearest.distance_mm < section.distance_mm) {
                 section.distance_mm = last.nearest.distance_mm;
                 section.nearest_mm = {point, last.nearest.point_mm};
               }
             }
             if (touches || last.nearest.distance_mm <= contact_mm) section.height_mm += length;
           });
  });
  section.contact = section.height_mm > 0.0;
  return section;
}

/// The line with an end at `end`, running away from it; empty if the section has no line.
SectionLine line_from(std::vector<SectionLine> lines, const Vec3& end) {
  SectionLine nearest;
  double smallest = kInfinity;
  for (SectionLine& line : lines) {
    const double first = (line.points_mm.front() - end).norm();
    const double last = (line.points_mm.back() - end).norm();
    if (std::min(first, last) >= smallest) continue;
    smallest = std::min(first, last);
    nearest = std::move(line);
    if (last < first) {
      std::reverse(nearest.points_mm.begin(), nearest.points_mm.end());
      std::reverse(nearest.faces.begin(), nearest.faces.end());
    }
  }
  return nearest;
}

double length_of(const std::vector<Vec3>& line_mm) {
  double length = 0.0;
  for (std::size_t i = 1; i < line_mm.size(); ++i) length += (line_mm[i] - line_mm[i - 1]).norm();
  return length;
}

/// Coordinates in the section: `along` the annular line, `down` towards the ventricle.
struct SectionAxes {
  Vec3 origin_mm, along, down;
  Vec2 operator()(const Vec3& point) const {
    return {(point - origin_mm).dot(along), (point - origin_mm).dot(down)};
  }
};

/// One side of the section from the annulus down to where it touches the other, or to its free
/// edge.
struct Flank {
  std::vector<Vec3> points_mm;
  bool contact = false;
};

Flank flank(const SectionLine& line, const std::vector<Leaflet>& sides, Leaflet side,
            const SurfaceTree& other, const SectionAxes& axes, const CoaptationOptions& options) {
  Flank flank;
  std::size_t pieces = line.faces.size();
  Vec3 touching = Vec3::Zero();
  double depth = kInfinity;
  for (std::size_t i = 0; i < line.faces.size(); ++i) {
    if (sides[line.faces[i]] != side) continue;
    sample(line.points_mm[i], line.points_mm[i + 1], options.sample_mm,
           [&](const Vec3& point, double) {
             if (axes(point).y() >= depth ||
                 other.nearest(point, 2.0 * options.contact_distance_mm).distance_mm >
                     options.contact_distance_mm)
               return;
             depth = axes(point).y();
             touching = point;
             pieces = i;
             flank.contact = true;
           });
  }
  flank.points_mm.assign(line.points_mm.begin(),
                         line.points_mm.begin() + std::min(pieces + 1, line.points_mm.size()));
  if (flank.contact) flank.points_mm.push_back(touching);
  return flank;
}

}  // namespace

std::vector<CoaptationSection> coaptation_sections(const Valve& valve, const Points& closed_mm,
                                                   const std::vector<double>& along,
                                                   const CoaptationOptions& asked) {
  const CoaptationOptions options = with_contact_distance(asked, valve);
  const std::vector<Leaflet> sides = leaflet_sides(valve);
  const SurfaceTree posterior = surface_of(valve, closed_mm, sides, Leaflet::Posterior);
  std::vector<CoaptationSection> sections;
  for (const double place : along) {
    const SectionPlane plane = coaptation_plane(valve, place);
    const std::vector<SectionLine> lines = cut(valve.faces, closed_mm, plane);
    CoaptationSection section = measure_section(lines, sides, posterior, options);
    section.along = place;
    sections.push_back(section);
  }
  return sections;
}

std::vector<CoaptationSection> fine_coaptation_sections(const Valve& valve,
                                                        const Points& closed_mm) {
  constexpr int kSections = 37;
  constexpr double kFirst = 0.05, kStep = 0.025;
  std::vector<double> along;
  for (int i = 0; i < kSections; ++i) along.push_back(kFirst + kStep * i);
  return coaptation_sections(valve, closed_mm, along);
}

Coaptation measure_coaptation(const Valve& valve, const Points& closed_mm,
                              const CoaptationOptions& options) {
  Coaptation coaptation;
  const auto count = coaptation.sections.size();
  std::vector<double> along, heights;
  for (std::size_t i = 0; i < count; ++i) along.push_back(0.1 * static_cast<double>(i + 1));
  const std::vector<CoaptationSection> sections =
      coaptation_sections(valve, closed_mm, along, options);
  for (std::size_t i = 0; i < count; ++i) {
    const CoaptationSection& section = coaptation.sections[i] = sections[i];
    heights.push_back(section.height_mm);
    coaptation.height_mean_mm += section.height_mm / static_cast<double>(count);
    coaptation.distance_max_mm = std::max(coaptation.distance_max_mm, section.distance_mm);
  }
  coaptation.height_min_mm = quantile(heights, 0.0);
  coaptation.height_p10_mm = quantile(heights, 0.1);
  return coaptation;
}

Tenting measure_tenting(const Valve& valve, const Points& closed_mm,
                        const CoaptationOptions& asked) {
  const CoaptationOptions options = with_contact_distance(asked, valve);
  const std::vector<Leaflet> sides = leaflet_sides(valve);
  const Vec3 saddle_peak = annulus_position_mm(valve, valve.landmarks.saddle_peak);
  const Vec3 mid_posterior = annulus_position_mm(valve, valve.landmarks.mid_posterior);
  const SectionPlane plane = mid_valve_plane(valve);
  const Vec3 along = (mid_posterior - saddle_peak).normalized();
  const SectionAxes axes{saddle_peak, along, plane.normal.cross(along)};

  const std::vector<SectionLine> lines = cut(valve.faces, closed_mm, plane);
  const Flank anterior =
      flank(line_from(lines, saddle_peak), sides, Leaflet::Anterior,
            surface_of(valve, closed_mm, sides, Leaflet::Posterior), axes, options);
  const Flank posterior =
      flank(line_from(lines, mid_posterior), sides, Leaflet::Posterior,
            surface_of(valve, closed_mm, sides, Leaflet::Anterior), axes, options);
  Tenting tenting;
  if (anterior.points_mm.empty() || posterior.points_mm.empty()) return tenting;

  const Vec3& anterior_end = anterior.points_mm.back();
  const Vec3& posterior_end = posterior.points_mm.back();
  tenting.contact = anterior.contact && posterior.contact;
  tenting.coaptation_point_mm = tenting.contact ? Vec3(0.5 * (anterior_end + posterior_end))
                                : axes(anterior_end).y() < axes(posterior_end).y() ? anterior_end
                                                                                   : posterior_end;
  tenting.height_mm = axes(tenting.coaptation_point_mm).y();
  tenting.anterior_mm = length_of(anterior.points_mm);
  tenting.posterior_mm = length_of(posterior.points_mm);

  std::vector<Vec2> outline{axes(saddle_peak)};
  for (const Vec3& point : anterior.points_mm) outline.push_back(axes(point));
  for (auto point = posterior.points_mm.rbegin(); point != posterior.points_mm.rend(); ++point)
    outline.push_back(axes(*point));
  outline.push_back(axes(mid_posterior));
  tenting.area_mm2 = -polygon_area(outline);
  return tenting;
}

}  // namespace coapt
