#include "core/closure/clusters.h"

#include <algorithm>
#include <numeric>

namespace coapt {

using kernels::blocks_for;
using kernels::kLanes;

namespace {

void bisect(const Points& centres, std::vector<int>& order, std::size_t begin, std::size_t end) {
  const std::size_t count = end - begin;
  if (count <= kLanes) {
    std::sort(order.begin() + static_cast<std::ptrdiff_t>(begin),
              order.begin() + static_cast<std::ptrdiff_t>(end));
    return;
  }
  Vec3 low = centres.row(order[begin]), high = low;
  for (std::size_t i = begin; i < end; ++i) {
    low = low.cwiseMin(centres.row(order[i]).transpose());
    high = high.cwiseMax(centres.row(order[i]).transpose());
  }
  Eigen::Index axis = 0;
  (high - low).maxCoeff(&axis);
  const std::size_t half = (count / kLanes + 1) / 2 * kLanes;
  const auto at = [&](std::size_t i) { return order.begin() + static_cast<std::ptrdiff_t>(i); };
  std::nth_element(at(begin), at(begin + half), at(end), [&](int i, int j) {
    const double a = centres(i, axis), b = centres(j, axis);
    return a < b || (a == b && i < j);
  });
  bisect(centres, order, begin, begin + half);
  bisect(centres, order, begin + half, end);
}

}  // namespace

std::vector<int> cluster_order(const Points& centres_mm) {
  std::vector<int> order(static_cast<std::size_t>(centres_mm.rows()));
  std::iota(order.begin(), order.end(), 0);
  bisect(centres_mm, order, 0, order.size());
  return order;
}

template <class R>
Clusters<R> make_clusters(const Points& rest_mm, const std::vector<FeatureNodes>& features,
                          const std::vector<int>& node_of) {
  Points centres(static_cast<Eigen::Index>(features.size()), 3);
  for (std::size_t i = 0; i < features.size(); ++i)
    centres.row(static_cast<Eigen::Index>(i)) = rest_mm(features[i], Eigen::all).colwise().mean();
  const std::vector<int> order = cluster_order(centres);
  Clusters<R> result;
  result.clusters.resize(static_cast<std::size_t>(blocks_for(features.size())));
  result.boxes.resize(static_cast<std::size_t>(blocks_for(result.clusters.size())));
  result.index.assign(result.clusters.size() * kLanes, -1);
  for (std::size_t at = 0; at < result.index.size(); ++at) {
    kernels::Cluster<R>& cluster = result.clusters[at / kLanes];
    const auto feature = static_cast<std::size_t>(order[std::min(at, order.size() - 1)]);
    for (std::size_t k = 0; k < 3; ++k)
      cluster.node[k].at[at % kLanes] = node_of[static_cast<std::size_t>(features[feature][k])];
    if (at >= order.size()) continue;
    ++cluster.count;
    result.index[at] = order[at];
  }
  return result;
}
template Clusters<float> make_clusters(const Points&, const std::vector<FeatureNodes>&,
                                       const std::vector<int>&);
template Clusters<double> make_clusters(const Points&, const std::vector<FeatureNodes>&,
                                        const std::vector<int>&);

}  // namespace coapt
