#include "core/closure/contact_pairs.h"

#include <algorithm>

#include "core/closure/relaxation_model.h"

namespace coapt {

using kernels::blocks_for;
using kernels::kLanes;

namespace {
// Share of the thickness beyond it: pairs that are further apart at rest have the full thickness (0.25).
constexpr double kNearAtRest = 0.3;
constexpr std::size_t kFirstRoom = 4096;
}  // namespace

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
  find_near_at_rest(model, node_of, first, kind == PairKind::VertexFace ? second : first);
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
  for (std::size_t at = 0; at < result.index.size(); ++at) {
    kernels::Cluster<R>& cluster = result.clusters[at / kLanes];
    const auto& n = features[static_cast<std::size_t>(order[std::min(at, order.size() - 1)])];
    for (std::size_t k = 0; k < 3; ++k)
      cluster.node[k].at[at % kLanes] = node_of[static_cast<std::size_t>(n[k])];
    cluster.area_mm2.at[at % kLanes] =
        static_cast<R>(area_share * (model.area_mm2[static_cast<std::size_t>(n[0])] +
                                     model.area_mm2[static_cast<std::size_t>(n[1])]));
    if (at >= order.size()) continue;
    ++cluster.count;
    result.index[at] = order[at];
  }
  return result;
}

/// Gives the pairs that share a node or lie near at rest their own thickness.
template <class R>
void ContactPairs<R>::find_near_at_rest(const ClosureModel& model, const std::vector<int>& node_of,
                                        const Nodes& first, const Nodes& second) {
  const bool edges = kind_ == PairKind::EdgeEdge;
  std::vector<kernels::Quad<R>> rest(
      static_cast<std::size_t>(*std::max_element(node_of.begin(), node_of.end())) + 1);
  for (std::size_t i = 0; i < node_of.size(); ++i) {
    kernels::Quad<R>& quad = rest[static_cast<std::size_t>(node_of[i])];
    for (int k = 0; k < 3; ++k)
      quad.at[k] = static_cast<R>(model.rest_mm(static_cast<Eigen::Index>(i), k));
    quad.at[3] = static_cast<R>(kNearAtRest * law_.thickness_mm);
  }
  const kernels::PairSearch<R> near = search(rest);
  std::vector<int> i_of(kFirstRoom), j_of(kFirstRoom);
  int found = 0;
  for (;;) {
    const auto room = static_cast<int>(i_of.size());
    found = kernels_.number_pairs(near, i_of.data(), j_of.data(), room);
    if (found <= room) break;
    i_of.resize(static_cast<std::size_t>(found));
    j_of.resize(static_cast<std::size_t>(found));
  }
  int number = 0;
  for (std::size_t p = 0; p < static_cast<std::size_t>(found); ++p) {
    const int i = i_of[p], j = j_of[p];
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
kernels::PairSearch<R> ContactPairs<R>::search(const std::vector<kernels::Quad<R>>& listed) {
  const auto features = [](Clusters& clusters) {
    return kernels::Features<R>{clusters.clusters.data(), clusters.boxes.data(),
                                static_cast<int>(clusters.clusters.size())};
  };
  kernels::PairSearch<R> search;
  search.first = features(first_);
  search.second = features(second());
  search.faces = kind_ == PairKind::VertexFace;
  search.near_begin = near_begin_.data();
  search.near = near_.data();
  search.thickness_mm = static_cast<R>(law_.thickness_mm);
  search.stiffness_n_per_mm4 = static_cast<R>(law_.stiffness_n_per_mm4);
  search.listed = listed.data();
  search.near_clusters = near_clusters_.data();
  search.near_boxes = near_boxes_.data();
  kernels_.box(search.first, false, listed.data());
  if (kind_ == PairKind::VertexFace) kernels_.box(search.second, true, listed.data());
  return search;
}

template <class R>
void ContactPairs<R>::list(const std::vector<kernels::Quad<R>>& listed) {
  const kernels::PairSearch<R> near = search(listed);
  for (;;) {
    const auto room = static_cast<int>(blocks_.size());
    block_count_ = kernels_.list_pairs(near, blocks_.data(), room);
    if (block_count_ <= room) return;
    blocks_.resize(static_cast<std::size_t>(block_count_ + block_count_ / 4));
  }
}

template <class R>
void ContactPairs<R>::push(const std::vector<kernels::Quad<R>>& x, double used,
                           std::vector<kernels::Quad<R>>& force) {
  const auto push = kind_ == PairKind::VertexFace ? kernels_.push_faces : kernels_.push_edges;
  push(blocks_.data(), block_count_, static_cast<R>(used), x.data(), force.data());
}

template class ContactPairs<float>;
template class ContactPairs<double>;

}  // namespace coapt
