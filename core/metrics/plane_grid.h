// The grid of 2^-20 mm on which tissue in a plane is measured: sums and products of whole numbers
// are exact.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/metrics/annulus.h"

namespace coapt {

constexpr double kGridPerMm = 1 << 20;  // 2^30 is the most that Clipper takes at full speed
constexpr double kFarthest_mm = 1000.0;

struct GridPoint {
  std::int64_t x = 0, y = 0;
};

/// Rounded; coordinates over 1 m are taken as 1 m.
inline GridPoint to_grid(const Vec2& point_mm) {
  const auto round = [](double mm) -> std::int64_t {
    return std::llround(std::clamp(mm, -kFarthest_mm, kFarthest_mm) * kGridPerMm);
  };
  return {round(point_mm.x()), round(point_mm.y())};
}

/// In millimetres, exact.
inline Vec2 from_grid(const GridPoint& point) {
  return Vec2(static_cast<double>(point.x), static_cast<double>(point.y)) / kGridPerMm;
}

}  // namespace coapt
