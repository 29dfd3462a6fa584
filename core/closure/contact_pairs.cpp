#include "core/closure/contact_pairs.h"

#include <algorithm>

namespace coapt {

using kernels::blocks_for;
using kernels::kLanes;

namespace {
// Share of the thickness beyond it: pairs that are further apart at rest have the full thickness
// (0.25).
constexpr double kNearAtRest = 0.3;
constexpr int kFirstRoom = 4096;
constexpr double kRounding_mm = 1e-4;  // of positions in single precision, amply

/// What `list(first, second, room)` finds, once there is room for all of it.
template <class List>
std::vector<std::pair<int, int>> all_pairs(List list) {
  std::vector<int> first(kFirstRoom), second(kFirstRoom);
  int found = list(first.data(), second.data(), kFirstRoom);
  if (found > kFirstRoom) {
    first.resize(found);
    second.resize(found);
    found = list(first.data(), second.data(), found);
  }
  std::vector<std::pair<int, int>> pairs;
  for (int p = 0; p < found; ++p) pairs.emplace_back(first[p], second[p]);
  return pairs;
}

}  // namespace

template <class R>
ContactPairs<R>::ContactPairs(const ClosureModel& model, const std::vector<int>& node_of,
                              const ContactLaw& law, PairKind kind,
                              const kernels::Kernels<R>& kernels,
                              const std::vector<std::array<int, 2>>& edges,
                              const ContactSides& sides)
    : law_(kind == PairKind::EdgeEdge ? edge_law(law) : law), kind_(kind), kernels_(kernels) {
  std::vector<FeatureNodes> first, second;
  if (kind == PairKind::VertexFace) {
    for (const int v : vertices_of(model, sides)) first.push_back({v, v, v});
    for (const int f : faces_of(model, sides))
      second.push_back({model.faces(f, 0), model.faces(f, 1), model.faces(f, 2)});
    second_ = make_clusters<R>(model.rest_mm, second, node_of);
  } else {
    for (const auto& [a, b] : edges) first.push_back({a, b, b});
  }
  first_ = make_clusters<R>(model.rest_mm, first, node_of);
  for (std::size_t at = 0; at < first_.index.size(); ++at) {
    if (first_.index[at] < 0) continue;
    const FeatureNodes& n = first[first_.index[at]];
    const auto area = [&](int node) { return model.area_mm2[node]; };
    first_.each[at].area_mm2 = static_cast<R>(
        kind == PairKind::VertexFace ? area(n[0]) : 0.25 * (area(n[0]) + area(n[1])));
  }
  near_clusters_.resize(this->second().clusters.size());
  near_begin_.assign(first_.clusters.size() + 1, 0);
  find_near_at_rest(model, node_of, first, kind == PairKind::VertexFace ? second : first);
}

/// Gives the pairs that share a node or lie near at rest their own thickness.
template <class R>
void ContactPairs<R>::find_near_at_rest(const ClosureModel& model, const std::vector<int>& node_of,
                                        const std::vector<FeatureNodes>& first,
                                        const std::vector<FeatureNodes>& second) {
  const bool edges = kind_ == PairKind::EdgeEdge;
  std::vector<kernels::Quad<R>> rest(*std::max_element(node_of.begin(), node_of.end()) + 1);
  for (std::size_t i = 0; i < node_of.size(); ++i) {
    kernels::Quad<R>& quad = rest[node_of[i]];
    for (int k = 0; k < 3; ++k) quad.at[k] = static_cast<R>(model.rest_mm(i, k));
    quad.at[3] = static_cast<R>(kNearAtRest * law_.thickness_mm);
  }
  const kernels::PairSearch<R> near = search(rest);
  const auto found = all_pairs([&](int* i_of, int* j_of, int room) {
    return kernels_.number_pairs(near, i_of, j_of, room);
  });
  int own = 0;
  for (const auto& [i, j] : found) {
    for (; own < i / kLanes; ++own) near_begin_[own + 1] = static_cast<int>(near_.size());
    const auto& a = first[first_.index[i]];
    const auto& b = second[this->second().index[j]];
    const bool shared = std::any_of(
        a.begin(), a.end(), [&](int n) { return std::find(b.begin(), b.end(), n) != b.end(); });
    const double thickness =
        shared ? -1e6
               : pair_thickness_mm(
                     law_, model,
                     {a[0], edges ? a[1] : b[0], edges ? b[0] : b[1], edges ? b[1] : b[2]}, edges);
    if (thickness >= law_.thickness_mm) continue;
    if (static_cast<int>(near_.size()) == near_begin_[own] || near_.back().cluster != j / kLanes ||
        near_.back().lane != i % kLanes) {
      near_.push_back({j / kLanes, i % kLanes, {}});
      for (R& t : near_.back().thickness_mm.at) t = static_cast<R>(law_.thickness_mm);
    }
    near_.back().thickness_mm.at[j % kLanes] = static_cast<R>(thickness);
  }
  for (; own + 1 < static_cast<int>(near_begin_.size()); ++own)
    near_begin_[own + 1] = static_cast<int>(near_.size());
}

template <class R>
kernels::PairSearch<R> ContactPairs<R>::search(const std::vector<kernels::Quad<R>>& listed) {
  kernels::PairSearch<R> search;
  search.first = first_.features();
  search.second = second().features();
  search.faces = kind_ == PairKind::VertexFace;
  search.near_begin = near_begin_.data();
  search.near = near_.data();
  search.thickness_mm = static_cast<R>(law_.thickness_mm);
  search.stiffness_n_per_mm4 = static_cast<R>(law_.stiffness_n_per_mm4);
  search.listed = listed.data();
  search.near_clusters = near_clusters_.data();
  const bool planes = kind_ == PairKind::VertexFace;
  kernels_.box(search.first, false, search.thickness_mm, listed.data());
  if (planes) kernels_.box(search.second, true, search.thickness_mm, listed.data());
  return search;
}

template <class R>
void ContactPairs<R>::make_room(int pairs) {
  const std::size_t room = kLanes * blocks_for(pairs + pairs / 4);
  buffered_.resize((2 + kernels::kPairBins) * room);
  buffered_mm_.resize(2 * room);
}

template <class R>
kernels::PairBuffer<R> ContactPairs<R>::buffer() {
  const std::size_t room = buffered_mm_.size() / 2;
  kernels::PairBuffer<R> buffer;
  buffer.first = buffered_.data(), buffer.second = buffer.first + room;
  buffer.thickness_mm = buffered_mm_.data(), buffer.margin_mm = buffer.thickness_mm + room;
  for (std::size_t b = 0; b < kernels::kPairBins; ++b)
    buffer.binned[b] = buffered_.data() + (2 + b) * room;
  buffer.room = static_cast<int>(room);
  return buffer;
}

template <class R>
void ContactPairs<R>::list(const std::vector<kernels::Quad<R>>& listed) {
  kernels::PairSearch<R> near = search(listed);
  for (;;) {
    const auto room = static_cast<int>(blocks_.size());
    near.buffer = buffer();
    block_count_ = kernels_.list_pairs(near, blocks_.data(), room);
    if (block_count_ < 0)
      make_room(-block_count_);
    else if (block_count_ <= room)
      return;
    else
      blocks_.resize(block_count_ + block_count_ / 4);
  }
}

template <class R>
void ContactPairs<R>::push(const std::vector<kernels::Quad<R>>& x, double used,
                           std::vector<kernels::Quad<R>>& force) {
  const auto push = kind_ == PairKind::VertexFace ? kernels_.push_faces : kernels_.push_edges;
  push(blocks_.data(), block_count_, static_cast<R>(used), x.data(), force.data());
}

template <class R>
std::vector<std::pair<int, int>> ContactPairs<R>::straddling(
    const std::vector<kernels::Quad<R>>& x) {
  kernels::PairSearch<R> faces;
  faces.first = faces.second = second_.features();
  faces.listed = x.data();
  faces.thickness_mm = static_cast<R>(kRounding_mm);
  faces.near_clusters = near_clusters_.data();
  kernels_.box(faces.second, true, faces.thickness_mm, x.data());
  auto pairs = all_pairs(
      [&](int* f, int* g, int room) { return kernels_.straddling_faces(faces, f, g, room); });
  for (auto& [f, g] : pairs) {
    f = second_.index[f];
    g = second_.index[g];
  }
  return pairs;
}

template class ContactPairs<float>;
template class ContactPairs<double>;

}  // namespace coapt
