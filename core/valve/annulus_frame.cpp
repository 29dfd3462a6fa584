#include "core/valve/annulus_frame.h"

#include <Eigen/Geometry>

#include "core/valve/mean_point.h"
#include "core/valve/principal_axes.h"

namespace coapt {
namespace {

/// Its part within the plane, of length 1.
Vec3 within_plane(const Vec3& normal, const Vec3& way) {
  return (way - normal * normal.dot(way)).normalized();
}

Vec3 between_mm(const Valve& valve, int from, int to) {
  return annulus_position_mm(valve, to) - annulus_position_mm(valve, from);
}

}  // namespace

AnnulusFrame annulus_frame(const Valve& valve, AnnulusAxis axis) {
  AnnulusFrame frame;
  frame.origin_mm = mean_point(valve.annulus_mm);
  const Points centred = valve.annulus_mm.rowwise() - frame.origin_mm.transpose();
  frame.normal = principal_axes(centred).col(0);
  Vec3 twice_area = Vec3::Zero();
  for (Index i = 0; i < centred.rows(); ++i) {
    const Vec3 here = centred.row(i), next = centred.row((i + 1) % centred.rows());
    twice_area += here.cross(next);
  }
  if (frame.normal.dot(twice_area) < 0.0) frame.normal = -frame.normal;

  const Landmarks& marks = valve.landmarks;
  switch (axis) {
    case AnnulusAxis::Commissures:
      frame.x = within_plane(frame.normal, is_mitral(valve)
                                               ? between_mm(valve, marks.anterolateral_commissure,
                                                            marks.posteromedial_commissure)
                                               : Vec3(Vec3::UnitX()));
      frame.y = frame.normal.cross(frame.x);
      break;
    case AnnulusAxis::SaddlePeak:
      frame.y =
          within_plane(frame.normal, between_mm(valve, marks.mid_posterior, marks.saddle_peak));
      frame.x = frame.y.cross(frame.normal);
      break;
  }
  return frame;
}

Vec3 into_frame(const AnnulusFrame& frame, const Vec3& point_mm) {
  const Vec3 offset = point_mm - frame.origin_mm;
  return {frame.x.dot(offset), frame.y.dot(offset), frame.normal.dot(offset)};
}

Vec3 out_of_frame(const AnnulusFrame& frame, const Vec3& coordinates_mm) {
  return frame.origin_mm + coordinates_mm.x() * frame.x + coordinates_mm.y() * frame.y +
         coordinates_mm.z() * frame.normal;
}

Vec2 project(const AnnulusFrame& frame, const Vec3& point_mm) {
  const Vec3 offset = point_mm - frame.origin_mm;
  return {frame.x.dot(offset), frame.y.dot(offset)};
}

Vec3 unproject(const AnnulusFrame& frame, const Vec2& coordinates_mm) {
  return frame.origin_mm + coordinates_mm.x() * frame.x + coordinates_mm.y() * frame.y;
}

double ap_diameter_mm(const Valve& valve) {
  return annulus_frame(valve, AnnulusAxis::SaddlePeak)
      .y.dot(between_mm(valve, valve.landmarks.mid_posterior, valve.landmarks.saddle_peak));
}

double transverse_diameter_mm(const Valve& valve) {
  const Eigen::VectorXd along = valve.annulus_mm * annulus_frame(valve, AnnulusAxis::SaddlePeak).x;
  return along.maxCoeff() - along.minCoeff();
}

}  // namespace coapt
