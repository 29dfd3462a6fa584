// Mesh, chordae and markups files, lines, parts of meshes, tables and multi-blocks: the first byte chooses the reader.
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "io/exchange/companion_files.h"
#include "io/exchange/import_files.h"
#include "io/exchange/markups.h"
#include "io/exchange/mesh_leaflets.h"
#include "io/mesh/import_readers.h"
#include "io/mesh/vtu.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace coapt;
  if (size == 0) return 0;
  const std::string_view text(reinterpret_cast<const char*>(bytes) + 1, size - 1);
  const auto all = [](std::string_view) { return true; };
  constexpr std::string_view kMeshes[] = {"obj", "ply", "stl", "vtk"};
  switch (bytes[0] % 16) {
    case 4:
      (void)read_chordae(text, "csv");
      return 0;
    case 5:
      (void)read_chordae(text, "json");
      return 0;
    case 6:
      (void)read_points_csv(text);
      return 0;
    case 7:
      (void)read_markups(text);
      return 0;
    case 8:
      (void)read_vtu(text, all);
      return 0;
    case 9:
      (void)read_vtp(text, all);
      return 0;
    case 10:
      (void)companions_of({"m.vtm", std::string(text)});
      return 0;
    case 11:
      (void)stated_unit(text);
      if (const auto loop = read_closed_loop(text, "csv"); loop && !loop->allFinite()) std::abort();
      return 0;
    case 12:
      if (const auto parts = read_mesh_parts(text, "obj", kMostUnpackedSent))
        (void)leaflets_of(*parts, {{1}, {2}, {}});
      return 0;
    case 13:
      if (const auto parts = read_mesh_parts(text, "vtk", kMostUnpackedSent))
        (void)leaflets_of(*parts);
      return 0;
    case 14:
      (void)read_closed_loop(text, "vtp");
      return 0;
    case 15:
      (void)read_closed_loop(text, "json");
      return 0;
    default:
      break;
  }
  const auto mesh = read_mesh(text, kMeshes[bytes[0] % 16]);
  if (!mesh) return 0;
  const bool indices =
      mesh->faces.minCoeff() >= 0 && mesh->faces.maxCoeff() < mesh->vertices_mm.rows();
  if (!indices || !mesh->vertices_mm.allFinite()) std::abort();
  return 0;
}
