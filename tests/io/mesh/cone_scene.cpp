#include "cone_scene.h"

#include <cmath>
#include <numbers>

namespace coapt {

Vec3 on_cone(double angle_deg, double share) {
  const double angle = angle_deg * std::numbers::pi / 180.0;
  const double radius = kTop_mm + share * (kBottom_mm - kTop_mm);
  return {radius * std::cos(angle), radius * std::sin(angle), -share * kDepth_mm};
}

TriangleMesh cone(int from_deg, int to_deg) {
  constexpr int kRows = 10;
  const bool closed = to_deg - from_deg == 360;
  const int columns = to_deg - from_deg + (closed ? 0 : 1);
  TriangleMesh mesh{Points((kRows + 1) * columns, 3), Faces(2 * kRows * (to_deg - from_deg), 3)};
  for (int row = 0; row <= kRows; ++row) {
    for (int i = 0; i < columns; ++i) {
      mesh.vertices_mm.row(row * columns + i) =
          on_cone(from_deg + i, static_cast<double>(row) / kRows);
    }
  }
  for (int row = 0, f = 0; row < kRows; ++row) {
    for (int i = 0; i < to_deg - from_deg; ++i, f += 2) {
      const int a = row * columns + i, b = row * columns + (i + 1) % columns;
      mesh.faces.row(f) << a, b, a + columns;
      mesh.faces.row(f + 1) << b, b + columns, a + columns;
    }
  }
  return mesh;
}

ImportSource cone_source() {
  ImportSource source;
  source.name = "cone";
  source.provenance = {"made by hand"};
  source.leaflets = {cone(0, 360)};
  source.annulus_mm.resize(720, 3);
  for (int i = 0; i < 720; ++i) source.annulus_mm.row(i) = on_cone(0.5 * i, 0.0);
  source.chordae = {
      {"a", Side::Anterolateral, ChordaKind::Marginal, on_cone(180.0, 1.0), {-10.0, 0.0, -25.0}},
      {"b", Side::Posteromedial, ChordaKind::Marginal, on_cone(0.0, 1.0), {10.0, 0.0, -25.0}}};
  return source;
}

ImportSource cone_source_with_gaps() {
  ImportSource source = cone_source();
  source.leaflets = {cone(10, 170), cone(190, 350)};
  return source;
}

}  // namespace coapt
