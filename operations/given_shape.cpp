#include "operations/given_shape.h"

#include <algorithm>
#include <utility>

#include "io/exchange/shape_file.h"
#include "io/json/named_file.h"

namespace coapt {
namespace {

constexpr std::size_t kLongestSource = 1000, kMostLeaflets = 100;
constexpr std::ptrdiff_t kVerticesOfAValve = 20;  // one of images is as much finer
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

/// The surface of a file, as the context reads it.
LeafletMesh read_in(const JsonPlace& place, const NamedFile& file, const ShapeFileOptions& options,
                    const Context& context) {
  if (!context.surface_of) {
    add_problem(place, ErrorCode::Unsupported, "no file is read here; send the mesh as numbers");
    return {};
  }
  Expected<LeafletMesh> mesh = context.surface_of(file, options);
  if (mesh) return *std::move(mesh);
  add_below(place.problems, pointer(place), mesh.errors());
  return {};
}

void check_count(const JsonPlace& place, const LeafletMesh& mesh, const Context& context) {
  const std::ptrdiff_t most = kVerticesOfAValve * std::ptrdiff_t{context.limits.vertices};
  if (mesh.vertices_mm.rows() <= most) return;
  add_problem(place, ErrorCode::OutOfRange,
              "has " + std::to_string(mesh.vertices_mm.rows()) +
                  " vertices, but this service accepts at most " + std::to_string(most));
}

}  // namespace

JsonField source_field(std::string& source) {
  return {"source", into(source, read_short_string), false};
}

void read_given_shape(const JsonPlace& place, const Context& context, GivenShape& shape,
                      Triangles triangles) {
  ProblemList problems;  // of this shape alone
  const JsonPlace alone{place.value, problems};
  std::optional<NamedFile> file;
  std::optional<LeafletMesh> numbers;
  ShapeFileOptions options;
  const auto mesh_of = [&](const JsonPlace& mesh) {
    return read_numbers(mesh, shape.thickness_mm);
  };
  read_fields(alone, {{"mesh", into(numbers, mesh_of), false},
                      {"file", into(file, read_file), false},
                      {"leaflet_array", into(options.leaflets, read_short_string), false},
                      {"displacement_array", into(options.displacement, read_short_string), false},
                      source_field(shape.source)});
  if (problems.empty() && numbers.has_value() == file.has_value())
    add_problem(alone, ErrorCode::MissingField, "must have exactly one of mesh and file");
  if (problems.empty() && file)
    shape.mesh = read_in({place.value["file"], problems, &alone, "file"}, *file, options, context);
  if (problems.empty() && numbers) shape.mesh = *std::move(numbers);
  if (problems.empty() && triangles == Triangles::Required && shape.mesh.faces.rows() == 0)
    add_problem(alone, ErrorCode::MissingField, "must have triangles, not points alone");
  if (problems.empty()) check_count(alone, shape.mesh, context);
  if (!problems.empty())
    return add_below(place.problems, pointer(place), std::move(problems).take());
  if (numbers && shape.mesh.faces.rows() > 0)
    shape.mesh = without_loose_vertices(shape.mesh.leaflets.empty()
                                            ? in_pieces(shape.mesh.vertices_mm, shape.mesh.faces)
                                            : shape.mesh);
  if (shape.source.empty()) shape.source = file ? file->name : "mesh";
}

}  // namespace coapt
