#include "tests/fuzz/damaged_leaflets.h"

#include <cmath>
#include <numbers>

namespace coapt {
namespace {

/// Part of a funnel from 18 to 12 mm in radius, 15 mm deep, in 8 x 2 cells; `thick` with two sides.
TriangleMesh funnel(double from, double to, bool thick) {
  constexpr int kColumns = 9, kRows = 3;
  const int layer = kColumns * kRows, layers = thick ? 2 : 1;
  TriangleMesh mesh{Points(layers * layer, 3), Faces(0, 3)};
  for (int v = 0; v < layers * layer; ++v) {
    const double share = v % layer / kColumns / (kRows - 1.0);
    const double angle = from + (to - from) * (v % kColumns) / (kColumns - 1.0);
    const double radius = 18.0 - 6.0 * share + (v >= layer ? 2.0 : 0.0);
    mesh.vertices_mm.row(v) << radius * std::cos(angle), radius * std::sin(angle), -15.0 * share;
  }
  std::vector<Eigen::RowVector3i> faces;
  const auto quad = [&](int a, int b, int c, int d) {
    faces.push_back({a, b, c});
    faces.push_back({a, c, d});
  };
  for (int l = 0; l < layers; ++l)
    for (int j = 0; j + 1 < kRows; ++j)
      for (int i = 0; i + 1 < kColumns; ++i) {
        const int a = l * layer + j * kColumns + i, c = a + kColumns;
        l == 0 ? quad(a, a + 1, c + 1, c) : quad(a, c, c + 1, a + 1);
      }
  for (int i = 0; thick && i + 1 < kColumns; ++i) {
    quad(i + 1, i, i + layer, i + 1 + layer);
    const int last = (kRows - 1) * kColumns + i;
    quad(last, last + 1, last + 1 + layer, last + layer);
  }
  for (int j = 0; thick && j + 1 < kRows; ++j) {
    const int a = j * kColumns, b = a + kColumns - 1;
    quad(a, a + kColumns, a + kColumns + layer, a + layer);
    quad(b + kColumns, b, b + layer, b + kColumns + layer);
  }
  mesh.faces.resize(static_cast<Eigen::Index>(faces.size()), 3);
  for (std::size_t f = 0; f < faces.size(); ++f)
    mesh.faces.row(static_cast<Eigen::Index>(f)) = faces[f];
  return mesh;
}

/// Four bytes each: which mesh and what is done, a vertex, a face, how far.
void damage(std::vector<TriangleMesh>& meshes, const std::uint8_t* bytes, std::size_t size) {
  for (std::size_t i = 0; i + 3 < size; i += 4) {
    TriangleMesh& mesh = meshes[bytes[i] % meshes.size()];
    const auto v = bytes[i + 1] % mesh.vertices_mm.rows();
    const auto f = bytes[i + 2] % mesh.faces.rows();
    const double share = (bytes[i + 3] - 128) / 16.0;
    switch (bytes[i] / 2 % 8) {
      case 0:
        mesh.vertices_mm(v, f % 3) += share;
        break;
      case 1:
        mesh.vertices_mm.row(v) = mesh.vertices_mm.row(f % mesh.vertices_mm.rows());
        break;
      case 2:
        mesh.faces(f, bytes[i + 3] % 3) = static_cast<int>(v);
        break;
      case 3:
        mesh.faces.row(f) = mesh.faces.row(bytes[i + 3] % mesh.faces.rows()).eval();
        break;
      case 4:
        mesh.faces.row(f).reverseInPlace();
        break;
      case 5:
        if (mesh.faces.rows() > 1) {
          mesh.faces.row(f) = mesh.faces.row(mesh.faces.rows() - 1).eval();
          mesh.faces.conservativeResize(mesh.faces.rows() - 1, 3);
        }
        break;
      case 6:
        mesh.vertices_mm.col(v % 3) *= share;
        break;
      default:
        mesh.vertices_mm(v, f % 3) = std::ldexp(share, bytes[i + 3] * 8 - 1020);
        break;
    }
  }
}

/// Where the leaflets begin: 24 points, 18 mm from the axis.
Points round_annulus() {
  Points annulus_mm(24, 3);
  for (int i = 0; i < 24; ++i) {
    const double angle = i * std::numbers::pi / 12;
    annulus_mm.row(i) << 18.0 * std::cos(angle), 18.0 * std::sin(angle), 0.0;
  }
  return annulus_mm;
}

}  // namespace

ImportSource damaged_source(int given, const std::uint8_t* bytes, std::size_t size) {
  constexpr double kPi = std::numbers::pi;
  ImportSource source;
  source.leaflets = {funnel(0.1, kPi - 0.1, (given & 1) != 0)};
  if ((given & 2) == 0)
    source.leaflets.push_back(funnel(kPi + 0.1, 2 * kPi - 0.1, (given & 4) != 0));
  damage(source.leaflets, bytes, size);
  if ((given & 8) == 0) source.annulus_mm = round_annulus();
  if ((given & 16) != 0)
    source.tips = {{Side::Anterolateral, {-10.0, 0.0, -25.0}},
                   {Side::Posteromedial, {10.0, 0.0, -25.0}}};
  return source;
}

}  // namespace coapt
