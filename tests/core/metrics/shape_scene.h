// A dented bowl that no rigid motion takes onto itself, sampled as finely as asked.
#pragma once

#include <Eigen/Geometry>
#include <cmath>

#include "core/metrics/shape_comparison.h"

namespace coapt {

/// Columns by rows of cells over [x0, x1] x [y0, y1], mm; two triangles each, along the other diagonal if `flip`.
struct Patch {
  double x0 = -15.0, x1 = 15.0, y0 = -10.0, y1 = 10.0;
  int columns = 30, rows = 20;
  bool flip = false;
};

inline double bowl_height_mm(double x, double y) {
  return 0.03 * x * x + 0.05 * y * y + 0.002 * x * x * y + 0.5 * std::sin(0.4 * x + 0.3 * y);
}

template <class Height>
LeafletMesh patch(const Patch& of, const Height& height_mm) {
  Points points((of.columns + 1) * (of.rows + 1), 3);
  Faces faces(2 * of.columns * of.rows, 3);
  const auto number = [&](int i, int j) { return j * (of.columns + 1) + i; };
  for (int j = 0; j <= of.rows; ++j)
    for (int i = 0; i <= of.columns; ++i) {
      const double x = std::lerp(of.x0, of.x1, static_cast<double>(i) / of.columns);
      const double y = std::lerp(of.y0, of.y1, static_cast<double>(j) / of.rows);
      points.row(number(i, j)) << x, y, height_mm(x, y);
    }
  Eigen::Index face = 0;
  for (int j = 0; j < of.rows; ++j)
    for (int i = 0; i < of.columns; ++i) {
      const int a = number(i, j), b = number(i + 1, j), c = number(i + 1, j + 1),
                d = number(i, j + 1);
      if (of.flip) {
        faces.row(face++) << a, b, d;
        faces.row(face++) << b, c, d;
      } else {
        faces.row(face++) << a, b, c;
        faces.row(face++) << a, c, d;
      }
    }
  return in_pieces(points, faces);
}

inline LeafletMesh bowl(const Patch& of = {}) { return patch(of, bowl_height_mm); }

inline LeafletMesh plane(const Patch& of, double height_mm) {
  return patch(of, [&](double, double) { return height_mm; });
}

/// By an angle about the axis, then by the shift.
inline RigidMotion motion_of(double angle_deg, const Vec3& axis, const Vec3& shift_mm) {
  return {Eigen::AngleAxisd(angle_deg * 3.141592653589793 / 180.0, axis.normalized())
              .toRotationMatrix(),
          shift_mm};
}

inline LeafletMesh moved(LeafletMesh mesh, const RigidMotion& motion) {
  mesh.vertices_mm = moved(mesh.vertices_mm, motion);
  return mesh;
}

}  // namespace coapt
