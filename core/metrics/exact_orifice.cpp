#include "core/metrics/exact_orifice.h"

#include <utility>

#include "core/metrics/clean_contour.h"
#include "core/metrics/edge_heights.h"
#include "core/metrics/openings.h"
#include "core/metrics/silhouette.h"

namespace coapt {
namespace {

constexpr double kCorner_mm = 0.01;  // of outlines that are drawn

Openings look(const Valve& valve, const Projection& projection, double half_thickness_mm) {
  return openings_of(projection.annulus, silhouette(valve, projection), half_thickness_mm);
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
  const Projection projection =
      project_valve(valve, closed_mm, annulus_frame(valve, AnnulusAxis::Commissures));
  const EdgeHeights edges(valve.faces, closed_mm, projection.plane);
  std::vector<OrificeOutline> outlines;
  const Openings seen = look(valve, projection, half_thickness_mm);
  if (!seen.grown) return outlines;
  for (const Opening& opening : *seen.grown) {
    if (!(opening.area_mm2 > 0.0)) continue;
    OrificeOutline outline{opening.area_mm2, {}};
    for (const std::vector<Vec2>& contour_mm : opening.contours_mm) {
      const std::vector<Vec2> corners_mm = clean_contour(contour_mm, kCorner_mm);
      if (corners_mm.empty()) continue;  // a speck
      Points& points_mm = outline.contours_mm.emplace_back(std::ssize(corners_mm), 3);
      for (std::size_t i = 0; i < corners_mm.size(); ++i) {
        const Vec3 lifted_mm = unproject(projection.plane, corners_mm[i]) +
                               edges.at(corners_mm[i]) * projection.plane.normal;
        points_mm.row(i) = lifted_mm.transpose();
      }
    }
    if (!outline.contours_mm.empty()) outlines.push_back(std::move(outline));
  }
  return outlines;
}

ExactOrifice exact_orifice(const Valve& valve, const Points& closed_mm, double half_thickness_mm) {
  return exact_orifice(
      valve, project_valve(valve, closed_mm, annulus_frame(valve, AnnulusAxis::Commissures)),
      half_thickness_mm);
}

double free_area_mm2(const std::vector<Vec2>& outline, const std::vector<std::vector<Vec2>>& tissue,
                     double half_thickness_mm) {
  return total_mm2(openings_of(outline, {{}, tissue}, half_thickness_mm).grown);
}

OrificeMeasure measure_orifice(const Valve& valve, const ClosureResult& closure) {
  const double half_thickness_mm = 0.5 * valve.tissue.thickness_mm;
  const AnnulusFrame plane = annulus_frame(valve, AnnulusAxis::Commissures);
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
