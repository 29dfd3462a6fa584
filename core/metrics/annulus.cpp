#include "core/metrics/annulus.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include "core/valve/mean_point.h"

namespace coapt {

AnnularPlane annular_plane(const Valve& valve) {
  AnnularPlane plane;
  const Points& loop = valve.annulus_mm;
  plane.origin_mm = mean_point(loop);
  const Points centred = loop.rowwise() - plane.origin_mm.transpose();
  const Eigen::Matrix3d scatter = centred.transpose() * centred;
  plane.normal = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(scatter).eigenvectors().col(0);

  Vec3 twice_area = Vec3::Zero();
  for (Index i = 0; i < loop.rows(); ++i) {
    const Vec3 here = centred.row(i).transpose();
    const Vec3 next = centred.row((i + 1) % loop.rows()).transpose();
    twice_area += here.cross(next);
  }
  if (plane.normal.dot(twice_area) < 0.0) plane.normal = -plane.normal;

  const Vec3 across =
      is_mitral(valve) ? Vec3(annulus_position_mm(valve, valve.landmarks.posteromedial_commissure) -
                              annulus_position_mm(valve, valve.landmarks.anterolateral_commissure))
                       : Vec3(Vec3::UnitX());
  plane.x = (across - plane.normal * plane.normal.dot(across)).normalized();
  plane.y = plane.normal.cross(plane.x);
  return plane;
}

Vec2 project(const AnnularPlane& plane, const Vec3& point_mm) {
  const Vec3 offset = point_mm - plane.origin_mm;
  return {offset.dot(plane.x), offset.dot(plane.y)};
}

Vec3 unproject(const AnnularPlane& plane, const Vec2& coordinates_mm) {
  return plane.origin_mm + coordinates_mm.x() * plane.x + coordinates_mm.y() * plane.y;
}

std::vector<Vec2> annulus_polygon(const Valve& valve, const AnnularPlane& plane) {
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
  const AnnularPlane plane = annular_plane(valve);
  const Points& loop = valve.annulus_mm;
  const auto extent_mm = [&loop](const Vec3& direction) {
    const Eigen::VectorXd along = loop * direction;
    return along.maxCoeff() - along.minCoeff();
  };
  AnnulusMeasure measure;
  if (is_mitral(valve)) {
    const Vec2 saddle_peak =
        project(plane, annulus_position_mm(valve, valve.landmarks.saddle_peak));
    const Vec2 mid_posterior =
        project(plane, annulus_position_mm(valve, valve.landmarks.mid_posterior));
    measure.ap_mm = (saddle_peak - mid_posterior).norm();
  } else {
    measure.ap_mm = extent_mm(plane.y);
  }
  measure.al_pm_mm = extent_mm(plane.x);
  measure.saddle_height_mm = extent_mm(plane.normal);
  measure.area_mm2 = polygon_area(annulus_polygon(valve, plane));
  for (Index i = 0; i < loop.rows(); ++i)
    measure.circumference_mm += (loop.row((i + 1) % loop.rows()) - loop.row(i)).norm();
  return measure;
}

}  // namespace coapt
