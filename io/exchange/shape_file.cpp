#include "io/exchange/shape_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

#include "core/valve/number_text.h"
#include "core/valve/valve.h"
#include "io/exchange/stated_axes.h"
#include "io/json/json_reader.h"
#include "io/json/parse_json.h"
#include "io/mesh/vtk.h"
#include "io/mesh/vtu.h"

namespace coapt {
namespace {

constexpr std::array<std::string_view, 6> kShapeFormats = {"obj", "ply", "stl",
                                                           "vtk", "vtp", "vtu"};
constexpr std::array<std::string_view, 3> kLeafletArrays = {"leaflet", "element_sets", "segment"};
constexpr std::size_t kMaxLeaflets = 100;

/// What the readers of both VTK formats give.
struct FaceLabels {
  std::string name;
  std::vector<double> of_face;
};

std::string listed_names(const std::vector<FaceLabels>& arrays) {
  std::string names;
  for (const FaceLabels& array : arrays) names += (names.empty() ? "" : ", ") + array.name;
  return names.empty() ? "none" : names;
}

/// The array asked for, or the first known one; null: pieces.
Expected<const FaceLabels*> chosen_labels(const std::vector<FaceLabels>& arrays,
                                          const std::string& wanted) {
  const auto named = [&](std::string_view name) -> const FaceLabels* {
    const auto found = std::find_if(arrays.begin(), arrays.end(),
                                    [&](const FaceLabels& a) { return a.name == name; });
    return found == arrays.end() ? nullptr : &*found;
  };
  if (!wanted.empty()) {
    if (const FaceLabels* array = named(wanted)) return array;
    return Error{ErrorCode::BadReference, "/cell_data",
                 "has no array '" + wanted.substr(0, 60) +
                     "' with one number per cell; available: " + listed_names(arrays)};
  }
  for (const std::string_view name : kLeafletArrays)
    if (const FaceLabels* array = named(name)) return array;
  return static_cast<const FaceLabels*>(nullptr);
}

Expected<LeafletMesh> with_labels(Points vertices_mm, Faces faces,
                                  const std::vector<FaceLabels>& arrays,
                                  const ShapeFileOptions& options, bool own) {
  const Expected<const FaceLabels*> labels = chosen_labels(arrays, options.leaflets);
  if (!labels) return labels.errors();
  if (*labels == nullptr) return in_pieces(std::move(vertices_mm), std::move(faces));
  const std::vector<double>& of_face = (*labels)->of_face;
  const std::set<double> values(of_face.begin(), of_face.end());
  if (values.size() > kMaxLeaflets)
    return Error{ErrorCode::OutOfRange, "/cell_data/" + (*labels)->name,
                 "has " + std::to_string(values.size()) +
                     " values, must have 1 to 100 to number the leaflets"};
  LeafletMesh mesh{std::move(vertices_mm), std::move(faces), {}, {}};
  for (const double value : values) {
    const bool named = own && (*labels)->name == "leaflet" && (value == 0.0 || value == 1.0);
    mesh.names.push_back(named ? to_string(static_cast<Leaflet>(static_cast<int>(value)))
                               : (*labels)->name + ' ' + shown(value));
  }
  for (const double value : of_face)
    mesh.leaflets.push_back(static_cast<int>(std::distance(values.begin(), values.find(value))));
  return mesh;
}

Expected<LeafletMesh> read_legacy(std::string_view bytes, const ShapeFileOptions& options) {
  Expected<VtkPolyData> data = read_vtk(bytes, options.limits);
  if (!data) return data.errors();
  if (data->faces.rows() == 0)
    return Error{ErrorCode::MissingField, "/faces", "is empty; a leaflet needs triangles"};
  std::vector<FaceLabels> arrays;
  for (VtkScalars& scalars : data->face_data)
    arrays.push_back({scalars.name, std::move(scalars.values)});
  return with_labels(
      std::move(data->points_mm), std::move(data->faces), arrays, options,
      data->title.starts_with(kVtkTitle) || data->title.starts_with(kPatientVtkTitle));
}

/// None, and a problem, if there is no such array.
std::optional<Error> displace(VtuGrid& grid, const std::string& name) {
  if (name.empty()) return {};
  std::string names;
  for (const VtuArray& array : grid.point_data) {
    if (array.components == 3) names += (names.empty() ? "" : ", ") + array.name;
    if (array.name != name || array.components != 3) continue;
    grid.mesh.vertices_mm +=
        Eigen::Map<const Points>(array.values.data(), grid.mesh.vertices_mm.rows(), 3);
    if (grid.mesh.vertices_mm.allFinite()) return {};
    return Error{ErrorCode::OutOfRange, "/point_data/" + name, "must be finite"};
  }
  return Error{
      ErrorCode::BadReference, "/point_data",
      "has no array '" + name.substr(0, 60) +
          "' with three numbers per point; available: " + (names.empty() ? "none" : names)};
}

WantedArrays wanted_arrays(const ShapeFileOptions& options) {
  return [options](std::string_view name) {
    if (name == options.displacement || name == options.leaflets) return true;
    return options.leaflets.empty() &&
           std::find(kLeafletArrays.begin(), kLeafletArrays.end(), name) != kLeafletArrays.end();
  };
}

Expected<LeafletMesh> read_grid(Expected<VtuGrid> grid, const ShapeFileOptions& options) {
  if (!grid) return grid.errors();
  if (const auto problem = displace(*grid, options.displacement)) return *problem;
  std::vector<FaceLabels> arrays;
  for (const VtuArray& array : grid->cell_data) {
    if (array.components != 1) continue;
    FaceLabels& labels = arrays.emplace_back();
    labels.name = array.name;
    if (array.values.empty()) continue;  // listed, not read
    for (const int cell : grid->mesh.polygons)
      labels.of_face.push_back(array.values[static_cast<std::size_t>(cell)]);
  }
  return with_labels(std::move(grid->mesh.vertices_mm), std::move(grid->mesh.faces), arrays,
                     options, false);
}

bool is_scene(const Json& document) {
  return document.is_object() && document.contains("schema") &&
         (document["schema"] == "coapt.scene/2" || document["schema"] == "coapt.scene/1");
}

/// A member that is a flat list of rows of three numbers.
std::vector<double> triples(const Json& document, const char* name, ProblemList& problems) {
  const auto found = document.find(name);
  const bool fits = found != document.end() && found->is_array() && !found->empty() &&
                    found->size() % 3 == 0 &&
                    std::all_of(found->begin(), found->end(),
                                [](const Json& entry) { return entry.is_number(); });
  if (fits) return found->get<std::vector<double>>();
  problems.add(ErrorCode::WrongType, std::string("/") + name,
               "must be a list of numbers, three a row, at least one row");
  return {};
}

Points rows_of(const std::vector<double>& numbers) {
  return Eigen::Map<const Points>(numbers.data(), std::ssize(numbers) / 3, 3);
}

}  // namespace

std::string shape_format_names() {
  std::string names;
  for (const std::string_view format : kShapeFormats)
    names += (names.empty() ? "" : ", ") + std::string(format);
  return names;
}

bool is_shape_format(std::string_view format) {
  return std::find(kShapeFormats.begin(), kShapeFormats.end(), format) != kShapeFormats.end();
}

Expected<LeafletMesh> read_shape(std::string_view bytes, std::string_view format,
                                 const ShapeFileOptions& options) {
  const MeshLimits& limits = options.limits;
  const std::size_t most_unpacked = std::min(kMostUnpacked, sizeof(double) * limits.numbers());
  const auto read = [&]() -> Expected<LeafletMesh> {
    if (format == "vtk") return read_legacy(bytes, options);
    if (format == "vtu")
      return read_grid(read_vtu(bytes, wanted_arrays(options), most_unpacked, limits), options);
    if (format == "vtp")
      return read_grid(read_vtp(bytes, wanted_arrays(options), most_unpacked, limits), options);
    Expected<TriangleMesh> mesh = read_mesh(bytes, format, most_unpacked, limits);
    if (!mesh) return mesh.errors();
    return in_pieces(std::move(mesh->vertices_mm), std::move(mesh->faces));
  };
  Expected<LeafletMesh> mesh = read();
  if (!mesh) return mesh.errors();
  if (stated_axes(bytes) == PatientAxes::RAS) turn_axes(mesh->vertices_mm);
  return without_loose_vertices(*mesh);
}

bool is_scene_text(std::string_view text) {
  const Expected<Json> document = parse_json(text);
  return document && is_scene(*document);
}

Expected<LeafletMesh> read_scene_shape(std::string_view text, const MeshLimits& limits) {
  const Expected<Json> document = parse_json(text, std::min(kMaxJsonValues, limits.numbers()));
  if (!document) return document.errors();
  if (!is_scene(*document))
    return Error{ErrorCode::Unsupported, "/schema", "must be coapt.scene/2"};
  ProblemList problems;
  const std::vector<double> closed = triples(*document, "closed_mm", problems);
  const std::vector<double> corners = triples(*document, "faces", problems);
  if (!problems.empty()) return std::move(problems).take();
  const Points vertices_mm = rows_of(closed);
  const Points faces = rows_of(corners);
  if (!(faces.minCoeff() >= 0.0 && faces.maxCoeff() < static_cast<double>(vertices_mm.rows())) ||
      faces != faces.array().floor().matrix())
    return Error{ErrorCode::BadReference, "/faces",
                 "must name vertices from 0 to " + std::to_string(vertices_mm.rows() - 1)};
  return without_loose_vertices(in_pieces(vertices_mm, faces.cast<int>()));
}

}  // namespace coapt
