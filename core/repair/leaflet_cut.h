// The tissue that a resection takes, in leaflet coordinates.
#pragma once

#include <array>

#include "core/repair/plan.h"

namespace coapt {

class LeafletCut {
 public:
  LeafletCut(const LeafletResection& step, const LeafletCoordinates& coordinates,
             const Valve& valve);

  const LeafletResection& step() const { return step_; }

  /// Of what is taken at a height.
  double width_mm(double height) const;
  /// The same, of `along`.
  double width_along(double height) const { return width_mm(height) / row_mm(height); }
  /// Of a row at that height, per unit of `along` about the middle of the cut.
  double row_mm(double height) const;
  /// Of the leaflet there, from annulus to free edge.
  double height_mm() const { return height_mm_; }

  /// Which tissue a vertex at `along` stands for after the resection, as seen from the side of the
  /// seam that is told (for a vertex on the seam both count): -1 anterolateral, 1 posteromedial.
  double tissue_at(double along, double height, int side) const;
  /// Where tissue lies afterwards; that which was taken at the seam.
  double place_of(double tissue_along, double height) const;
  bool takes(double tissue_along, double height) const;

  /// Length on what is left of a line across the seam over its length before; from a vertex on the
  /// anterolateral side to one on the other, {along, height} each.
  double across_seam(const std::array<double, 2>& from, const std::array<double, 2>& to) const;

 private:
  static constexpr int kRows = 8;
  LeafletResection step_;
  std::array<double, kRows + 1> row_mm_{};
  double height_mm_ = 0.0;
};

}  // namespace coapt
