#include "core/metrics/annulus.h"

namespace coapt {

std::vector<Vec2> annulus_polygon(const Valve& valve, const AnnulusFrame& plane) {
  std::vector<Vec2> polygon;
  polygon.reserve(valve.annulus_mm.rows());
  for (Index i = 0; i < valve.annulus_mm.rows(); ++i)
    polygon.push_back(project(plane, valve.annulus_mm.row(i).transpose()));
  return polygon;
}

double polygon_area(const std::vector<Vec2>& polygon) {
  double twice_area = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2& here = polygon[i];
    const Vec2& next = polygon[(i + 1) % polygon.size()];
    twice_area += here.x() * next.y() - next.x() * here.y();
  }
  return 0.5 * twice_area;
}

AnnulusMeasure measure_annulus(const Valve& valve) {
  const AnnulusFrame plane = annulus_frame(valve, AnnulusAxis::Commissures);
  const Points& loop = valve.annulus_mm;
  const auto extent_mm = [&loop](const Vec3& direction) {
    const Eigen::VectorXd along = loop * direction;
    return along.maxCoeff() - along.minCoeff();
  };
  AnnulusMeasure measure;
  const bool mitral = is_mitral(valve);
  measure.ap_mm = mitral ? ap_diameter_mm(valve) : extent_mm(plane.y);
  measure.al_pm_mm = mitral ? transverse_diameter_mm(valve) : extent_mm(plane.x);
  measure.saddle_height_mm = extent_mm(plane.normal);
  measure.area_mm2 = polygon_area(annulus_polygon(valve, plane));
  for (Index i = 0; i < loop.rows(); ++i)
    measure.circumference_mm += (loop.row((i + 1) % loop.rows()) - loop.row(i)).norm();
  return measure;
}

}  // namespace coapt
