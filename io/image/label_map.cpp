#include "io/image/label_map.h"

#include "io/image/metaimage.h"
#include "io/image/nifti.h"
#include "io/image/nrrd.h"

namespace coapt {

bool is_label_map_format(std::string_view format) {
  return format == "nrrd" || format == "nhdr" || format == "nii" || format == "gz" ||
         format == "mha" || format == "mhd";
}

Expected<LabelMap> read_label_map(std::string_view bytes, Index most_voxels, int phase) {
  if (bytes.starts_with("NRRD")) return read_nrrd(bytes, most_voxels, phase);
  if (bytes.starts_with("ObjectType") || bytes.starts_with("NDims"))
    return read_metaimage(bytes, most_voxels, phase);
  return read_nifti(bytes, most_voxels, phase);
}

std::vector<LabelAt> labels_of(const LabelMap& map) {
  std::vector<LabelAt> found;
  const std::size_t volume = map.voxels.size() / static_cast<std::size_t>(map.layers);
  for (int layer = 0; layer < map.layers; ++layer) {
    std::vector<bool> there(65536, false);
    for (std::size_t i = 0; i < volume; ++i)
      there[map.voxels[static_cast<std::size_t>(layer) * volume + i]] = true;
    for (int value = 1; value < 65536; ++value)
      if (there[static_cast<std::size_t>(value)]) found.push_back({layer, value});
  }
  return found;
}

}  // namespace coapt
