#include "io/image/image_geometry.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/valve/number_text.h"

namespace coapt {
namespace {

constexpr double kFarMm = 1e5;         // as coordinates of meshes (io/mesh/mesh_builder.h)
constexpr double kLeastVolume = 1e-3;  // of a voxel over the product of its edges

std::string words_of(const std::array<Index, 3>& size) {
  return std::to_string(size[0]) + " x " + std::to_string(size[1]) + " x " +
         std::to_string(size[2]);
}

/// The longest way between where two frames put a corner of the image, whichever way either counts its voxels.
double apart_mm(const LabelMap& map, const ImageGeometry& image) {
  const auto corner_of = [&](int corner) {
    Eigen::Vector4d at(0.0, 0.0, 0.0, 1.0);
    for (int axis = 0; axis < 3; ++axis)
      if ((corner >> axis & 1) != 0)
        at[axis] = static_cast<double>(map.size[static_cast<std::size_t>(axis)] - 1);
    return at;
  };
  double least = 1e300;
  for (int reversed = 0; reversed < 8; ++reversed) {
    double most = 0.0;
    for (int corner = 0; corner < 8; ++corner)
      most = std::max(
          most, (map.to_lps_mm * corner_of(corner) - image.to_lps_mm * corner_of(corner ^ reversed))
                    .norm());
    least = std::min(least, most);
  }
  return least;
}

Vec3 edges(const Eigen::Matrix4d& frame) { return frame.topLeftCorner<3, 3>().colwise().norm(); }

}  // namespace

void check_voxel_steps(const Eigen::Matrix4d& to_lps_mm, const std::string& path,
                       ProblemList& problems) {
  const Vec3 edge = edges(to_lps_mm);
  for (Index axis = 0; axis < 3; ++axis)
    if (!check_range(problems, path + '/' + std::to_string(axis), edge[axis], kVoxelMm, " mm"))
      return;
  const double volume = std::abs(to_lps_mm.topLeftCorner<3, 3>().determinant());
  if (!(volume >= kLeastVolume * edge.prod()))
    problems.add(ErrorCode::BadGeometry, path, "must lead in three different directions");
  if (!to_lps_mm.allFinite() || to_lps_mm.col(3).cwiseAbs().maxCoeff() > kFarMm)
    problems.add(ErrorCode::OutOfRange, path, "must come with an origin within 1e5 mm");
}

std::optional<double> off_a_right_angle_deg(const Eigen::Matrix3d& steps_mm) {
  constexpr double kSquare = 0.01;  // cosine
  const Vec3 lengths = steps_mm.colwise().norm();
  if (!(lengths.minCoeff() > 0.0)) return std::nullopt;
  const Eigen::Matrix3d axes = steps_mm * lengths.cwiseInverse().asDiagonal();
  const double most = (axes.transpose() * axes - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff();
  if (most <= kSquare) return std::nullopt;
  return std::asin(std::min(1.0, most)) * 180.0 / std::numbers::pi;
}

Expected<std::string> place(LabelMap& map, const ImageGeometry& image) {
  if (map.size != image.size)
    return Error{ErrorCode::BadReference, "/series",
                 "has " + words_of(image.size) + " voxels, the label map " + words_of(map.size) +
                     "; must be the segmented images"};
  const Vec3 own = edges(map.to_lps_mm), theirs = edges(image.to_lps_mm);
  const std::string spacing = significant(theirs[0], 4) + " x " + significant(theirs[1], 4) +
                              " x " + significant(theirs[2], 4) + " mm";
  if (map.placed && image.placed) {
    const double apart = apart_mm(map, image);
    if (apart > theirs.maxCoeff())
      return Error{ErrorCode::BadGeometry, "/series",
                   "puts a corner of the label map " + significant(apart, 3) +
                       " mm from its position in the label map; must be within a voxel"};
    return "taken from the label map, which differs from the series by " + significant(apart, 3) +
           " mm at most";
  }
  if (map.placed) {
    return "taken from the label map; the series has voxels of " + spacing + ", which differ by " +
           significant((own - theirs).cwiseAbs().maxCoeff(), 3) +
           " mm, and does not state patient axes";
  }
  map.to_lps_mm = image.to_lps_mm;
  map.placed = image.placed;
  return "voxels of " + spacing +
         (image.placed ? ", origin and directions from the series, because the label map has none"
                       : "; neither the series nor the label map states patient axes");
}

}  // namespace coapt
