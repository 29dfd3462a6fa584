// Wavefront OBJ: v and f lines (v/vt/vn, negative indices count backwards); everything else is
// passed over, as other programs do.

#include "io/mesh/obj.h"

#include "io/mesh/mesh_builder.h"
#include "io/mesh/text_scan.h"

namespace coapt {
namespace {

void add_vertex(const std::vector<std::string_view>& line, int number, MeshBuilder& mesh) {
  const std::string path = "/vertices_mm/" + std::to_string(mesh.vertices());
  Vec3 position = Vec3::Zero();
  bool good = line.size() >= 4;
  for (std::size_t axis = 0; good && axis < 3; ++axis) {
    const auto coordinate = to_number(line[axis + 1]);
    good = coordinate.has_value();
    if (good) position[static_cast<Eigen::Index>(axis)] = *coordinate;
  }
  if (good) return mesh.add_vertex(position, number);
  mesh.add_problem(ErrorCode::WrongType, path, number, "must be 'v' and three numbers");
  mesh.add_vertex(Vec3::Zero(), number);  // keeps the numbers of the vertices after it
}

void add_face(const std::vector<std::string_view>& line, int number, MeshBuilder& mesh) {
  std::vector<long long> corners;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const auto index = to_integer(line[i].substr(0, line[i].find('/')));
    if (!index || *index == 0) {
      mesh.add_problem(
          ErrorCode::WrongType, "/faces/" + std::to_string(mesh.faces()), number,
          "must be 'f' and vertex numbers from 1, or negative ones that count backwards");
      return;
    }
    corners.push_back(*index > 0 ? *index - 1 : mesh.vertices() + *index);
  }
  mesh.add_polygon(corners, number);
}

}  // namespace

Expected<TriangleMesh> read_obj(std::string_view text) {
  MeshBuilder mesh;
  LineScanner lines(text);
  while (const auto line = lines.next()) {
    if (mesh.full()) break;
    const auto tokens = words(line->text);
    if (tokens.empty()) continue;
    if (tokens[0] == "v") add_vertex(tokens, line->number, mesh);
    if (tokens[0] == "f") add_face(tokens, line->number, mesh);
  }
  return std::move(mesh).take();
}

}  // namespace coapt
