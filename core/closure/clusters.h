// Features of the leaflets (vertices, edges or faces) in clusters of sixteen that lie together.
#pragma once

#include <array>
#include <vector>

#include "core/closure/kernels/layout.h"
#include "core/valve/types.h"

namespace coapt {

/// Nodes of one feature: a vertex thrice, of an edge the second twice.
using FeatureNodes = std::array<int, 3>;

template <class R>
struct Clusters {
  std::vector<kernels::Cluster<R>> clusters;
  std::vector<kernels::ClusterBoxes<R>> boxes;
  std::vector<kernels::Feature<R>> each;  ///< [16 x cluster + lane]: their areas are the caller's
  std::vector<int> index;                 ///< [16 x cluster + lane]: of the feature, -1 for padding

  kernels::Features<R> features() {
    return {clusters.data(), boxes.data(), each.data(), static_cast<int>(clusters.size())};
  }
};

/// R is float or double. `rest_mm`: |N| x 3; `node_of`: the kernels' number of each node.
template <class R>
Clusters<R> make_clusters(const Points& rest_mm, const std::vector<FeatureNodes>& features,
                          const std::vector<int>& node_of);

/// Indices of `centres_mm` (|n| x 3) ordered so that each sixteen in a row lie together: recursive
/// bisection across the longest side of the box around them.
std::vector<int> cluster_order(const Points& centres_mm);

}  // namespace coapt
