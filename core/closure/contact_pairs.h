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

  /// Lists the pairs that are nearer than their thickness and `margin_mm`.
  void list(const std::vector<kernels::Quad<R>>& x, double margin_mm);

  /// Adds the contact forces and stiffness of the listed pairs. Those that cannot touch before nodes have
  /// approached each other by `approach_mm` since they were listed are passed over.
  void push(const std::vector<kernels::Quad<R>>& x, double approach_mm,
            std::vector<kernels::Quad<R>>& force);

 private:
  struct Clusters {
    std::vector<kernels::Cluster<R>> clusters;
    std::vector<kernels::ClusterBoxes<R>> boxes;
    std::vector<int> index;   // [16 x cluster + lane]: of the feature, -1 for padding
    std::vector<R> area_mm2;  // likewise: rest area that contact pressure acts on
  };
  using Nodes = std::vector<std::array<int, 3>>;  // vertices thrice, edges their second twice

  static Clusters gather(const ClosureModel& model, const std::vector<int>& node_of,
                         const Nodes& features, double area_share);
  void find_near_at_rest(const ClosureModel& model, int found, const Nodes& first,
                         const Nodes& second);
  kernels::Features<R> features(Clusters& clusters) const;
  Clusters& second() { return kind_ == PairKind::VertexFace ? second_ : first_; }
  kernels::PairList<R> scratch(int list);
  kernels::PairCount search(const std::vector<kernels::Quad<R>>& x, double margin_mm);

  ContactLaw law_;
  PairKind kind_;
  const kernels::Kernels<R>& kernels_;
  Clusters first_, second_;  // edges are in first_ only
  std::vector<int> near_begin_;
  std::vector<kernels::NearAtRest<R>> near_;
  std::vector<int> near_clusters_, numbers_;
  std::vector<kernels::ClusterBoxes<R>> near_boxes_;
  std::vector<R> thicknesses_;
  int capacity_ = 4096;
  std::vector<kernels::PairBlock<R>> blocks_;
  int block_count_ = 0;
};

}  // namespace coapt
