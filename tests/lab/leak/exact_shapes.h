// Sheets with one hole each, whose leak is known exactly.
#pragma once

#include <cmath>
#include <functional>
#include <numbers>

#include "lab/leak/leak_surface.h"

namespace coapt {

inline constexpr int kAround = 144;  ///< corners of the rim and of the outer circle

/// From a circle of radius `outer_mm` at height 0 straight to a rim, whose corner `i` of kAround `rim_mm` gives. All is moved off the
/// lattice's planes, by shares of a voxel.
inline LeakSurface funnel(double outer_mm, const std::function<Vec3(int)>& rim_mm) {
  constexpr int kRows = 8;
  LeakSurface sheet;
  sheet.half_thickness_mm = 0.5;
  sheet.points_mm.resize(kAround * (kRows + 1), 3);
  sheet.faces.resize(2 * kAround * kRows, 3);
  Index face = 0;
  for (int row = 0; row <= kRows; ++row)
    for (int i = 0; i < kAround; ++i) {
      const double angle = 2.0 * std::numbers::pi * (i + 4) / kAround;
      const Vec3 outer(outer_mm * std::cos(angle), outer_mm * std::sin(angle), 0.0);
      const Vec3 point = outer + (rim_mm(i) - outer) * row / kRows;
      sheet.points_mm.row(row * kAround + i) = point + Vec3(0.137, -0.211, 0.093);
      if (row == 0) sheet.annulus.push_back(i);
      if (row == kRows) continue;
      const int a = row * kAround + i, b = row * kAround + (i + 1) % kAround;
      sheet.faces.row(face++) << a, b, a + kAround;
      sheet.faces.row(face++) << b, b + kAround, a + kAround;
    }
  return sheet;
}

inline std::function<Vec3(int)> circle(double radius_mm, double height_mm) {
  return [=](int i) {
    const double angle = 2.0 * std::numbers::pi * (i + 4) / kAround;
    return Vec3(radius_mm * std::cos(angle), radius_mm * std::sin(angle), height_mm);
  };
}

/// Its corners are among the rim's; it lies askew to the lattice.
inline std::function<Vec3(int)> slit(double length_mm, double width_mm, double height_mm) {
  return [=](int i) {
    constexpr int kLong = kAround / 2 - 8, kShort = 8;
    const int at = i % (kAround / 2);
    const double along = std::min(1.0, static_cast<double>(at) / kLong) - 0.5;
    const double across = 0.5 - std::max(0.0, static_cast<double>(at - kLong) / kShort);
    const double side = i < kAround / 2 ? 1.0 : -1.0;
    const Vec3 flat(-side * along * length_mm, side * across * width_mm, height_mm);
    return Vec3(Eigen::AngleAxisd(0.4, Vec3::UnitZ()) * flat);
  };
}

/// z grows by x slope.x + y slope.y.
inline LeakSurface sheared(LeakSurface sheet, const Vec2& slope) {
  sheet.points_mm.col(2) += sheet.points_mm.leftCols<2>() * slope;
  return sheet;
}

}  // namespace coapt
