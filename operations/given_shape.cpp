#include "operations/given_shape.h"

#include <algorithm>
#include <utility>

namespace coapt {
namespace {

constexpr std::size_t kLongestSource = 1000, kMostLeaflets = 100;
constexpr std::size_t kVerticesOfAValve = 20, kTrianglesOfAVertex = 2;
constexpr Range kThicknesses_mm = {0.01, 10.0};

std::string read_short_string(const JsonPlace& place) {
  std::string text = read_string(place);
  if (text.size() > kLongestSource)
    add_problem(place, ErrorCode::OutOfRange,
                "is longer than " + std::to_string(kLongestSource) + " bytes");
  return text;
}

Faces read_faces(const JsonPlace& place) {
  const auto rows = read_list(place, read_indices);
  Faces faces(std::ssize(rows), 3);
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k)
      faces(static_cast<Index>(i), static_cast<Index>(k)) = rows[i][k];
  return faces;
}

/// What is wrong between the lists of a mesh.
void check_mesh(const JsonPlace& place, const LeafletMesh& mesh) {
  const auto vertices = static_cast<int>(mesh.vertices_mm.rows());
  if (mesh.faces.rows() > 0 && (mesh.faces.minCoeff() < 0 || mesh.faces.maxCoeff() >= vertices))
    add_problem(place, ErrorCode::BadReference,
                "faces must name vertices from 0 to " + std::to_string(vertices - 1));
  if (mesh.names.size() > kMostLeaflets)
    add_problem(place, ErrorCode::OutOfRange, "names must have at most 100 entries");
  const auto named = [&](int leaflet) {
    return leaflet >= 0 && leaflet < static_cast<int>(mesh.names.size());
  };
  if (!mesh.leaflets.empty() && (std::ssize(mesh.leaflets) != mesh.faces.rows() ||
                                 !std::all_of(mesh.leaflets.begin(), mesh.leaflets.end(), named)))
    add_problem(place, ErrorCode::BadReference,
                "leaflets must hold one index into names, from 0, for each face");
}

/// A mesh as numbers.
LeafletMesh read_numbers(const JsonPlace& place, std::optional<double>& thickness_mm) {
  LeafletMesh mesh;
  mesh.faces.resize(0, 3);
  const auto read_thickness = [](const JsonPlace& number) {
    return read_number_in(number, kThicknesses_mm, " mm");
  };
  const auto strings = [](const JsonPlace& list) { return read_list(list, read_short_string); };
  const auto integers = [](const JsonPlace& list) { return read_list(list, read_integer); };
  read_fields(place, {{"vertices_mm", into(mesh.vertices_mm, read_points)},
                      {"faces", into(mesh.faces, read_faces), false},
                      {"names", into(mesh.names, strings), false},
                      {"leaflets", into(mesh.leaflets, integers), false},
                      {"thickness_mm", into(thickness_mm, read_thickness), false}});
  if (!place.problems.empty()) return mesh;
  check_mesh(place, mesh);
  return mesh;
}

/// What is wrong with the surface of a shape.
Errors check(const GivenShape& shape, const OperationLimits& limits) {
  if (shape.triangles == Triangles::Required && shape.mesh.faces.rows() == 0)
    return {Error{ErrorCode::MissingField, "", "must have triangles, not points alone"}};
  return check_surface(shape.mesh, limits);
}

}  // namespace

MeshLimits surface_limits(const OperationLimits& limits) {
  constexpr MeshLimits kUsual;
  const auto of_a_valve = static_cast<std::size_t>(std::max(0, limits.vertices));
  const std::size_t vertices =
      kVerticesOfAValve * std::min(kUsual.vertices / kVerticesOfAValve, of_a_valve);
  return {vertices, kTrianglesOfAVertex * vertices};
}

Errors check_surface(const LeafletMesh& mesh, const OperationLimits& limits) {
  const MeshLimits most = surface_limits(limits);
  const auto vertices = static_cast<std::size_t>(mesh.vertices_mm.rows()),
             faces = static_cast<std::size_t>(mesh.faces.rows());
  if (vertices <= most.vertices && faces <= most.faces) return {};
  return {Error{ErrorCode::OutOfRange, "",
                "has " + std::to_string(vertices) + " vertices and " + std::to_string(faces) +
                    " triangles, but this service accepts at most " +
                    std::to_string(most.vertices) + " and " + std::to_string(most.faces)}};
}

Index size_of(const LeafletMesh& mesh) {
  return std::max(mesh.vertices_mm.rows(),
                  mesh.faces.rows() / static_cast<Index>(kTrianglesOfAVertex));
}

JsonField source_field(std::string& source) {
  return {"source", into(source, read_short_string), false};
}

void read_given_shape(const JsonPlace& place, const Context& context, GivenShape& shape,
                      Triangles triangles) {
  ProblemList problems;  // of this shape alone
  const JsonPlace alone{place.value, problems};
  std::optional<LeafletMesh> numbers;
  shape.triangles = triangles;
  shape.reading.limits = surface_limits(context.limits);
  const auto mesh_of = [&](const JsonPlace& mesh) {
    return read_numbers(mesh, shape.thickness_mm);
  };
  read_fields(alone,
              {{"mesh", into(numbers, mesh_of), false},
               {"file", into(shape.file, read_file), false},
               {"leaflet_array", into(shape.reading.leaflets, read_short_string), false},
               {"displacement_array", into(shape.reading.displacement, read_short_string), false},
               source_field(shape.source)});
  if (problems.empty() && numbers.has_value() == shape.file.has_value())
    add_problem(alone, ErrorCode::MissingField, "must have exactly one of mesh and file");
  if (problems.empty() && shape.file && !context.surface_of)
    problems.add(ErrorCode::Unsupported, "/file", "no file is read here; send the mesh as numbers");
  if (problems.empty() && numbers) {
    shape.mesh = *std::move(numbers);
    add_below(problems, "", check(shape, context.limits));
  }
  if (!problems.empty())
    return add_below(place.problems, pointer(place), std::move(problems).take());
  if (numbers && shape.mesh.faces.rows() > 0)
    shape.mesh = without_loose_vertices(shape.mesh.leaflets.empty()
                                            ? in_pieces(shape.mesh.vertices_mm, shape.mesh.faces)
                                            : shape.mesh);
  if (shape.source.empty()) shape.source = shape.file ? shape.file->name : "mesh";
}

Errors read_files_of(std::initializer_list<ShapeAt> shapes, const Context& context) {
  ProblemList problems;
  for (const auto& [shape, path] : shapes) {
    if (!shape.file) continue;
    Expected<LeafletMesh> mesh = context.surface_of(*shape.file, shape.reading);
    if (mesh) {
      shape.file.reset();
      shape.mesh = *std::move(mesh);
      add_below(problems, path, check(shape, context.limits));
    } else {
      add_below(problems, path + std::string("/file"), mesh.errors());
    }
  }
  return std::move(problems).take();
}

}  // namespace coapt
