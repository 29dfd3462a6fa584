// The state of a relaxation: where the nodes are and how they move, one step at a time.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "core/closure/relaxation_layout.h"
#include "core/closure/relaxation_settings.h"
#include "core/closure/stiffness_laplacian.h"

namespace coapt {

template <class R>
class MovingValve {
 public:
  /// What can be returned to.
  struct Moment {
    std::vector<kernels::Quad<R>> x;
    std::vector<kernels::NodeBlock<R>> blocks;
    double longest_move_mm = 0.0, travelled = 0.0;
  };

  /// `start`: |N| x 3.
  MovingValve(const ClosureModel& model, const RelaxationSettings& settings, const Points& start);

  /// Places the nodes that do not move by themselves, `travelled` (0 to 1) of their way from the
  /// start.
  void place_fixed(double travelled);

  /// Longest way of theirs to the model's targets, mm; 0 when they have arrived.
  double way_to_targets_mm() const;

  /// Moves them towards the targets, so far at most; all arrive together. @return the longest of these moves, mm.
  double approach_targets(double longest_mm);

  /// The pressure from now on, MPa; residual() goes by the model's.
  void load(double pressure_mpa);

  /// Of nodes of the model, mm.
  Vec3 position(const std::vector<NodeShare>& shares) const;

  /// Pulls at these nodes in the next step: N, and how it grows with their way, N/mm.
  void pull(const std::vector<NodeShare>& shares, const Vec3& force_n, double stiffness_n_per_mm);

  /// Pulls each node that moves by itself towards a place, |N| x 3, in the next step: a spring, at most so hard.
  void draw(const Points& to_mm, double stiffness_n_per_mm, double largest_n);

  /// From now on this damping, as the settings have it.
  void damp(double damping) { damping_ = damping; }

  /// `fixed_move_mm`: how far fixed nodes have moved since the last step.
  void step(double fixed_move_mm);

  /// Lists the pairs that are near; each block of nodes has a margin that goes with its speed.
  void list();

  double longest_move_mm() const { return longest_move_mm_; }  ///< of a node in the last step

  /// |N| x 3, mm; fixed nodes to the last bit where the model has them.
  Points positions() const;

  /// Rms free force of the last step over rms pressure force.
  double residual() const;

  /// Faces that pass through each other.
  std::vector<std::pair<int, int>> crossings();

  /// From now on these edges, and no others, have contact.
  void guard(const std::vector<std::array<int, 2>>& edges);

  Moment moment() const { return {x_, layout_.laid.blocks, longest_move_mm_, travelled_}; }
  void return_to(const Moment& moment);

 private:
  void pull_chordae();
  void pull_faces();
  kernels::StepSums move_together(kernels::StepInput<R>& input);
  Vec3 at(Index i) const;
  void place(Index i, const Vec3& p);

  const ClosureModel& model_;
  const RelaxationSettings& settings_;
  double damping_;
  const kernels::Kernels<R>& kernels_;
  const Points start_mm_;
  RelaxationLayout<R> layout_;
  std::vector<kernels::Quad<R>> x_, next_, force_;
  std::vector<kernels::Quad<R>> corners_;            // of faces, and one at rest
  std::vector<kernels::HingePulls<R>> hinge_pulls_;  // likewise
  std::vector<kernels::Quad<R>> listed_;  // where nodes were when pairs were listed, and margins
  std::optional<ContactPairs<R>> edges_;  // with edges
  std::unique_ptr<StiffnessLaplacian<R>> laplacian_;  // or none
  std::vector<kernels::Quad<R>> sums_;  // forces and stiffness of moving nodes, then their moves
  int steps_to_refresh_ = 0;
  double travelled_ = 0.0;
  bool started_ = false;
  // Shares of the margins that nodes have used up since pairs were listed: as the crow flies, at
  // most on the way, and the fixed nodes.
  double listed_share_ = 1.0, used_share_ = 0.0, fixed_share_ = 1.0;
  double fixed_margin_mm_ = 1.0, fixed_move_mm_ = 0.0;
  double longest_move_mm_ = 0.0;  // in the last step
  double force2_n2_ = 0.0;        // on moving nodes, likewise
};

}  // namespace coapt
