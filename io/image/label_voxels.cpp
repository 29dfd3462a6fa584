#include "io/image/label_voxels.h"

#include <algorithm>

namespace coapt {
namespace {

// Of flat_end(), chosen on label maps and judged on others (docs/experiments.md).
constexpr Index kLayersBehind = 3;
constexpr double kAsLarge = 0.9, kHalfAsLarge = 0.5, kBacked = 0.95;

}  // namespace

LabelVoxels::LabelVoxels(const LabelMap& map, const LabelAt& label)
    : size_(map.size),
      at_(map.voxels.data() + label.layer * map.size[0] * map.size[1] * map.size[2]),
      value_(label.value) {}

Index LabelVoxels::at_border() const {
  Index count = 0;
  for (Index k = 0; k < size_[2]; ++k)
    for (Index j = 0; j < size_[1]; ++j) {
      const bool inner = k > 0 && k + 1 < size_[2] && j > 0 && j + 1 < size_[1];
      const Index step = inner ? std::max<Index>(1, size_[0] - 1) : 1;
      for (Index i = 0; i < size_[0]; i += step) count += (*this)(i, j, k) ? 1 : 0;
    }
  return count;
}

Index LabelVoxels::in_layer(const LabelBox& box, std::size_t axis, Index at, Index shift) const {
  const std::size_t across = (axis + 1) % 3, along = (axis + 2) % 3;
  Index count = 0;
  Voxel voxel;
  voxel[axis] = at;
  for (voxel[along] = box.min[along]; voxel[along] <= box.max[along]; ++voxel[along])
    for (voxel[across] = box.min[across]; voxel[across] <= box.max[across]; ++voxel[across]) {
      Voxel behind = voxel;
      behind[axis] += shift;
      count += (*this)(voxel[0], voxel[1], voxel[2]) && (*this)(behind[0], behind[1], behind[2]);
    }
  return count;
}

Index LabelVoxels::flat_end(const LabelBox& box) const {
  Index most = 0;
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const Index inwards : {1, -1}) {
      const Index end = inwards > 0 ? box.min[axis] : box.max[axis];
      const auto first = static_cast<double>(in_layer(box, axis, end));
      const auto backed = static_cast<double>(in_layer(box, axis, end, inwards));
      double behind = 0.0;
      for (Index layer = 1; layer <= kLayersBehind; ++layer)
        behind += static_cast<double>(in_layer(box, axis, end + inwards * layer)) /
                  static_cast<double>(kLayersBehind);
      if (first > kAsLarge * behind || (first > kHalfAsLarge * behind && backed < kBacked * first))
        most = std::max(most, static_cast<Index>(first));
    }
  return most;
}

LabelBox LabelVoxels::box() const {
  LabelBox box;
  const std::uint16_t* voxel = at_;
  for (Index k = 0; k < size_[2]; ++k)
    for (Index j = 0; j < size_[1]; ++j)
      for (Index i = 0; i < size_[0]; ++i) {
        if (*voxel++ != value_) continue;
        const Voxel here = {i, j, k};
        for (std::size_t axis = 0; axis < 3; ++axis) {
          box.min[axis] = box.count == 0 ? here[axis] : std::min(box.min[axis], here[axis]);
          box.max[axis] = box.count == 0 ? here[axis] : std::max(box.max[axis], here[axis]);
        }
        ++box.count;
      }
  return box;
}

Index LabelVoxels::crossings(const LabelBox& box) const {
  Index count = 0;
  for (Index k = box.min[2]; k <= box.max[2]; ++k)
    for (Index j = box.min[1]; j <= box.max[1]; ++j)
      for (Index i = box.min[0]; i <= box.max[0]; ++i) {
        if (!(*this)(i, j, k)) continue;
        for (const auto& [x, y, z] : {Voxel{i - 1, j, k},
                                      {i + 1, j, k},
                                      {i, j - 1, k},
                                      {i, j + 1, k},
                                      {i, j, k - 1},
                                      {i, j, k + 1}})
          count += (*this)(x, y, z) ? 0 : 1;
      }
  return count;
}

}  // namespace coapt
