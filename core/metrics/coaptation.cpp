#include "core/metrics/coaptation.h"

#include <Eigen/Geometry>
#include <limits>

#include "core/metrics/quantile.h"
#include "core/metrics/surface.h"
#include "core/valve/leaflet_of.h"

namespace coapt {
namespace {

CoaptationOptions with_contact_distance(CoaptationOptions options, const Valve& valve) {
  if (options.contact_distance_mm == 0.0)
    options.contact_distance_mm = 1.25 * valve.tissue.thickness_mm;
  return options;
}

constexpr double kInfinity = std::numeric_limits<double>::infinity();

Surface surface_of(const Valve& valve, const Points& closed_mm, const std::vector<Leaflet>& sides,
                   Leaflet side) {
  Surface surface;
  for (Index f = 0; f < valve.faces.rows(); ++f)
    if (sides[f] == side)
      add_triangle(surface, {closed_mm.row(valve.faces(f, 0)), closed_mm.row(valve.faces(f, 1)),
                             closed_mm.row(valve.faces(f, 2))});
  return surface;
}

/// The triangles that may have a point within `reach_mm` of the plane.
Surface near_plane(const Surface& surface, const SectionPlane& plane, double reach_mm) {
  Surface near;
  for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
    const double height_mm = (surface.centres[i] - plane.point_mm).dot(plane.normal);
    if (std::abs(height_mm) <= reach_mm + surface.radii[i])
      add_triangle(near, surface.triangles[i]);
  }
  return near;
}

/// One piece of a cut, in equal parts no longer than `sample_mm`; `visit(middle, length)` for each.
template <class Visit>
void sample(const Vec3& from, const Vec3& to, double sample_mm, const Visit& visit) {
  const double length = (to - from).norm();
  const int parts = std::max(1, static_cast<int>(std::ceil(std::min(length / sample_mm, 1e4))));
  for (int i = 0; i < parts; ++i) visit(from + (i + 0.5) / parts * (to - from), length / parts);
}

/// Distances of `limit_mm` and more count as that.
CoaptationSection measure_section(const std::vector<SectionLine>& lines,
                                  const std::vector<Leaflet>& sides, const Surface& posterior,
                                  const CoaptationOptions& options, double limit_mm) {
  CoaptationSection section;
  section.distance_mm = limit_mm;
  // Between two points the distance changes by no more than the way from one to the other: near a
  // point that is far off, nothing needs to be measured.
  Vec3 measured_at = Vec3::Zero();
  double measured = 0.0;
  for (const SectionLine& line : lines)
    for (std::size_t i = 0; i < line.faces.size(); ++i) {
      if (sides[line.faces[i]] != Leaflet::Anterior) continue;
      sample(line.points_mm[i], line.points_mm[i + 1], options.sample_mm,
             [&](const Vec3& point, double length) {
               const double matters = std::max(section.distance_mm, options.contact_distance_mm);
               if (measured - (point - measured_at).norm() > matters) return;
               measured = distance_within(posterior, point, std::min(limit_mm, 2.0 * matters));
               measured_at = point;
               if (measured < section.distance_mm) {
                 section.distance_mm = measured;
                 section.nearest_mm[0] = point;
               }
               if (measured <= options.contact_distance_mm) section.height_mm += length;
             });
    }
  section.contact = section.height_mm > 0.0;
  if (section.distance_mm < limit_mm)
    section.nearest_mm[1] = nearest_point(posterior, section.nearest_mm[0]);
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
            const Surface& other, const SectionAxes& axes, const CoaptationOptions& options) {
  Flank flank;
  std::size_t pieces = line.faces.size();
  Vec3 touching = Vec3::Zero();
  double depth = kInfinity;
  for (std::size_t i = 0; i < line.faces.size(); ++i) {
    if (sides[line.faces[i]] != side) continue;
    sample(line.points_mm[i], line.points_mm[i + 1], options.sample_mm,
           [&](const Vec3& point, double) {
             if (axes(point).y() >= depth ||
                 distance_within(other, point, 2.0 * options.contact_distance_mm) >
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

std::vector<Leaflet> leaflet_sides(const Valve& valve) {
  const Vec3 from = valve.rest_mm.row(valve.landmarks.anterolateral_commissure).transpose();
  const Vec3 to = valve.rest_mm.row(valve.landmarks.posteromedial_commissure).transpose();
  const Vec3 anterior = annular_plane(valve).normal.cross(to - from);
  std::vector<Leaflet> sides;
  sides.reserve(valve.segments.size());
  for (std::size_t f = 0; f < valve.segments.size(); ++f) {
    if (const std::optional<Leaflet> leaflet = leaflet_of(valve.segments[f])) {
      sides.push_back(*leaflet);
      continue;
    }
    Vec3 centre = Vec3::Zero();
    for (int k = 0; k < 3; ++k) centre += valve.rest_mm.row(valve.faces(f, k)).transpose() / 3.0;
    sides.push_back((centre - from).dot(anterior) > 0.0 ? Leaflet::Anterior : Leaflet::Posterior);
  }
  return sides;
}

std::vector<CoaptationSection> coaptation_sections(const Valve& valve, const Points& closed_mm,
                                                   const std::vector<double>& along,
                                                   const CoaptationOptions& asked) {
  const CoaptationOptions options = with_contact_distance(asked, valve);
  const std::vector<Leaflet> sides = leaflet_sides(valve);
  const Surface posterior = surface_of(valve, closed_mm, sides, Leaflet::Posterior);
  std::vector<CoaptationSection> sections;
  for (const double place : along) {
    const SectionPlane plane = coaptation_plane(valve, place);
    const std::vector<SectionLine> lines = cut(valve.faces, closed_mm, plane);
    // Most sections touch, and then the triangles beside the plane are enough.
    const double reach_mm = 2.0 * options.contact_distance_mm;
    CoaptationSection section =
        measure_section(lines, sides, near_plane(posterior, plane, reach_mm), options, reach_mm);
    if (section.distance_mm >= reach_mm)
      section = measure_section(lines, sides, posterior, options, kInfinity);
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
  const double spacing_mm =
      (coaptation_plane(valve, along[1]).point_mm - coaptation_plane(valve, along[0]).point_mm)
          .norm();
  for (std::size_t i = 0; i < count; ++i) {
    const CoaptationSection& section = coaptation.sections[i] = sections[i];
    heights.push_back(section.height_mm);
    coaptation.height_mean_mm += section.height_mm / static_cast<double>(count);
    coaptation.distance_max_mm = std::max(coaptation.distance_max_mm, section.distance_mm);
    if (!section.contact)
      coaptation.gap_area_mm2 +=
          spacing_mm * std::max(0.0, section.distance_mm - valve.tissue.thickness_mm);
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

  std::vector<Vec2> outline{axes(saddle_peak)};
  for (const Vec3& point : anterior.points_mm) outline.push_back(axes(point));
  for (auto point = posterior.points_mm.rbegin(); point != posterior.points_mm.rend(); ++point)
    outline.push_back(axes(*point));
  outline.push_back(axes(mid_posterior));
  tenting.area_mm2 = -polygon_area(outline);
  return tenting;
}

}  // namespace coapt
