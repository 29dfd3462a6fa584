#include "shell_scene.h"

#include <array>
#include <cmath>
#include <map>
#include <random>

#include "core/closure/closure.h"
#include "core/metrics/surface_tree.h"
#include "core/presets/presets.h"
#include "core/valve/leaflet_coordinates.h"
#include "io/mesh/sheet_repair.h"

namespace coapt {
namespace {

Points normals_of(const TriangleMesh& mesh) {
  Points normals = Points::Zero(mesh.vertices_mm.rows(), 3);
  for (const auto& face : mesh.faces.rowwise()) {
    const Vec3 a = mesh.vertices_mm.row(face[0]), b = mesh.vertices_mm.row(face[1]),
               c = mesh.vertices_mm.row(face[2]);
    for (const int v : face) normals.row(v) += (b - a).cross(c - a).transpose();
  }
  return normals.rowwise().normalized();
}

}  // namespace

TriangleMesh thickened(const TriangleMesh& sheet, double thickness_mm, double noise_mm) {
  const Points normals = normals_of(sheet);
  const Eigen::Index n = sheet.vertices_mm.rows(), m = sheet.faces.rows();
  std::mt19937_64 engine(7);
  std::normal_distribution<double> deviate(0.0, 1.0);
  TriangleMesh shell{Points(2 * n, 3), sheet.faces};
  for (Eigen::Index v = 0; v < 2 * n; ++v)
    shell.vertices_mm.row(v) =
        sheet.vertices_mm.row(v % n) +
        ((v < n ? 0.5 : -0.5) * thickness_mm + noise_mm * deviate(engine)) * normals.row(v % n);
  std::vector<std::array<int, 2>> rim;
  for (const std::vector<int>& loop : boundary_loops(sheet))
    for (std::size_t i = 0; i < loop.size(); ++i)
      rim.push_back({loop[i], loop[(i + 1) % loop.size()]});
  shell.faces.conservativeResize(2 * m + 2 * std::ssize(rim), 3);
  for (Eigen::Index f = 0; f < m; ++f)
    shell.faces.row(m + f) << sheet.faces(f, 0) + static_cast<int>(n),
        sheet.faces(f, 2) + static_cast<int>(n), sheet.faces(f, 1) + static_cast<int>(n);
  Eigen::Index f = 2 * m;
  for (const auto& [a, b] : rim) {
    const int under_a = a + static_cast<int>(n), under_b = b + static_cast<int>(n);
    shell.faces.row(f++) << b, a, under_a;
    shell.faces.row(f++) << b, under_a, under_b;
  }
  return shell;
}

TriangleMesh voxel_shell(const TriangleMesh& sheet, double thickness_mm, double voxel_mm) {
  const SurfaceTree tree(sheet.vertices_mm, sheet.faces);
  const Vec3 low = sheet.vertices_mm.colwise().minCoeff().transpose() -
                   Vec3::Constant(thickness_mm + 2.0 * voxel_mm);
  const Vec3 size = sheet.vertices_mm.colwise().maxCoeff().transpose() +
                    Vec3::Constant(thickness_mm + 2.0 * voxel_mm) - low;
  const Eigen::Array3i count = (size / voxel_mm).array().ceil().cast<int>();
  const auto number = [&](int i, int j, int k) { return (k * count[1] + j) * count[0] + i; };
  std::vector<bool> inside(static_cast<std::size_t>(count.prod()));
  for (int k = 0; k < count[2]; ++k)
    for (int j = 0; j < count[1]; ++j)
      for (int i = 0; i < count[0]; ++i)
        inside[static_cast<std::size_t>(number(i, j, k))] =
            tree.nearest_within(low + voxel_mm * Vec3(i + 0.5, j + 0.5, k + 0.5),
                                0.5 * thickness_mm, [](int) { return true; })
                .face >= 0;
  std::map<std::array<int, 3>, int> corners;
  std::vector<Eigen::RowVector3i> faces;
  const auto corner = [&](std::array<int, 3> at) {
    return corners.emplace(at, static_cast<int>(corners.size())).first->second;
  };
  for (int k = 1; k + 1 < count[2]; ++k)
    for (int j = 1; j + 1 < count[1]; ++j)
      for (int i = 1; i + 1 < count[0]; ++i) {
        if (!inside[static_cast<std::size_t>(number(i, j, k))]) continue;
        for (int axis = 0; axis < 3; ++axis)
          for (const int way : {0, 1}) {
            std::array<int, 3> beyond = {i, j, k};
            beyond[static_cast<std::size_t>(axis)] += way == 1 ? 1 : -1;
            if (inside[static_cast<std::size_t>(number(beyond[0], beyond[1], beyond[2]))]) continue;
            const auto u = static_cast<std::size_t>((axis + 1) % 3),
                       v = static_cast<std::size_t>((axis + 2) % 3);
            std::array<int, 3> base = {i, j, k};
            base[static_cast<std::size_t>(axis)] += way;
            std::array<int, 4> quad{};
            for (std::size_t q = 0; q < 4; ++q) {
              std::array<int, 3> at = base;
              if (q == 1 || q == 2) ++at[u];
              if (q == 2 || q == 3) ++at[v];
              quad[q] = corner(at);
            }
            if (way == 0) std::swap(quad[1], quad[3]);
            faces.push_back({quad[0], quad[1], quad[2]});
            faces.push_back({quad[0], quad[2], quad[3]});
          }
      }
  TriangleMesh shell{Points(std::ssize(corners), 3), Faces(std::ssize(faces), 3)};
  for (const auto& [at, v] : corners)
    shell.vertices_mm.row(v) = (low + voxel_mm * Vec3(at[0], at[1], at[2])).transpose();
  for (std::size_t f = 0; f < faces.size(); ++f)
    shell.faces.row(static_cast<Eigen::Index>(f)) = faces[f];
  return shell;
}

ImportSource preset_leaflets(const char* preset, bool closed) {
  const Valve valve = *make_preset(preset);
  const TriangleMesh whole{closed ? close_valve(valve).closed_mm : valve.rest_mm, valve.faces};
  const LeafletCoordinates coordinates = leaflet_coordinates(valve);
  std::vector<bool> anterior;
  for (Eigen::Index f = 0; f < valve.faces.rows(); ++f) {
    double around = 0.0;
    for (const int v : valve.faces.row(f))
      around += coordinates.around[static_cast<std::size_t>(v)] < 0.5 ? 1.0 : 0.0;
    anterior.push_back(around >= 2.0);
  }
  ImportSource source;
  source.name = preset;
  source.leaflets.push_back(part_of(whole, anterior));
  anterior.flip();
  source.leaflets.push_back(part_of(whole, anterior));
  source.annulus_mm = whole.vertices_mm(valve.annulus, Eigen::all);
  if (closed) source.tissue = valve.tissue;
  return source;
}

}  // namespace coapt
