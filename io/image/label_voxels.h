// The voxels of one label.
#pragma once

#include "io/image/label_map.h"

namespace coapt {

using Voxel = std::array<Index, 3>;

/// Smallest box about a label, inclusive; `count` 0 if there is none.
struct LabelBox {
  Voxel min = {0, 0, 0}, max = {0, 0, 0};
  Index count = 0;
};

class LabelVoxels {
 public:
  /// Views into the map.
  LabelVoxels(const LabelMap& map, const LabelAt& label);

  /// Whether a voxel is of the label; those outside the image are not.
  bool operator()(Index i, Index j, Index k) const {
    if (i < 0 || j < 0 || k < 0 || i >= size_[0] || j >= size_[1] || k >= size_[2]) return false;
    return at_[(k * size_[1] + j) * size_[0] + i] == value_;
  }

  LabelBox box() const;

  /// Voxels of the label in the outermost layer of the image: what lies beyond was not imaged.
  Index at_border() const;

  /// Voxels in the outermost layer of the label itself, along the axis where most lie, if it ends there as what was cut off does: by a layer
  /// nearly as large as those behind it, or half as large and displaced against them. 0: nowhere.
  Index flat_end(const LabelBox& box) const;

  /// Pairs of neighbours of which one is of the label: two triangles each of its surface (label_surface.h).
  Index crossings(const LabelBox& box) const;

 private:
  /// Of the label, in the layer `at` of an axis; `shift` other than 0: that have one of the label so many layers further, too.
  Index in_layer(const LabelBox& box, std::size_t axis, Index at, Index shift = 0) const;

  Voxel size_;
  const std::uint16_t* at_;
  int value_;
};

}  // namespace coapt
