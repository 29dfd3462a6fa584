// Label maps: the first byte chooses the reader, the phase and whether labels are made into surfaces and lines, too; bits 1 and 8 together
// are for files of any kind, which may be compressed as a whole.
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "io/exchange/label_parts.h"
#include "io/image/detached.h"
#include "io/image/metaimage.h"
#include "io/image/nifti.h"
#include "io/image/nrrd.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace coapt;
  if (size == 0) return 0;
  const std::string_view text(reinterpret_cast<const char*>(bytes) + 1, size - 1);
  constexpr Index kMost = 1 << 14;
  if (const auto data = data_file_of(text); data && *data) {
    const std::string whole = attached(text, text.substr(text.size() / 2));
    if (const auto again = data_file_of(whole); again && *again) std::abort();
  }
  const int phase = bytes[0] >> 4;
  const Expected<LabelMap> map = (bytes[0] & 9) == 9   ? read_label_map(text, kMost, phase)
                                 : (bytes[0] & 8) != 0 ? read_metaimage(text, kMost, phase)
                                 : (bytes[0] & 1) != 0 ? read_nrrd(text, kMost, phase)
                                                       : read_nifti(text, kMost, phase);
  if (!map) return 0;
  const Index voxels = map->size[0] * map->size[1] * map->size[2] * map->layers;
  if (std::ssize(map->voxels) != voxels || voxels > kMost || !map->to_lps_mm.allFinite())
    std::abort();
  if ((bytes[0] & 2) == 0) return 0;
  const Expected<LabelParts> parts = label_parts(*map, {}, {.annulus = (bytes[0] & 4) != 0});
  if (!parts) return 0;
  for (const TriangleMesh& mesh : parts->leaflets)
    if (!mesh.vertices_mm.allFinite() || mesh.faces.minCoeff() < 0 ||
        mesh.faces.maxCoeff() >= mesh.vertices_mm.rows())
      std::abort();
  return 0;
}
