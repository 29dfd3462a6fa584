// Closed shapes of any origin, as they are compared: meshes of images, of other codes, and coapt's own exports and scenes.
#pragma once

#include <string>
#include <string_view>

#include "core/metrics/shape_comparison.h"
#include "core/valve/problem_list.h"
#include "io/mesh/mesh_file.h"

namespace coapt {

struct ShapeFileOptions {
  /// Array of the cells (.vtk, .vtp, .vtu) that numbers the leaflets. Empty: the first of "leaflet", "element_sets" and "segment"
  /// that is there; without one, pieces that hang together.
  std::string leaflets = {};
  std::string displacement =
      {};  ///< array of the points (.vtp, .vtu), three numbers each, to be added; empty: none
  MeshLimits limits = {};
};

/// "obj, ply, stl, vtk, vtp, vtu".
std::string shape_format_names();
bool is_shape_format(std::string_view format);

/// In LPS, as stated_axes() says; without loose vertices; the faces of quadrangles as two triangles. `format`: one of shape_format_names().
Expected<LeafletMesh> read_shape(std::string_view bytes, std::string_view format,
                                 const ShapeFileOptions& options = {});

/// Whether a JSON document says that it is one; what is no JSON is none.
bool is_scene_text(std::string_view text);

/// The closed state of a coapt.scene/2 (or /1) document.
Expected<LeafletMesh> read_scene_shape(std::string_view text, const MeshLimits& limits = {});

}  // namespace coapt
