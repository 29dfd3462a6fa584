// Label maps: the first byte chooses the reader and whether labels are made into surfaces and lines, too.
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "io/exchange/label_parts.h"
#include "io/image/nifti.h"
#include "io/image/nrrd.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace coapt;
  if (size == 0) return 0;
  const std::string_view text(reinterpret_cast<const char*>(bytes) + 1, size - 1);
  constexpr Index kMost = 1 << 14;
  const Expected<LabelMap> map =
      (bytes[0] & 1) != 0 ? read_nrrd(text, kMost) : read_nifti(text, kMost);
  if (!map) return 0;
  const Index voxels = map->size[0] * map->size[1] * map->size[2] * map->layers;
  if (std::ssize(map->voxels) != voxels || voxels > kMost || !map->to_lps_mm.allFinite())
    std::abort();
  if ((bytes[0] & 2) == 0) return 0;
  const Expected<LabelParts> parts = label_parts(*map, {}, (bytes[0] & 4) != 0);
  if (!parts) return 0;
  for (const TriangleMesh& mesh : parts->leaflets)
    if (!mesh.vertices_mm.allFinite() || mesh.faces.minCoeff() < 0 ||
        mesh.faces.maxCoeff() >= mesh.vertices_mm.rows())
      std::abort();
  return 0;
}
