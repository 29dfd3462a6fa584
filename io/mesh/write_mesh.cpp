#include "io/mesh/write_mesh.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <optional>

#include "io/mesh/mesh_builder.h"

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

/// @param digits as of %.*g; none: as few as read back to the same bits
void append_number(std::string& text, double number, std::optional<int> digits) {
  char characters[32];
  char* const end = characters + sizeof characters;
  const auto written =
      digits ? std::to_chars(characters, end, number, std::chars_format::general, *digits)
             : std::to_chars(characters, end, number);
  text.append(characters, written.ptr);
}

void append_points(std::string& text, const Points& points, const char* before,
                   std::optional<int> digits) {
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    text += before;
    for (int axis = 0; axis < 3; ++axis) {
      append_number(text, points(i, axis), digits);
      text += axis < 2 ? ' ' : '\n';
    }
  }
}

/// @param first the number of the first vertex
void append_faces(std::string& text, const Faces& faces, const char* before, int first) {
  for (Eigen::Index f = 0; f < faces.rows(); ++f) {
    text += before;
    for (int corner = 0; corner < 3; ++corner) {
      text += std::to_string(faces(f, corner) + first);
      text += corner < 2 ? ' ' : '\n';
    }
  }
}

std::string ply(const TriangleMesh& mesh) {
  std::string text = "ply\nformat ascii 1.0\ncomment coapt, millimetres\nelement vertex " +
                     std::to_string(mesh.vertices_mm.rows()) +
                     "\nproperty double x\nproperty double y\nproperty double z\nelement face " +
                     std::to_string(mesh.faces.rows()) +
                     "\nproperty list uchar int vertex_indices\nend_header\n";
  append_points(text, mesh.vertices_mm, "", {});
  append_faces(text, mesh.faces, "3 ", 0);
  return text;
}

std::string obj(const TriangleMesh& mesh) {
  std::string text = "# coapt, millimetres\n";
  append_points(text, mesh.vertices_mm, "v ", {});
  append_faces(text, mesh.faces, "f ", 1);
  return text;
}

std::string vtk(const TriangleMesh& mesh) {
  constexpr int kDigits = 9;
  const std::string faces = std::to_string(mesh.faces.rows());
  std::string text =
      "# vtk DataFile Version 4.2\n"
      "coapt, millimetres, axes of the valve; SPACE=LPS\n"
      "ASCII\nDATASET POLYDATA\nPOINTS " +
      std::to_string(mesh.vertices_mm.rows()) + " double\n";
  append_points(text, mesh.vertices_mm, "", kDigits);
  text += "POLYGONS " + faces + ' ' + std::to_string(4 * mesh.faces.rows()) + '\n';
  append_faces(text, mesh.faces, "3 ", 0);
  return text;
}

template <class T>
void append_little_endian(std::string& bytes, T value) {
  char raw[sizeof(T)];
  std::memcpy(raw, &value, sizeof(T));
  if constexpr (std::endian::native == std::endian::big) std::reverse(raw, raw + sizeof(T));
  bytes.append(raw, sizeof(T));
}

void append_vector(std::string& bytes, const Vec3& vector) {
  for (const double number : vector)
    append_little_endian(bytes, static_cast<float>(number + 0.0));  // 0, not -0
}

std::string stl(const TriangleMesh& mesh) {
  std::string bytes = "coapt, millimetres";  // not "solid", by which tools know the text format
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

Expected<std::string> write_mesh(const TriangleMesh& mesh, std::string_view format) {
  std::string (*const write)(const TriangleMesh&) = format == "ply"   ? ply
                                                    : format == "obj" ? obj
                                                    : format == "stl" ? stl
                                                    : format == "vtk" ? vtk
                                                                      : nullptr;
  if (write == nullptr)
    return Error{
        ErrorCode::Unsupported, "",
        "mesh format '" + std::string(format.substr(0, 20)) + "', accepted: ply, obj, stl, vtk"};
  if (Errors errors = check(mesh); !errors.empty()) return errors;
  return write(mesh);
}

TriangleMesh leaflet_mesh(const Valve& valve, const Points& closed_mm) {
  assert(closed_mm.rows() == valve.rest_mm.rows());
  return {closed_mm, valve.faces};
}

}  // namespace coapt
