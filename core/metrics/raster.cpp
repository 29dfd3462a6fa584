#include "core/metrics/raster.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace coapt {
namespace {

/// First row or column whose centre is at `edge_px` or beyond, in [0, count]; 0 for NaN.
int first_centre(double edge_px, int count) {
  const double position = edge_px - 0.5;
  if (!(position > 0.0)) return 0;
  if (position >= count) return count;
  const int below = static_cast<int>(position);
  return below < position ? below + 1 : below;
}

/// One past the last row or column whose centre is at `edge_px` or before, in [0, count]; 0 for
/// NaN.
int end_centre(double edge_px, int count) {
  const double position = edge_px - 0.5;
  if (!(position >= 0.0)) return 0;
  return position < count ? static_cast<int>(position) + 1 : count;
}

/// What a convex shape covers of each row: from left to right, nothing if left > right.
struct RowIntervals {
  std::vector<double> left, right;
  explicit RowIntervals(int height) : left(height), right(height) {}

  void clear(int first, int end) {
    std::fill(left.begin() + first, left.begin() + end, std::numeric_limits<double>::infinity());
    std::fill(right.begin() + first, right.begin() + end, -std::numeric_limits<double>::infinity());
  }
  void include(int row, double x_low, double x_high) {
    left[row] = std::min(left[row], x_low);
    right[row] = std::max(right[row], x_high);
  }
  int height() const { return static_cast<int>(left.size()); }
};

/// The edge from a to b (a the lower end), shifted sideways both ways. Which way is outwards does
/// not matter: shifted inwards it lies inside. A horizontal edge adds nothing to the ends of its
/// neighbours.
void include_edge(RowIntervals& rows, const Vec2& a, const Vec2& b, double radius_px) {
  if (!(a.y() < b.y())) return;
  const double slope = (b.x() - a.x()) / (b.y() - a.y());
  const Vec2 along = radius_px > 0.0 ? Vec2((b - a).normalized() * radius_px) : Vec2::Zero();
  for (const Vec2& shift : {Vec2(-along.y(), along.x()), Vec2(along.y(), -along.x())}) {
    const Vec2 start = a + shift;
    const int end = end_centre(b.y() + shift.y(), rows.height());
    for (int row = first_centre(start.y(), rows.height()); row < end; ++row) {
      const double x = start.x() + (row + 0.5 - start.y()) * slope;
      rows.include(row, x, x);
    }
    if (radius_px == 0.0) return;
  }
}

void include_disc(RowIntervals& rows, const Vec2& centre, double radius_px) {
  const int end = end_centre(centre.y() + radius_px, rows.height());
  for (int row = first_centre(centre.y() - radius_px, rows.height()); row < end; ++row) {
    const double rise = row + 0.5 - centre.y();
    const double half = std::sqrt(std::max(0.0, radius_px * radius_px - rise * rise));
    rows.include(row, centre.x() - half, centre.x() + half);
  }
}

}  // namespace

int mark_polygon(Mask& mask, const std::vector<Vec2>& polygon_px) {
  int count = 0;
  std::vector<double> crossings;
  for (int row = 0; row < mask.height; ++row) {
    const double y = row + 0.5;
    crossings.clear();
    for (std::size_t i = 0; i < polygon_px.size(); ++i) {
      const Vec2& a = polygon_px[i];
      const Vec2& b = polygon_px[(i + 1) % polygon_px.size()];
      if ((a.y() <= y) != (b.y() <= y))
        crossings.push_back(a.x() + (y - a.y()) * (b.x() - a.x()) / (b.y() - a.y()));
    }
    std::sort(crossings.begin(), crossings.end());
    for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
      const int first = first_centre(crossings[i], mask.width);
      const int end = first_centre(crossings[i + 1], mask.width);
      std::fill(mask.pixels.begin() + row * mask.width + first,
                mask.pixels.begin() + row * mask.width + end, std::uint8_t{1});
      count += end - first;
    }
  }
  return count;
}

void cover_triangles(Mask& mask, const std::vector<Triangle>& triangles_px, double radius_px) {
  RowIntervals rows(mask.height);
  for (const Triangle& triangle : triangles_px) {
    const auto [low, high] = std::minmax({triangle[0].y(), triangle[1].y(), triangle[2].y()});
    const int first_row = first_centre(low - radius_px, mask.height);
    const int end_row = std::max(first_row, end_centre(high + radius_px, mask.height));
    rows.clear(first_row, end_row);
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec2 &a = triangle[i], &b = triangle[(i + 1) % 3];
      a.y() < b.y() ? include_edge(rows, a, b, radius_px) : include_edge(rows, b, a, radius_px);
      include_disc(rows, a, radius_px);
    }
    for (int row = first_row; row < end_row; ++row) {
      const int first = first_centre(rows.left[row], mask.width);
      const int end = end_centre(rows.right[row], mask.width);
      if (first < end) std::memset(&mask.pixels[row * mask.width + first], 0, end - first);
    }
  }
}

}  // namespace coapt
