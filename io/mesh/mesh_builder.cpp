#include "io/mesh/mesh_builder.h"

#include <algorithm>

namespace coapt {
namespace {

constexpr std::size_t kMaxCorners = 1000;

std::string at_line(int line) {
  return line > 0 ? "line " + std::to_string(line) + ": " : std::string();
}

Points as_points(const std::vector<Vec3>& list) {
  Points points(std::ssize(list), 3);
  for (std::size_t i = 0; i < list.size(); ++i) points.row(static_cast<Eigen::Index>(i)) = list[i];
  return points;
}

}  // namespace

void MeshBuilder::add_problem(ErrorCode code, const std::string& path, int line,
                              const std::string& message) {
  problems_.add(code, path, at_line(line) + message);
}

void MeshBuilder::add_vertex(const Vec3& position_mm, int line) {
  if (!(position_mm.array() >= kMeshCoordinateMm.min).all() ||
      !(position_mm.array() <= kMeshCoordinateMm.max).all())
    wild_.push_back({vertices_.size(), line});
  vertices_.push_back(position_mm);
  if (vertices_.size() == limits_.vertices + 1) {
    add_problem(ErrorCode::OutOfRange, "/vertices_mm", line,
                "has more than the " + std::to_string(limits_.vertices) + " vertices accepted");
  }
}

void MeshBuilder::add_wild(const Wild& wild) {
  for (int axis = 0; axis < 3; ++axis) {
    const double number = vertices_[wild.vertex][axis];
    if (number >= kMeshCoordinateMm.min && number <= kMeshCoordinateMm.max) continue;
    add_problem(ErrorCode::OutOfRange,
                "/vertices_mm/" + std::to_string(wild.vertex) + '/' + std::to_string(axis),
                wild.line, "is " + shown(number) + ", must be from -1e5 to 1e5 mm");
  }
}

void MeshBuilder::add_polygon(const std::vector<long long>& corners, int line) {
  add_polygon(corners, line, polygons_++);
}

void MeshBuilder::add_polygon(const std::vector<long long>& corners, int line, int polygon) {
  const std::string path = "/faces/" + std::to_string(faces());
  if (corners.size() < 3 || corners.size() > kMaxCorners) {
    add_problem(ErrorCode::OutOfRange, path, line,
                "has " + std::to_string(corners.size()) + " corners, must have 3 to 1000");
    return;
  }
  for (std::size_t i = 2; i < corners.size(); ++i) {
    faces_.push_back({{corners[0], corners[i - 1], corners[i]}, line, polygon});
  }
  if (faces_.size() > limits_.faces) {
    add_problem(ErrorCode::OutOfRange, "/faces", line,
                "has more than the " + std::to_string(limits_.faces) + " triangles accepted");
  }
}

bool MeshBuilder::full() const {
  return vertices_.size() > limits_.vertices || faces_.size() > limits_.faces ||
         problems_.listed().size() >= ProblemList::kMaxListed;
}

Expected<TriangleMesh> MeshBuilder::take() && {
  std::size_t usable = 0;
  std::vector<bool> used(wild_.empty() ? 0 : vertices_.size(), false);
  for (std::size_t face = 0; face < faces_.size(); ++face) {
    const auto& corners = faces_[face].corners;
    for (std::size_t corner = 0; corner < 3; ++corner) {
      if (corners[corner] >= 0 && corners[corner] < vertices()) {
        if (!used.empty()) used[static_cast<std::size_t>(corners[corner])] = true;
        continue;
      }
      add_problem(ErrorCode::BadReference,
                  "/faces/" + std::to_string(face) + '/' + std::to_string(corner),
                  faces_[face].line,
                  "is vertex " + std::to_string(corners[corner]) +
                      " counted from 0, must be 0 to " + std::to_string(vertices() - 1));
    }
    if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0]) continue;
    faces_[usable++] = faces_[face];
  }
  for (const Wild& wild : wild_)
    if (used[wild.vertex]) add_wild(wild);
  if (problems_.empty() && usable == 0) {
    add_problem(ErrorCode::MissingField, "/faces", 0, "is empty; a leaflet needs triangles");
  }
  if (!problems_.empty()) return std::move(problems_).take();
  TriangleMesh mesh{as_points(vertices_), Faces(static_cast<Eigen::Index>(usable), 3), {}};
  for (std::size_t i = 0; i < usable; ++i) {
    mesh.polygons.push_back(faces_[i].polygon);
    for (std::size_t corner = 0; corner < 3; ++corner) {
      mesh.faces(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(corner)) =
          static_cast<int>(faces_[i].corners[corner]);
    }
  }
  return mesh;
}

Expected<Points> MeshBuilder::take_points() && {
  for (const Wild& wild : wild_) add_wild(wild);
  if (!problems_.empty()) return std::move(problems_).take();
  return as_points(vertices_);
}

}  // namespace coapt
