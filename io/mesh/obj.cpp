// Wavefront OBJ: v, f and l lines (v/vt/vn, negative indices count backwards) and the object (o), group (g) or material
// (usemtl) that they stand under; everything else is passed over, as other programs do.

#include "io/mesh/obj.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>

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

/// Vertices of an f or l line, counted from 0; none and a problem if they are no numbers.
std::vector<long long> corners_of(const std::vector<std::string_view>& line, int number,
                                  const std::string& path, MeshBuilder& mesh) {
  std::vector<long long> corners;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const auto index = to_integer(line[i].substr(0, line[i].find('/')));
    if (!index || *index == 0) {
      mesh.add_problem(ErrorCode::WrongType, path, number,
                       "must be '" + std::string(line[0]) +
                           "' and vertex numbers from 1, or negative ones that count backwards");
      return {};
    }
    corners.push_back(*index > 0 ? *index - 1 : mesh.vertices() + *index);
  }
  return corners;
}

/// The names that a face or line stands under: object, group, material.
using Under = std::array<int, 3>;
constexpr std::array kGroupings = {"objects", "groups", "materials"};

class ObjReader {
 public:
  explicit ObjReader(const MeshLimits& limits) : limits_(limits), mesh_(limits) {}

  Expected<GroupedMesh> read(std::string_view text) {
    if (constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
        text.starts_with(kByteOrderMark))
      text.remove_prefix(kByteOrderMark.size());  // or the first vertex would be passed over
    LineScanner lines(text);
    while (const auto line = lines.next()) {
      if (mesh_.full() || is_crowded(line->number)) break;
      const auto tokens = words(line->text);
      if (tokens.empty()) continue;
      if (tokens[0] == "v") add_vertex(tokens, line->number, mesh_);
      if (tokens[0] == "f") add_face(tokens, line->number);
      if (tokens[0] == "l") add_line(tokens, line->number);
      for (const auto& [keyword, kind] : {std::pair("o", 0), {"g", 1}, {"usemtl", 2}})
        if (tokens[0] == keyword)
          under_[static_cast<std::size_t>(kind)] = name_number(
              trimmed(std::string_view(tokens[0].end(), line->text.data() + line->text.size())));
    }
    return finish();
  }

 private:
  bool is_crowded(int number) {
    if (std::max(lines_.size(), names_.size()) <= limits_.faces) return false;
    mesh_.add_problem(
        ErrorCode::OutOfRange, "", number,
        "has more than the " + std::to_string(limits_.faces) + " lines or names accepted");
    return true;
  }

  void add_face(const std::vector<std::string_view>& tokens, int number) {
    const std::string path = "/faces/" + std::to_string(mesh_.faces());
    const auto corners = corners_of(tokens, number, path, mesh_);
    if (corners.empty() && tokens.size() > 1) return;
    mesh_.add_polygon(corners, number);
    polygons_.push_back(under_);
  }

  void add_line(const std::vector<std::string_view>& tokens, int number) {
    const std::string path = "/lines/" + std::to_string(lines_.size());
    GroupedLine& line = file_.lines.emplace_back();
    lines_.push_back(under_);
    for (const long long point : corners_of(tokens, number, path, mesh_)) {
      if (point < 0 || point >= mesh_.vertices())
        return mesh_.add_problem(ErrorCode::BadReference, path, number,
                                 "names vertex " + std::to_string(point + 1) +
                                     ", must be one of the " + std::to_string(mesh_.vertices()) +
                                     " before it");
      line.points.push_back(static_cast<int>(point));
    }
  }

  int name_number(std::string_view name) {
    const auto [found, fresh] =
        numbers_.try_emplace(std::string(name), static_cast<int>(names_.size()));
    if (fresh) names_.emplace_back(name);
    return found->second;
  }

  Expected<GroupedMesh> finish() {
    if (mesh_.faces() == 0 && !file_.lines.empty()) {
      Expected<Points> points = std::move(mesh_).take_points();
      if (!points) return points.errors();
      file_.mesh = {*std::move(points), Faces(0, 3), {}};
    } else {
      Expected<TriangleMesh> mesh = std::move(mesh_).take();
      if (!mesh) return mesh.errors();
      file_.mesh = *std::move(mesh);
    }
    for (std::size_t kind = 0; kind < kGroupings.size(); ++kind) {
      std::set<int> used;
      for (const auto* list : {&polygons_, &lines_})
        for (const Under& under : *list) used.insert(under[kind]);
      if (used.size() < 2 && kind + 1 < kGroupings.size()) continue;
      file_.grouped_by = kGroupings[kind];
      file_.groups = names_;
      for (const Under& under : polygons_) file_.group_of_polygon.push_back(under[kind]);
      for (std::size_t i = 0; i < lines_.size(); ++i) file_.lines[i].group = lines_[i][kind];
      break;
    }
    return std::move(file_);
  }

  const MeshLimits limits_;
  MeshBuilder mesh_;
  GroupedMesh file_;
  Under under_{};
  std::vector<Under> polygons_, lines_;
  std::vector<std::string> names_ = {""};
  std::map<std::string, int, std::less<>> numbers_ = {{"", 0}};
};

}  // namespace

Expected<GroupedMesh> read_obj_file(std::string_view text, const MeshLimits& limits) {
  return ObjReader(limits).read(text);
}

Expected<TriangleMesh> read_obj(std::string_view text, const MeshLimits& limits) {
  Expected<GroupedMesh> file = read_obj_file(text, limits);
  if (!file) return file.errors();
  if (file->mesh.faces.rows() == 0)
    return Error{ErrorCode::MissingField, "/faces", "is empty; a leaflet needs triangles"};
  return std::move(file->mesh);
}

}  // namespace coapt
