// VTK's XML formats of unstructured grids (.vtu) and of surfaces (.vtp), which finite element codes, ParaView and PyVista
// write: what of them is a surface.
// Read here and not by VTK's libraries, which bring 52 shared libraries into a program for one format.
#pragma once

#include <array>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "io/mesh/mesh_file.h"

namespace coapt {

/// Numbers of each point, or of each cell.
struct VtuArray {
  std::string name;
  int components = 1;
  std::vector<double> values;  ///< row by row; empty if nobody asked for them
};

/// Whether the values of this array are unpacked.
using WantedArrays = std::function<bool(std::string_view name)>;

inline bool no_array(std::string_view) { return false; }

struct VtuGrid {
  TriangleMesh mesh;  ///< TriangleMesh::polygons: the cell of each triangle
  std::vector<VtuArray> point_data, cell_data;  ///< of several of one name the first
};

/// One piece; numbers as text, as base64 or raw, apart or in place, plain or compressed by zlib or LZMA. Triangles,
/// quadrangles, pixels, polygons and strips; points and lines (chordae) are passed over. Unsupported: cells with a volume,
/// quadratic cells, several pieces, LZ4, big-endian files.
Expected<VtuGrid> read_vtu(std::string_view bytes, const WantedArrays& wanted,
                           std::size_t most_unpacked = kMostUnpacked,
                           const MeshLimits& limits = {});

/// The same of a PolyData file; its cells are numbered vertices, lines, polygons, strips.
Expected<VtuGrid> read_vtp(std::string_view bytes, const WantedArrays& wanted,
                           std::size_t most_unpacked = kMostUnpacked,
                           const MeshLimits& limits = {});

struct VtpLines {
  Points points_mm;
  std::vector<std::array<int, 2>> pieces;  ///< of its lines, each from one point to the next
};

/// The lines of a PolyData file; there may be none.
Expected<VtpLines> read_vtp_lines(std::string_view bytes,
                                  std::size_t most_unpacked = kMostUnpacked);

}  // namespace coapt
