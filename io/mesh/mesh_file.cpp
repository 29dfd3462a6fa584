#include "io/mesh/mesh_file.h"

#include "io/mesh/gltf.h"
#include "io/mesh/obj.h"
#include "io/mesh/ply.h"
#include "io/mesh/stl.h"
#include "io/mesh/vtk.h"
#include "io/mesh/vtu.h"

namespace coapt {
namespace {

template <class Arrays>
void add_names(const Arrays& arrays, LeftOver& left) {
  for (const auto& array : arrays) left.names.push_back(array.name);
  left.of = left.names.size();
}

}  // namespace

TriangleMesh joined(const std::vector<TriangleMesh>& meshes) {
  TriangleMesh all;
  for (const TriangleMesh& mesh : meshes) {
    const Eigen::Index vertices = all.vertices_mm.rows(), faces = all.faces.rows();
    all.vertices_mm.conservativeResize(vertices + mesh.vertices_mm.rows(), 3);
    all.vertices_mm.bottomRows(mesh.vertices_mm.rows()) = mesh.vertices_mm;
    all.faces.conservativeResize(faces + mesh.faces.rows(), 3);
    all.faces.bottomRows(mesh.faces.rows()) =
        (mesh.faces.array() + static_cast<int>(vertices)).matrix();
  }
  return all;
}

Expected<TriangleMesh> read_mesh(std::string_view bytes, std::string_view format,
                                 std::size_t most_unpacked, const MeshLimits& limits) {
  if (format == "obj") return read_obj(bytes, limits);
  if (format == "ply") {
    Expected<PlyFile> file = read_ply_file(bytes, limits);
    if (!file) return file.errors();
    add_names(file->face_numbers, file->mesh.arrays);
    return std::move(file->mesh);
  }
  if (format == "stl") return read_stl(bytes, limits);
  if (format == "vtk") {
    Expected<VtkPolyData> data = read_vtk(bytes, limits);
    if (!data) return data.errors();
    if (data->faces.rows() == 0)
      return Error{ErrorCode::MissingField, "/faces", "is empty; a leaflet needs triangles"};
    TriangleMesh mesh{std::move(data->points_mm), std::move(data->faces), {}};
    add_names(data->face_data, mesh.arrays);
    return mesh;
  }
  if (format == "vtp" || format == "vtu") {
    Expected<VtuGrid> grid = format == "vtp" ? read_vtp(bytes, no_array, most_unpacked, limits)
                                             : read_vtu(bytes, no_array, most_unpacked, limits);
    if (!grid) return grid.errors();
    add_names(grid->cell_data, grid->mesh.arrays);
    add_names(grid->point_data, grid->mesh.arrays);
    return std::move(grid->mesh);
  }
  if (is_gltf_format(format)) {
    Expected<GroupedMesh> file = read_gltf(bytes, limits);
    if (!file) return file.errors();
    if (file->mesh.faces.rows() == 0)
      return Error{ErrorCode::MissingField, "/faces", "is empty; a leaflet needs triangles"};
    return std::move(file->mesh);
  }
  return Error{ErrorCode::Unsupported, "",
               "has the mesh format '" + std::string(format.substr(0, 20)) +
                   "', must be one of obj, ply, stl, glb, gltf, vtk, vtp, vtu"};
}

}  // namespace coapt
