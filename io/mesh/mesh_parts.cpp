#include "io/mesh/mesh_parts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include "core/valve/number_text.h"
#include "io/mesh/gltf.h"
#include "io/mesh/obj.h"
#include "io/mesh/ply.h"
#include "io/mesh/sheet_repair.h"
#include "io/mesh/stl.h"
#include "io/mesh/vtk.h"
#include "io/mesh/vtu.h"

namespace coapt {
namespace {

constexpr std::size_t kMostParts = 100;

/// Arrays of cells that number parts, in any case; the first that is there and has more than one number.
constexpr std::array<std::string_view, 15> kPartArrays = {
    "leaflet", "leaflets",  "leafletid", "label",          "labels",
    "region",  "regionid",  "part",      "partid",         "element_sets",
    "segment", "segmentid", "group",     "material_index", "material"};

using Segments = std::vector<std::array<int, 2>>;

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) {
    return static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
  });
  return text;
}

/// The points of segments that hang together, one after the other; none if they branch or do not.
std::vector<int> chained(const Segments& segments) {
  std::map<int, std::vector<int>> next;
  for (const auto& [a, b] : segments) {
    if (a == b) continue;
    next[a].push_back(b);
    next[b].push_back(a);
  }
  int start = next.empty() ? -1 : next.begin()->first;
  for (auto& [point, ways] : next) {
    std::sort(ways.begin(), ways.end());
    ways.erase(std::unique(ways.begin(), ways.end()), ways.end());
    if (ways.size() > 2) return {};
    if (ways.size() == 1) start = point;
  }
  std::vector<int> chain;
  std::set<int> seen;
  for (int at = start; at >= 0;) {
    chain.push_back(at);
    seen.insert(at);
    int to = -1;
    for (const int way : next[at])
      if (to < 0 && !seen.contains(way)) to = way;
    at = to;
  }
  if (seen.size() != next.size()) return {};
  return chain;
}

Points line_of(const Segments& segments, const Points& vertices_mm) {
  return vertices_mm(chained(segments), Eigen::all);
}

/// One part a number, in the order of the numbers. @param of_face a number for each face
void add_parts(const TriangleMesh& mesh, const std::vector<int>& of_face, MeshParts& parts,
               const std::map<int, std::string>& names, const std::map<int, Segments>& lines) {
  std::set<int> numbers(of_face.begin(), of_face.end());
  for (const auto& [number, segments] : lines) numbers.insert(number);
  for (const int number : numbers) {
    MeshPart& part = parts.parts.emplace_back();
    if (const auto name = names.find(number); name != names.end()) part.name = name->second;
    std::vector<bool> kept;
    for (const int of : of_face) kept.push_back(of == number);
    part.mesh = part_of(mesh, kept);
    if (const auto line = lines.find(number); line != lines.end())
      part.line_mm = line_of(line->second, mesh.vertices_mm);
  }
}

/// The piece of each face; small ones are of the largest.
std::vector<int> large_pieces(const TriangleMesh& mesh) {
  const std::vector<int> piece = face_pieces(mesh.faces);
  std::map<int, double> areas;
  for (std::size_t f = 0; f < piece.size(); ++f)
    areas[piece[f]] += area_vector(mesh, static_cast<Eigen::Index>(f)).norm();
  const auto largest = std::max_element(
      areas.begin(), areas.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
  std::vector<int> of_face;
  for (const int number : piece)
    of_face.push_back(areas[number] < kIslandShare * largest->second ? largest->first : number);
  return of_face;
}

std::size_t count_of(const std::vector<int>& numbers) {
  return std::set<int>(numbers.begin(), numbers.end()).size();
}

/// Sheets that do not hang together, if the file does not tell its parts otherwise: two that share no points in the file may touch.
MeshParts in_large_pieces(TriangleMesh mesh) {
  std::vector<int> of_face = large_pieces(mesh);
  if (count_of(of_face) != 2) of_face = large_pieces(welded(mesh));
  MeshParts parts;
  if (count_of(of_face) > kMostParts || count_of(of_face) < 2) {
    parts.parts.push_back({"", std::move(mesh), {}});
    return parts;
  }
  parts.told_apart_by = "connected components";
  add_parts(mesh, of_face, parts, {}, {});
  return parts;
}

MeshParts grouped_parts(GroupedMesh file) {
  std::map<int, std::string> names;
  for (std::size_t i = 0; i < file.groups.size(); ++i) names[static_cast<int>(i)] = file.groups[i];
  std::vector<int> of_face;
  for (const int polygon : file.mesh.polygons)
    of_face.push_back(file.group_of_polygon[static_cast<std::size_t>(polygon)]);
  std::map<int, Segments> lines;
  for (const GroupedLine& line : file.lines)
    for (std::size_t k = 1; k < line.points.size(); ++k)
      lines[line.group].push_back({line.points[k - 1], line.points[k]});
  std::set<int> used(of_face.begin(), of_face.end());
  for (const auto& [group, segments] : lines) used.insert(group);
  if (used.size() < 2 || used.size() > kMostParts) {
    if (file.mesh.faces.rows() > 0) return in_large_pieces(std::move(file.mesh));
    MeshParts parts;
    Segments all;
    for (const auto& [group, segments] : lines)
      all.insert(all.end(), segments.begin(), segments.end());
    Points line = line_of(all, file.mesh.vertices_mm);
    parts.parts.push_back({"", std::move(file.mesh), std::move(line)});
    return parts;
  }
  MeshParts parts;
  parts.told_apart_by = file.grouped_by;
  add_parts(file.mesh, of_face, parts, names, lines);
  return parts;
}

MeshParts stl_parts(StlFile file) {
  std::vector<int> of_face;
  for (const int polygon : file.mesh.polygons)
    if (const auto i = static_cast<std::size_t>(polygon); i < file.solid_of_polygon.size())
      of_face.push_back(file.solid_of_polygon[i]);
  const std::set<int> used(of_face.begin(), of_face.end());
  if (used.size() < 2 || used.size() > kMostParts) return in_large_pieces(std::move(file.mesh));
  std::map<int, std::string> names;
  for (std::size_t i = 0; i < file.solids.size(); ++i) names[static_cast<int>(i)] = file.solids[i];
  MeshParts parts;
  parts.told_apart_by = "solids";
  add_parts(file.mesh, of_face, parts, names, {});
  return parts;
}

struct FaceNumbers {
  std::string name;
  std::vector<double> of_face;
  const char* of = "cells";  ///< what the file numbers
};

bool numbers_parts(std::string_view array) {
  return std::find(kPartArrays.begin(), kPartArrays.end(), lower(std::string(array))) !=
         kPartArrays.end();
}

/// Of whole numbers of the points: that of two corners of a triangle, else the middle one; none if they are no such numbers.
std::vector<double> by_corners(const Faces& faces, const std::vector<double>& of_point,
                               Eigen::Index points) {
  std::vector<double> of_face;
  if (std::ssize(of_point) != points ||
      std::any_of(of_point.begin(), of_point.end(),
                  [](double number) { return number != std::floor(number); }))
    return of_face;
  for (const auto& face : faces.rowwise()) {
    const auto corner = [&](int k) { return of_point[static_cast<std::size_t>(face[k])]; };
    const double a = corner(0), b = corner(1), c = corner(2);
    of_face.push_back(std::max(std::min(a, b), std::min(std::max(a, b), c)));
  }
  return of_face;
}

/// @param arrays that have a number for each face
MeshParts parts_by_number(TriangleMesh mesh, const std::vector<FaceNumbers>& arrays,
                          const FaceNumbers*& used) {
  for (const std::string_view known : kPartArrays)
    for (const FaceNumbers& array : arrays) {
      if (lower(array.name) != known) continue;
      const std::set<double> values(array.of_face.begin(), array.of_face.end());
      // Three leaflets are another valve; other arrays that number many parts mean something else.
      if (values.size() < 2 || (values.size() > 2 && !known.starts_with("leaflet")) ||
          values.size() > kMostParts)
        continue;
      std::vector<int> of_face;
      std::map<int, std::string> names;
      for (const double value : array.of_face) {
        of_face.push_back(static_cast<int>(std::distance(values.begin(), values.find(value))));
        names[of_face.back()] = "number " + significant(value, 3);
      }
      MeshParts parts;
      parts.told_apart_by = "the array " + lower(array.name) + " of the " + array.of;
      used = &array;
      add_parts(mesh, of_face, parts, names, {});
      return parts;
    }
  return in_large_pieces(std::move(mesh));
}

/// @param others that nothing reads
MeshParts array_parts(TriangleMesh mesh, const std::vector<FaceNumbers>& arrays,
                      std::vector<std::string> others = {}) {
  const FaceNumbers* used = nullptr;
  MeshParts parts = parts_by_number(std::move(mesh), arrays, used);
  parts.arrays.of = arrays.size() + others.size();
  for (const FaceNumbers& array : arrays)
    if (&array != used) parts.arrays.names.push_back(array.name);
  parts.arrays.names.insert(parts.arrays.names.end(), others.begin(), others.end());
  return parts;
}

MeshParts ply_parts(PlyFile file) {
  std::vector<FaceNumbers> arrays;
  const auto& polygons = file.mesh.polygons;
  const int last = polygons.empty() ? -1 : *std::max_element(polygons.begin(), polygons.end());
  for (PlyNumbers& numbers : file.face_numbers) {
    if (std::ssize(numbers.of_polygon) <= last) continue;
    FaceNumbers& array = arrays.emplace_back();
    array.name = std::move(numbers.name);
    array.of = "faces";
    for (const int polygon : polygons)
      array.of_face.push_back(numbers.of_polygon[static_cast<std::size_t>(polygon)]);
  }
  return array_parts(std::move(file.mesh), arrays);
}

MeshParts vtk_parts(VtkPolyData data) {
  Points line = line_of(data.lines, data.points_mm);
  MeshParts parts;
  if (data.faces.rows() > 0) {
    std::vector<FaceNumbers> arrays;
    for (VtkScalars& scalars : data.face_data)
      arrays.push_back({scalars.name, std::move(scalars.values)});
    for (const VtkScalars& scalars : data.point_data) {
      if (!numbers_parts(scalars.name)) continue;
      std::vector<double> of_face = by_corners(data.faces, scalars.values, data.points_mm.rows());
      if (!of_face.empty()) arrays.push_back({scalars.name, std::move(of_face), "points"});
    }
    parts = array_parts({std::move(data.points_mm), std::move(data.faces), {}}, arrays);
  }
  if (line.rows() > 0)
    parts.parts.push_back({"", {Points(0, 3), Faces(0, 3), {}}, std::move(line)});
  return parts;
}

MeshParts grid_parts(VtuGrid grid) {
  std::vector<FaceNumbers> arrays;
  std::vector<std::string> others;
  std::vector<FaceNumbers> of_points;
  for (const VtuArray& array : grid.point_data) {
    std::vector<double> of_face;
    if (array.components == 1 && numbers_parts(array.name))
      of_face = by_corners(grid.mesh.faces, array.values, grid.mesh.vertices_mm.rows());
    if (of_face.empty())
      others.push_back(array.name);
    else
      of_points.push_back({array.name, std::move(of_face), "points"});
  }
  for (const VtuArray& array : grid.cell_data) {
    if (array.components != 1 || !numbers_parts(array.name)) {
      others.push_back(array.name);
      continue;
    }
    FaceNumbers& numbers = arrays.emplace_back();
    numbers.name = array.name;
    for (const int cell : grid.mesh.polygons)
      numbers.of_face.push_back(array.values[static_cast<std::size_t>(cell)]);
  }
  // Of one name that of the cells comes first.
  arrays.insert(arrays.end(), of_points.begin(), of_points.end());
  return array_parts(std::move(grid.mesh), arrays, std::move(others));
}

}  // namespace

Expected<MeshParts> read_mesh_parts(std::string_view bytes, std::string_view format,
                                    std::size_t most_unpacked) {
  const auto parts_of = [](auto read, auto parts) -> Expected<MeshParts> {
    if (!read) return read.errors();
    return parts(*std::move(read));
  };
  if (format == "obj") return parts_of(read_obj_file(bytes), grouped_parts);
  if (is_gltf_format(format)) return parts_of(read_gltf(bytes), grouped_parts);
  if (format == "stl") return parts_of(read_stl_file(bytes), stl_parts);
  if (format == "ply") return parts_of(read_ply_file(bytes), ply_parts);
  if (format == "vtk") return parts_of(read_vtk(bytes), vtk_parts);
  if (format == "vtp") {
    Expected<MeshParts> parts = parts_of(read_vtp(bytes, numbers_parts, most_unpacked), grid_parts);
    const Expected<VtpLines> lines = read_vtp_lines(bytes, most_unpacked);
    if (parts && lines)
      if (Points line = line_of(lines->pieces, lines->points_mm); line.rows() > 0)
        parts->parts.push_back({"", {Points(0, 3), Faces(0, 3), {}}, std::move(line)});
    return parts;
  }
  if (format == "vtu") return parts_of(read_vtu(bytes, numbers_parts, most_unpacked), grid_parts);
  return parts_of(read_mesh(bytes, format), in_large_pieces);
}

Expected<Points> read_mesh_line(std::string_view bytes, std::string_view format) {
  Segments segments;
  Points points;
  if (format == "obj" || is_gltf_format(format)) {
    const Expected<GroupedMesh> file = format == "obj" ? read_obj_file(bytes) : read_gltf(bytes);
    if (!file) return file.errors();
    points = file->mesh.vertices_mm;
    for (const GroupedLine& line : file->lines)
      for (std::size_t k = 1; k < line.points.size(); ++k)
        segments.push_back({line.points[k - 1], line.points[k]});
  } else if (format == "vtp") {
    Expected<VtpLines> lines = read_vtp_lines(bytes, kMostUnpackedSent);
    if (!lines) return lines.errors();
    points = std::move(lines->points_mm);
    segments = std::move(lines->pieces);
  } else {
    const Expected<VtkPolyData> data = read_vtk(bytes);
    if (!data) return data.errors();
    points = data->points_mm;
    segments = data->lines;
  }
  Points line = line_of(segments, points);
  if (line.rows() > 0) return line;
  return Error{segments.empty() ? ErrorCode::MissingField : ErrorCode::BadTopology, "/lines",
               segments.empty() ? "is empty; a closed loop needs lines"
                                : "do not form a single loop; an annulus must be one loop"};
}

}  // namespace coapt
