#include "io/image/label_map.h"

#include "io/image/metaimage.h"
#include "io/image/nifti.h"
#include "io/image/nrrd.h"
#include "io/image/voxel_stream.h"

namespace coapt {
namespace {

bool is_nrrd(std::string_view bytes) { return bytes.starts_with("NRRD"); }

bool is_metaimage(std::string_view bytes) {
  return bytes.starts_with("ObjectType") || bytes.starts_with("NDims");
}

/// Of a file that is compressed as a whole the first bytes; else the file.
std::string_view beginning_of(std::string_view bytes, Packing packing, std::array<char, 10>& room) {
  if (packing == Packing::None) return bytes;
  ByteStream stream(bytes, packing);
  return stream.read(room.data(), room.size()) ? std::string_view(room.data(), room.size())
                                               : std::string_view();
}

}  // namespace

bool is_label_map_format(std::string_view format) {
  return format == "nrrd" || format == "nhdr" || format == "nii" || format == "gz" ||
         format == "bz2" || format == "mha" || format == "mhd";
}

Expected<LabelMap> read_label_map(std::string_view bytes, Index most_voxels, int phase) {
  const Packing packing = packing_of(bytes);
  std::array<char, 10> room{};
  const std::string_view beginning = beginning_of(bytes, packing, room);
  if (!is_nrrd(beginning) && !is_metaimage(beginning)) return read_nifti(bytes, most_voxels, phase);
  Expected<std::string> unpacked = std::string();
  if (packing != Packing::None) {
    unpacked = unpack(bytes, packing, most_map_bytes(most_voxels));
    if (!unpacked) return unpacked.errors();
    bytes = *unpacked;
  }
  return is_nrrd(bytes) ? read_nrrd(bytes, most_voxels, phase)
                        : read_metaimage(bytes, most_voxels, phase);
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
