#include "core/closure/clusters.h"

#include <algorithm>
#include <numeric>

namespace coapt {

using kernels::blocks_for;
using kernels::kLanes;

namespace {

void bisect(const Points& centres, std::vector<int>& order, Index begin, Index end) {
  const Index count = end - begin;
  const auto at = [&](Index i) { return order.begin() + i; };
  if (count <= kLanes) {
    std::sort(at(begin), at(end));
    return;
  }
  Vec3 low = centres.row(order[begin]), high = low;
  for (Index i = begin; i < end; ++i) {
    low = low.cwiseMin(centres.row(order[i]).transpose());
    high = high.cwiseMax(centres.row(order[i]).transpose());
  }
  Index axis = 0;
  (high - low).maxCoeff(&axis);
  const Index half = (count / kLanes + 1) / 2 * kLanes;
  std::nth_element(at(begin), at(begin + half), at(end), [&](int i, int j) {
    const double a = centres(i, axis), b = centres(j, axis);
    return a < b || (a == b && i < j);
  });
  bisect(centres, order, begin, begin + half);
  bisect(centres, order, begin + half, end);
}

}  // namespace

std::vector<int> cluster_order(const Points& centres_mm) {
  std::vector<int> order(centres_mm.rows());
  std::iota(order.begin(), order.end(), 0);
  bisect(centres_mm, order, 0, std::ssize(order));
  return order;
}

template <class R>
Clusters<R> make_clusters(const Points& rest_mm, const std::vector<FeatureNodes>& features,
                          const std::vector<int>& node_of) {
  Points centres(features.size(), 3);
  for (std::size_t i = 0; i < features.size(); ++i)
    centres.row(i) = rest_mm(features[i], Eigen::all).colwise().mean();
  const std::vector<int> order = cluster_order(centres);
  Clusters<R> result;
  result.clusters.resize(blocks_for(features.size()));
  result.boxes.resize(blocks_for(result.clusters.size()));
  result.index.assign(result.clusters.size() * kLanes, -1);
  result.each.resize(result.index.size());
  for (Index at = 0; at < std::ssize(result.index); ++at) {
    kernels::Cluster<R>& cluster = result.clusters[at / kLanes];
    const int feature = order[std::min(at, std::ssize(order) - 1)];
    for (std::size_t k = 0; k < 3; ++k)
      cluster.node[k].at[at % kLanes] = result.each[at].node[k] =
          kernels::offset_of<R>(node_of[features[feature][k]]);
    if (at >= std::ssize(order)) continue;
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
