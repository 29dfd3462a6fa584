// Where the voxels of an image lie, apart from what they hold.
#pragma once

#include <optional>
#include <string>

#include "core/valve/problem_list.h"
#include "io/image/label_map.h"

namespace coapt {

/// The size of a voxel that images of a heart have.
inline constexpr Range kVoxelMm = {0.01, 20.0};

struct ImageGeometry {
  std::array<Index, 3> size = {0, 0, 0};                    ///< voxels along i, j, k
  Eigen::Matrix4d to_lps_mm = Eigen::Matrix4d::Identity();  ///< of the centre of voxel (i, j, k, 1)
  bool placed =
      false;  ///< false: only the voxels' size is known (3-D echo without the patient's orientation)

  double voxels() const {
    return static_cast<double>(size[0]) * static_cast<double>(size[1]) *
           static_cast<double>(size[2]);
  }
};

/// Problems at `path` where a voxel has no volume, or another size than kVoxelMm, or lies beyond 1e5 mm.
void check_voxel_steps(const Eigen::Matrix4d& to_lps_mm, const std::string& path,
                       ProblemList& problems);

/// The largest angle that two axes of a voxel lack to a right one; none where all are square, or one has no length.
std::optional<double> off_a_right_angle_deg(const Eigen::Matrix3d& steps_mm);

/// A map takes the geometry of the image that it was drawn on, if it has none of its own. The answer says in words what was
/// taken, or by how much the two differ. Errors: sizes that are not those of the image; frames more than a voxel apart.
Expected<std::string> place(LabelMap& map, const ImageGeometry& image);

}  // namespace coapt
