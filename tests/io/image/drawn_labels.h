// Label maps drawn by a rule, for tests.
#pragma once

#include <functional>

#include "io/image/label_map.h"

namespace coapt {

/// Label 1 where `inside` says so of the voxel's centre, in LPS mm.
inline LabelMap drawn_labels(std::array<Index, 3> size, const Eigen::Matrix4d& to_lps_mm,
                             const std::function<bool(const Vec3&)>& inside) {
  LabelMap map;
  map.size = size;
  map.to_lps_mm = to_lps_mm;
  map.placed = true;
  for (Index k = 0; k < size[2]; ++k)
    for (Index j = 0; j < size[1]; ++j)
      for (Index i = 0; i < size[0]; ++i)
        map.voxels.push_back(inside(map.centre_mm(static_cast<double>(i), static_cast<double>(j),
                                                  static_cast<double>(k)))
                                 ? 1
                                 : 0);
  return map;
}

/// Voxels of these edges about the middle of the image, in turned axes, the first one reversed if `mirrored`.
inline Eigen::Matrix4d oblique_frame(std::array<Index, 3> size, const Vec3& edges_mm,
                                     bool mirrored) {
  Eigen::Matrix3d axes =
      (Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()) * Eigen::AngleAxisd(-0.4, Vec3::UnitY()))
          .toRotationMatrix();
  if (mirrored) axes.col(0) *= -1.0;
  Eigen::Matrix4d frame = Eigen::Matrix4d::Identity();
  frame.topLeftCorner<3, 3>() = axes * edges_mm.asDiagonal();
  const Vec3 middle = 0.5 * Vec3(static_cast<double>(size[0] - 1), static_cast<double>(size[1] - 1),
                                 static_cast<double>(size[2] - 1));
  frame.topRightCorner<3, 1>() = Vec3(20, -30, 400) - frame.topLeftCorner<3, 3>() * middle;
  return frame;
}

inline const Vec3 kObliqueMiddle_mm(20, -30, 400);

}  // namespace coapt
