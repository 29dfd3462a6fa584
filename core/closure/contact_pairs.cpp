#include "core/closure/contact_pairs.h"

#include <algorithm>

#include "core/closure/relaxation_model.h"

namespace coapt {

using kernels::blocks_for;
using kernels::kLanes;

template <class R>
ContactPairs<R>::ContactPairs(const ClosureModel& model, const std::vector<int>& node_of,
                              const ContactLaw& law, PairKind kind,
                              const kernels::Kernels<R>& kernels)
    : law_(kind == PairKind::EdgeEdge ? edge_law(law) : law), kind_(kind), kernels_(kernels) {
  Nodes first, second;
  if (kind == PairKind::VertexFace) {
    for (int v = 0; v < model.vertices; ++v) first.push_back({v, v, v});
    for (Eigen::Index f = 0; f < model.faces.rows(); ++f)
      second.push_back({model.faces(f, 0), model.faces(f, 1), model.faces(f, 2)});
    first_ = gather(model, node_of, first, 0.5);
    second_ = gather(model, node_of, second, 0.0);
  } else {
    for (const auto& [a, b] : model.edges) first.push_back({a, b, b});
    first_ = gather(model, node_of, first, 0.25);
  }
  near_clusters_.resize(this->second().clusters.size());
  near_boxes_.resize(this->second().boxes.size());
  near_begin_.assign(first_.index.size() + 1, 0);
  std::vector<kernels::Quad<R>> rest(
      static_cast<std::size_t>(*std::max_element(node_of.begin(), node_of.end())) + 1);
  for (std::size_t i = 0; i < node_of.size(); ++i)
    for (int k = 0; k < 3; ++k)
      rest[static_cast<std::size_t>(node_of[i])].at[k] =
          static_cast<R>(model.rest_mm(static_cast<Eigen::Index>(i), k));
  const int found =
      search(rest, 0.3 * law_.thickness_mm).found;  // 0.25: where the rest distance counts
  find_near_at_rest(model, found, first, kind == PairKind::VertexFace ? second : first);
}

template <class R>
typename ContactPairs<R>::Clusters ContactPairs<R>::gather(const ClosureModel& model,
                                                           const std::vector<int>& node_of,
                                                           const Nodes& features,
                                                           double area_share) {
  const auto count = static_cast<Eigen::Index>(features.size());
  Points centres(count, 3);
  for (Eigen::Index i = 0; i < count; ++i) {
    const auto& n = features[static_cast<std::size_t>(i)];
    centres.row(i) =
        (model.rest_mm.row(n[0]) + model.rest_mm.row(n[1]) + model.rest_mm.row(n[2])) / 3.0;
  }
  const std::vector<int> order = cluster_order(centres);
  Clusters result;
  result.clusters.resize(static_cast<std::size_t>(blocks_for(features.size())));
  result.boxes.resize(static_cast<std::size_t>(blocks_for(result.clusters.size())));
  result.index.assign(result.clusters.size() * kLanes, -1);
  result.area_mm2.resize(result.index.size());
  for (std::size_t at = 0; at < result.index.size(); ++at) {
    kernels::Cluster<R>& cluster = result.clusters[at / kLanes];
    const auto& n = features[static_cast<std::size_t>(order[std::min(at, order.size() - 1)])];
    for (std::size_t k = 0; k < 3; ++k)
      cluster.node[k].at[at % kLanes] = node_of[static_cast<std::size_t>(n[k])];
    result.area_mm2[at] =
        static_cast<R>(area_share * (model.area_mm2[static_cast<std::size_t>(n[0])] +
                                     model.area_mm2[static_cast<std::size_t>(n[1])]));
    if (at >= order.size()) continue;
    ++cluster.count;
    result.index[at] = order[at];
  }
  return result;
}

/// Gives the pairs in `numbers_` that share a node or lie near at rest their own thickness.
template <class R>
void ContactPairs<R>::find_near_at_rest(const ClosureModel& model, int found, const Nodes& first,
                                        const Nodes& second) {
  const bool edges = kind_ == PairKind::EdgeEdge;
  const kernels::PairList<R> pairs = scratch(0);
  int number = 0;
  for (int p = 0; p < found; ++p) {
    const int i = pairs.first[p], j = pairs.second[p];
    for (; number < i; ++number)
      near_begin_[static_cast<std::size_t>(number) + 1] = static_cast<int>(near_.size());
    const auto& a = first[static_cast<std::size_t>(first_.index[static_cast<std::size_t>(i)])];
    const auto& b =
        second[static_cast<std::size_t>(this->second().index[static_cast<std::size_t>(j)])];
    const bool shared = std::any_of(
        a.begin(), a.end(), [&](int n) { return std::find(b.begin(), b.end(), n) != b.end(); });
    const double thickness =
        shared ? -1e6
               : pair_thickness_mm(
                     law_, model,
                     {a[0], edges ? a[1] : b[0], edges ? b[0] : b[1], edges ? b[1] : b[2]}, edges);
    if (thickness >= law_.thickness_mm) continue;
    if (static_cast<int>(near_.size()) == near_begin_[static_cast<std::size_t>(i)] ||
        near_.back().cluster != j / kLanes) {
      near_.push_back({j / kLanes, {}});
      for (R& t : near_.back().thickness_mm.at) t = static_cast<R>(law_.thickness_mm);
    }
    near_.back().thickness_mm.at[j % kLanes] = static_cast<R>(thickness);
  }
  for (; number + 1 < static_cast<int>(near_begin_.size()); ++number)
    near_begin_[static_cast<std::size_t>(number) + 1] = static_cast<int>(near_.size());
}

template <class R>
kernels::Features<R> ContactPairs<R>::features(Clusters& clusters) const {
  return {clusters.clusters.data(), clusters.boxes.data(),
          static_cast<int>(clusters.clusters.size()), clusters.area_mm2.data()};
}

template <class R>
kernels::PairList<R> ContactPairs<R>::scratch(int list) {
  const auto room = static_cast<std::size_t>(capacity_ + kLanes);
  const std::size_t at = static_cast<std::size_t>(list) * room;
  return {numbers_.data() + 2 * at, numbers_.data() + 2 * at + room, thicknesses_.data() + at};
}

template <class R>
kernels::PairCount ContactPairs<R>::search(const std::vector<kernels::Quad<R>>& x,
                                           double margin_mm) {
  kernels::PairSearch<R> search;
  search.first = features(first_);
  search.second = features(second());
  search.faces = kind_ == PairKind::VertexFace;
  search.near_begin = near_begin_.data();
  search.near = near_.data();
  search.thickness_mm = static_cast<R>(law_.thickness_mm);
  search.stiffness_n_per_mm4 = static_cast<R>(law_.stiffness_n_per_mm4);
  search.margin_mm = static_cast<R>(margin_mm);
  search.x = x.data();
  search.near_clusters = near_clusters_.data();
  search.near_boxes = near_boxes_.data();
  kernels_.box(search.first, false, x.data());
  if (kind_ == PairKind::VertexFace) kernels_.box(search.second, true, x.data());
  for (;;) {
    const auto room = static_cast<std::size_t>(capacity_ + kLanes) * (kernels::kBins + 1);
    numbers_.resize(2 * room);
    thicknesses_.resize(room);
    blocks_.resize(static_cast<std::size_t>(capacity_ / kLanes + kernels::kBins));
    search.capacity = capacity_;
    search.found = scratch(0);
    for (int b = 0; b < kernels::kBins; ++b) search.bins[b] = scratch(b + 1);
    search.blocks = blocks_.data();
    const kernels::PairCount count = kernels_.list_pairs(search);
    if (count.found <= capacity_) return count;
    capacity_ = count.found + count.found / 4;
  }
}

template <class R>
void ContactPairs<R>::list(const std::vector<kernels::Quad<R>>& x, double margin_mm) {
  block_count_ = search(x, margin_mm).blocks;
}

template <class R>
void ContactPairs<R>::push(const std::vector<kernels::Quad<R>>& x, double approach_mm,
                           std::vector<kernels::Quad<R>>& force) {
  const auto push = kind_ == PairKind::VertexFace ? kernels_.push_faces : kernels_.push_edges;
  push(blocks_.data(), block_count_, static_cast<R>(approach_mm), x.data(), force.data());
}

template class ContactPairs<float>;
template class ContactPairs<double>;

}  // namespace coapt
