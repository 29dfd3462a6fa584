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

  /// Pairs of neighbours of which one is of the label: two triangles each of its surface (label_surface.h).
  Index crossings(const LabelBox& box) const;

 private:
  Voxel size_;
  const std::uint16_t* at_;
  int value_;
};

}  // namespace coapt
