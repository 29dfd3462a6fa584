#include "core/valve/annulus_frame.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include "core/valve/mean_point.h"

namespace coapt {

AnnulusFrame annulus_frame(const Valve& valve) {
  AnnulusFrame frame;
  frame.origin_mm = mean_point(valve.annulus_mm);
  const Points centred = valve.annulus_mm.rowwise() - frame.origin_mm.transpose();
  const Eigen::Matrix3d scatter = centred.transpose() * centred;
  frame.normal = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(scatter).eigenvectors().col(0);
  Vec3 area = Vec3::Zero();
  for (Index i = 0; i < centred.rows(); ++i) {
    const Vec3 here = centred.row(i), next = centred.row((i + 1) % centred.rows());
    area += here.cross(next);
  }
  if (frame.normal.dot(area) < 0.0) frame.normal = -frame.normal;
  const Vec3 forward = annulus_position_mm(valve, valve.landmarks.saddle_peak) -
                       annulus_position_mm(valve, valve.landmarks.mid_posterior);
  frame.anterior = (forward - frame.normal.dot(forward) * frame.normal).normalized();
  frame.transverse = frame.anterior.cross(frame.normal);
  return frame;
}

Vec3 into_frame(const AnnulusFrame& frame, const Vec3& point_mm) {
  const Vec3 offset = point_mm - frame.origin_mm;
  return {frame.transverse.dot(offset), frame.anterior.dot(offset), frame.normal.dot(offset)};
}

Vec3 out_of_frame(const AnnulusFrame& frame, const Vec3& coordinates_mm) {
  return frame.origin_mm + coordinates_mm.x() * frame.transverse +
         coordinates_mm.y() * frame.anterior + coordinates_mm.z() * frame.normal;
}

double ap_diameter_mm(const Valve& valve, const AnnulusFrame& frame) {
  return frame.anterior.dot(annulus_position_mm(valve, valve.landmarks.saddle_peak) -
                            annulus_position_mm(valve, valve.landmarks.mid_posterior));
}

double transverse_diameter_mm(const Valve& valve, const AnnulusFrame& frame) {
  const Eigen::VectorXd along = valve.annulus_mm * frame.transverse;
  return along.maxCoeff() - along.minCoeff();
}

}  // namespace coapt
