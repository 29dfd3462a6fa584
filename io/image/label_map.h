// Label maps: images whose voxels say which part of the anatomy they are of, as segmentation tools write them (NRRD,
// NIfTI, MetaImage). The readers are our own: the service is sent such files by strangers and has them in memory, where libraries of
// either format open files by name, follow references to others, or end the program; and of both formats a label map
// needs little.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/valve/types.h"

namespace coapt {

/// A label that the file gives a name. Names may be a person's: they choose a label and are shown to nobody.
struct LabelName {
  int layer = 0, value = 0;
  std::string name;
};

struct LabelMap {
  std::array<Index, 3> size = {0, 0, 0};  ///< voxels along i, j, k
  int layers = 1;                         ///< labels of different layers may overlap
  int phase = 1, phases = 1;  ///< of a file of several states of the heart: which it is, from 1
  std::vector<std::uint16_t> voxels;  ///< ((layer * size[2] + k) * size[1] + j) * size[0] + i
  Eigen::Matrix4d to_lps_mm = Eigen::Matrix4d::Identity();  ///< of the centre of voxel (i, j, k, 1)
  bool placed = false;  ///< false: the file tells the voxels' size, not where the patient is
  std::vector<LabelName> names;
  std::string
      frame_doubt;  ///< where the file says two things of where its voxels are: which was taken; else empty
  /// Of a file of one mask for each label: how many, the background's among them; else 0.
  int masks = 0;

  Vec3 centre_mm(double i, double j, double k) const {
    return (to_lps_mm * Eigen::Vector4d(i, j, k, 1.0)).head<3>();
  }
};

/// A label of a map.
struct LabelAt {
  int layer = 0, value = 1;  ///< value from 1
};

/// Of all layers together, 512 x 512 x 512; 256 MiB in memory.
inline constexpr Index kMostVoxels = Index{1} << 27;
/// Of what a service is sent: 128 MiB in memory, a CT of 512 x 512 x 256.
inline constexpr Index kMostVoxelsSent = Index{1} << 26;
/// Bytes of a file of a map, unpacked: so many voxels of the widest type behind the longest header (NIfTI's, with extensions).
constexpr std::size_t most_map_bytes(Index most_voxels) {
  return static_cast<std::size_t>(most_voxels) * 8 + (std::size_t{16} << 20);
}

/// Of one file.
inline constexpr int kMostPhases = 1000;

/// Whether a format_of() file name extension ("nrrd", "nhdr", "nii", "gz", "bz2", "mha", "mhd") may be one of these.
bool is_label_map_format(std::string_view format);

/// Any of them, by its first bytes; compressed as a whole by gzip or bzip2, too. @param phase from 1; 0: the first that has labels. Errors at "/phase": there are not so many.
Expected<LabelMap> read_label_map(std::string_view bytes, Index most_voxels = kMostVoxels,
                                  int phase = 0);

/// All that are there but 0, by layer and value.
std::vector<LabelAt> labels_of(const LabelMap& map);

}  // namespace coapt
