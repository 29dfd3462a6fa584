// What a relaxation (relaxation.h) is asked for.
#pragma once

#include <limits>

#include "core/closure/allowance.h"
#include "core/closure/contact.h"
#include "core/closure/kernels/kernels.h"
#include "core/closure/relaxation_layout.h"

namespace coapt {

struct RelaxationSettings {
  double residual_tolerance = 0.005;
  double way_tolerance_mm = 0.02;  ///< predicted rms way of the leaflets to rest
  int max_steps = 6000;
  double damping = 0.045;  ///< share of a velocity lost in a step at 650 triangles (relaxation.cpp)
  /// To which damping falls while the leaflets creep one way, if it is less than `damping`.
  double least_damping = std::numeric_limits<double>::infinity();
  double longest_move_mm = 0.15;  ///< of a node in a step; longer ones let leaflets jump through
  /// A node's mass over the sum of its stiffness. The guaranteed bound is half of that sum; contact
  /// and damping take a little more. Less is a longer step, without guarantee.
  double mass_share = 0.55;
  /// Moves by what balances the forces on the leaflets as a whole (stiffness_laplacian.h), not on each node alone. Damping
  /// is then the same on every mesh.
  bool preconditioned = false;
  ContactLaw contact;
  bool guards = true;              ///< see above; without, crossings are only reported
  int samples = 1;                 ///< end states recorded, five steps apart
  bool motion = false;             ///< record states on the way, 15 steps apart
  Allowance* allowance = nullptr;  ///< may be null; must outlive the relaxation
  kernels::InstructionSet instructions = kernels::best_instruction_set();
  /// For relaxations in single precision: of their model, contact (but for edges) and instructions. Null:
  /// they make their own.
  const RelaxationLayout<float>* layout = nullptr;
};

/// Of dampings of 0.04, 0.05, 0.06, 0.08 and 0.12 this one takes the fewest steps at 2,600 and 10,400 triangles.
inline constexpr double kPreconditionedDamping = 0.06;

/// The same, preconditioned.
inline RelaxationSettings preconditioned(RelaxationSettings settings) {
  settings.preconditioned = true;
  settings.damping = kPreconditionedDamping;
  settings.least_damping = std::numeric_limits<double>::infinity();
  return settings;
}

}  // namespace coapt
