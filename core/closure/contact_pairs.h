// Contact for the kernels: the same law and pairs as contact.h, found among clusters of sixteen features
// and pushed apart sixteen at a time.
#pragma once

#include <vector>

#include "core/closure/contact.h"
#include "core/closure/kernels/kernels.h"
#include "core/closure/model.h"

namespace coapt {

enum class PairKind { VertexFace, EdgeEdge };

/// All pairs of one kind: which there are, and which of them are near.
template <class R>
class ContactPairs {
 public:
  /// `node_of`: the kernels' node numbers.
  ContactPairs(const ClosureModel& model, const std::vector<int>& node_of, const ContactLaw& law,
               PairKind kind, const kernels::Kernels<R>& kernels);

  /// Lists the pairs that are nearer than their thickness and margin. `listed`: positions and, as fourth,
  /// margins of all nodes, mm; that of a pair is the largest of its nodes.
  void list(const std::vector<kernels::Quad<R>>& listed);

  /// Adds the contact forces and stiffness of the listed pairs. Those that cannot touch before nodes have
  /// used up that share of their margins are passed over.
  void push(const std::vector<kernels::Quad<R>>& x, double used,
            std::vector<kernels::Quad<R>>& force);

 private:
  struct Clusters {
    std::vector<kernels::Cluster<R>> clusters;
    std::vector<kernels::ClusterBoxes<R>> boxes;
    std::vector<int> index;  // [16 x cluster + lane]: of the feature, -1 for padding
  };
  using Nodes = std::vector<std::array<int, 3>>;  // vertices thrice, edges their second twice

  static Clusters gather(const ClosureModel& model, const std::vector<int>& node_of,
                         const Nodes& features, double area_share);
  void find_near_at_rest(const ClosureModel& model, const std::vector<int>& node_of,
                         const Nodes& first, const Nodes& second);
  Clusters& second() { return kind_ == PairKind::VertexFace ? second_ : first_; }
  kernels::PairSearch<R> search(const std::vector<kernels::Quad<R>>& listed);

  ContactLaw law_;
  PairKind kind_;
  const kernels::Kernels<R>& kernels_;
  Clusters first_, second_;  // edges are in first_ only
  std::vector<int> near_begin_;
  std::vector<kernels::NearAtRest<R>> near_;
  std::vector<int> near_clusters_;
  std::vector<kernels::ClusterBoxes<R>> near_boxes_;
  std::vector<kernels::PairBlock<R>> blocks_;
  int block_count_ = 0;
};

}  // namespace coapt
