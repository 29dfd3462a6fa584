#include "io/mesh/write_mesh.h"

#include <cassert>

#include "io/mesh/little_endian.h"
#include "io/mesh/mesh_builder.h"
#include "io/mesh/mesh_text.h"
#include "io/mesh/write_vtk.h"

namespace coapt {
namespace {

constexpr std::size_t kStlHeaderBytes = 80;

/// All that read_mesh() would refuse.
Errors check(const TriangleMesh& mesh) {
  ProblemList problems;
  const auto path = [](const char* list, Eigen::Index row, int column) {
    return std::string(list) + std::to_string(row) + '/' + std::to_string(column);
  };
  for (Eigen::Index i = 0; i < mesh.vertices_mm.rows(); ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      const double number = mesh.vertices_mm(i, axis);
      if (number >= kMeshCoordinateMm.min && number <= kMeshCoordinateMm.max) continue;
      problems.add(ErrorCode::OutOfRange, path("/vertices_mm/", i, axis),
                   "is " + shown(number) + ", must be from -1e5 to 1e5 mm");
    }
  }
  for (Eigen::Index f = 0; f < mesh.faces.rows(); ++f) {
    for (int corner = 0; corner < 3; ++corner) {
      const int vertex = mesh.faces(f, corner);
      if (vertex >= 0 && vertex < mesh.vertices_mm.rows()) continue;
      problems.add(ErrorCode::BadReference, path("/faces/", f, corner),
                   "is vertex " + std::to_string(vertex) + " counted from 0, must be below " +
                       std::to_string(mesh.vertices_mm.rows()));
    }
  }
  return problems.empty() ? Errors{} : std::move(problems).take();
}

std::string remarked(const std::string& title, const std::string& remark) {
  return title + (remark.empty() ? "" : "; " + remark);
}

std::string ply(const TriangleMesh& mesh, const std::string& remark) {
  std::string text = "ply\nformat ascii 1.0\ncomment coapt, millimetres\n" +
                     (remark.empty() ? "" : "comment " + remark + '\n') + "element vertex " +
                     std::to_string(mesh.vertices_mm.rows()) +
                     "\nproperty double x\nproperty double y\nproperty double z\nelement face " +
                     std::to_string(mesh.faces.rows()) +
                     "\nproperty list uchar int vertex_indices\nend_header\n";
  append_points(text, mesh.vertices_mm, "", {});
  append_faces(text, mesh.faces, "3 ", 0);
  return text;
}

std::string obj(const TriangleMesh& mesh, const std::string& remark) {
  std::string text = "# coapt, millimetres\n" + (remark.empty() ? "" : "# " + remark + '\n');
  append_points(text, mesh.vertices_mm, "v ", {});
  append_faces(text, mesh.faces, "f ", 1);
  return text;
}

std::string vtk(const TriangleMesh& mesh, const std::string& remark) {
  return write_vtk({remarked(kVtkTitle, remark), mesh.vertices_mm, {}, mesh.faces, {}, {}, {}});
}

void append_vector(std::string& bytes, const Vec3& vector) {
  for (const double number : vector)
    append_little_endian(bytes, static_cast<float>(number + 0.0));  // 0, not -0
}

std::string stl(const TriangleMesh& mesh, const std::string& remark) {
  // Not "solid", by which tools know the text format.
  std::string bytes = remarked("coapt, millimetres", remark);
  bytes.resize(kStlHeaderBytes, ' ');
  append_little_endian(bytes, static_cast<std::uint32_t>(mesh.faces.rows()));
  for (Eigen::Index f = 0; f < mesh.faces.rows(); ++f) {
    const auto corner = [&](int k) { return Vec3(mesh.vertices_mm.row(mesh.faces(f, k))); };
    const Vec3 a = corner(0), b = corner(1), c = corner(2);
    append_vector(bytes, (b - a).cross(c - a).normalized());  // of 0 it is 0
    for (const Vec3& point : {a, b, c}) append_vector(bytes, point);
    append_little_endian(bytes, std::uint16_t{0});
  }
  return bytes;
}

}  // namespace

Expected<std::string> write_mesh(const TriangleMesh& mesh, std::string_view format,
                                 const std::string& remark) {
  std::string (*const write)(const TriangleMesh&, const std::string&) = format == "ply"   ? ply
                                                                        : format == "obj" ? obj
                                                                        : format == "stl" ? stl
                                                                        : format == "vtk" ? vtk
                                                                                          : nullptr;
  if (write == nullptr)
    return Error{ErrorCode::Unsupported, "",
                 "has the mesh format '" + std::string(format.substr(0, 20)) +
                     "', must be one of ply, obj, stl, vtk"};
  if (Errors errors = check(mesh); !errors.empty()) return errors;
  return write(mesh, remark);
}

TriangleMesh leaflet_mesh(const Valve& valve, const Points& closed_mm) {
  assert(closed_mm.rows() == valve.rest_mm.rows());
  return {closed_mm, valve.faces};
}

}  // namespace coapt
