// Contact for the kernels: the same law and pairs as contact.h, found among clusters of sixteen
// features and pushed apart sixteen at a time.
#pragma once

#include <vector>

#include "core/closure/clusters.h"
#include "core/closure/contact.h"
#include "core/closure/kernels/kernels.h"
#include "core/closure/model.h"

namespace coapt {

enum class PairKind { VertexFace, EdgeEdge };

/// All pairs of one kind: which there are, and which of them are near.
template <class R>
class ContactPairs {
 public:
  /// `node_of`: the kernels' node numbers. `edges`: those between which pairs are looked for;
  /// `sides`: the vertices and faces, likewise.
  ContactPairs(const ClosureModel& model, const std::vector<int>& node_of, const ContactLaw& law,
               PairKind kind, const kernels::Kernels<R>& kernels,
               const std::vector<std::array<int, 2>>& edges = {}, const ContactSides& sides = {});

  /// Lists the pairs that are nearer than their thickness and margin. `listed`: positions and, as
  /// fourth, margins of all nodes, mm; that of a pair is the largest of its nodes.
  void list(const std::vector<kernels::Quad<R>>& listed);

  /// Adds the contact forces and stiffness of the listed pairs. Those that cannot touch before
  /// nodes have used up that share of their margins are passed over.
  void push(const std::vector<kernels::Quad<R>>& x, double used,
            std::vector<kernels::Quad<R>>& force);

  /// Pairs (f, g) of faces of which one may pierce the other (crossing.h); every pair that does is
  /// among them, once. @pre The kind is VertexFace.
  std::vector<std::pair<int, int>> straddling(const std::vector<kernels::Quad<R>>& x);

 private:
  void find_near_at_rest(const ClosureModel& model, const std::vector<int>& node_of,
                         const std::vector<FeatureNodes>& first,
                         const std::vector<FeatureNodes>& second);
  Clusters<R>& second() { return kind_ == PairKind::VertexFace ? second_ : first_; }
  kernels::PairSearch<R> search(const std::vector<kernels::Quad<R>>& listed);
  void make_room(int pairs);
  kernels::PairBuffer<R> buffer();

  ContactLaw law_;
  PairKind kind_;
  const kernels::Kernels<R>& kernels_;
  Clusters<R> first_, second_;  // edges are in first_ only
  std::vector<int> near_begin_;
  std::vector<kernels::NearAtRest<R>> near_;
  std::vector<int> near_clusters_;
  std::vector<int> buffered_;  // of kernels::PairBuffer
  std::vector<R> buffered_mm_;
  std::vector<kernels::PairBlock<R>> blocks_;
  int block_count_ = 0;
};

}  // namespace coapt
