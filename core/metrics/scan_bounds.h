// What bounds the open part of scan lines x = const (openings_sweep.cpp): edges of outlines, and
// segments grown by a radius, which a line meets in one interval.
#pragma once

#include "core/metrics/annulus.h"

namespace coapt {

enum class Cover { Outline, Tissue, Grown };

struct ScanBound {
  Cover cover = Cover::Outline;
  int number = 0;          ///< those of edges that meet differ by one, all others by more
  int winding = 1;         ///< what an edge adds where a line crosses it in the direction of y
  Vec2 from_mm, to_mm;     ///< from.x <= to.x
  double slope = 0.0;      ///< y over x, 0 along y
  double radius_mm = 0.0;  ///< of a grown segment
  Vec2 aside_mm = Vec2::Zero();          ///< of a grown segment: to the straight part above it
  double first_mm = 0.0, last_mm = 0.0;  ///< lines with first <= x < last meet it
};

/// From a to b, rounded to the grid.
ScanBound edge_bound(const Vec2& a_mm, const Vec2& b_mm);
ScanBound grown_bound(const Vec2& a_mm, const Vec2& b_mm, double radius_mm);

/// y of an edge on a line that meets it.
double edge_at(const ScanBound& bound, double x_mm);

/// y of a grown segment's upper side (`side` 1) or lower one (-1) on a line that meets it: an arc,
/// a straight part, another arc.
double side_at(const ScanBound& bound, double x_mm, double side);

}  // namespace coapt
