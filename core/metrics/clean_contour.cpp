#include "core/metrics/clean_contour.h"

#include <cmath>
#include <cstddef>

namespace coapt {
namespace {

/// Of `point` to the line through `a` and `b`; NaN if they are one point.
double squared_distance_to_line(const Vec2& point, const Vec2& a, const Vec2& b) {
  const double x = a.y() - b.y(), y = b.x() - a.x();
  const double beyond = x * point.x() + y * point.y() - (x * a.x() + y * a.y());
  return beyond * beyond / (x * x + y * y);
}

/// Whether the one of three points that lies between the others lies near the line through them.
bool nearly_in_line(const Vec2& a, const Vec2& b, const Vec2& c, double squared_mm2) {
  const Vec2 way = (a - b).cwiseAbs();
  const int axis = way.x() > way.y() ? 0 : 1;
  if ((a[axis] > b[axis]) == (a[axis] < c[axis]))
    return squared_distance_to_line(a, b, c) < squared_mm2;
  if ((b[axis] > a[axis]) == (b[axis] < c[axis]))
    return squared_distance_to_line(b, a, c) < squared_mm2;
  return squared_distance_to_line(c, a, b) < squared_mm2;
}

}  // namespace

std::vector<Vec2> clean_contour(const std::vector<Vec2>& contour_mm, double distance_mm) {
  struct Corner {
    std::size_t before, after;
    bool is_kept = false;
  };
  const std::size_t count = contour_mm.size();
  std::vector<Corner> corners(count);
  for (std::size_t i = 0; i < count; ++i) corners[i] = {(i + count - 1) % count, (i + 1) % count};
  std::size_t left = count, here = 0;
  const auto drop = [&](std::size_t corner) {
    const auto [before, after, kept] = corners[corner];
    corners[before].after = after;
    corners[after].before = before;
    corners[before].is_kept = false;
    --left;
    return before;
  };
  const double squared_mm2 = distance_mm * distance_mm;
  const auto are_close = [&](std::size_t a, std::size_t b) {
    return (contour_mm[a] - contour_mm[b]).squaredNorm() <= squared_mm2;
  };
  while (count > 0 && !corners[here].is_kept && corners[here].after != corners[here].before) {
    const auto [before, after, kept] = corners[here];
    if (are_close(here, before)) {
      here = drop(here);
    } else if (are_close(before, after)) {
      drop(after);
      here = drop(here);
    } else if (nearly_in_line(contour_mm[before], contour_mm[here], contour_mm[after],
                              squared_mm2)) {
      here = drop(here);
    } else {
      corners[here].is_kept = true;
      here = after;
    }
  }
  std::vector<Vec2> cleaned;
  if (left < 3) return cleaned;
  cleaned.reserve(left);
  for (std::size_t i = 0; i < left; ++i, here = corners[here].after)
    cleaned.push_back(contour_mm[here]);
  return cleaned;
}

}  // namespace coapt
