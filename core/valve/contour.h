// The annulus as a closed contour in the valve's frame, from dimensions or from a measurement.
#pragma once

#include "core/valve/types.h"

namespace coapt {

/// 720 points, counter-clockwise seen from the atrium, starting at +x. Two half superellipses
/// (exponent 2.6 in front, 2.2 behind: a flat anterior side), 42 % of the anteroposterior diameter
/// in front of the widest place, and with_saddle(). For human end-systolic diameters and height
/// (PMC7368231) this gives that paper's area and circumference within 3 %.
Points generic_annulus_contour(double ap_mm, double al_pm_mm, double saddle_height_mm);

/// A planar contour (z = 0, the valve's frame) raised by height/2 x cos(2 phi), phi from the
/// anterior midpoint, about its new centroid.
Points with_saddle(const Points& planar_mm, double height_mm);

/// Mean of a closed contour, weighted by arc length.
Vec3 arc_centroid(const Points& contour_mm);

struct MeasuredSkeleton {
  Points annulus_mm;  ///< n x 3, counter-clockwise seen from the atrium
  Points tips_mm;     ///< m x 3
};

/// Moves a measured contour and its papillary tips (any frame, n x 3 and m x 3) into the valve's
/// frame: plane by least squares, atrium away from the tips, x along the line between the two
/// clusters of tips. Two signs tell anterior, added in mm: the tips lie behind the centre, and the
/// contour is flatter in front (its smaller extent from the centroid). A posterior displacement of
/// the tips outweighs the shape of an irregular contour.
MeasuredSkeleton into_valve_frame(const Points& annulus_mm, const Points& tips_mm);

/// Point at a share of the arc length of a closed contour, from its first point; wraps.
class ArcLength {
 public:
  explicit ArcLength(const Points& contour_mm);
  double total_mm() const { return length_mm_.back(); }
  Vec3 at(double arc_mm) const;
  Vec3 tangent(double arc_mm) const;  ///< unit, over 2 % of the contour
  /// Arc of the crossing of the half-plane x = 0, y > 0 (or y < 0).
  double crossing_mm(bool anterior) const;

 private:
  Points contour_mm_;
  std::vector<double> length_mm_;  // at each point, then the total
};

}  // namespace coapt
