// Method fast: relaxation to rest. Each node weighs as much as its present stiffness asks for
// (Gershgorin), so that all modes may take a step of the same length; heavy damping; SIMD kernels.
//
// The path to rest is not that of real time: only the end counts. Start: the unstressed shape under
// full pressure, annulus and papillary tips travelling to their places. At rest means: rms free force
// / rms pressure force below the tolerance and the predicted way to rest, from how fast the moves of
// the last steps shrink, below its own.
//
// Contact of vertices and faces lets sharp folds pass through each other edge by edge; contact of all
// edges costs as much again. So crossings are looked for on the way: where there are some, the relaxation
// goes back to when there were none and on with contact of the edges around them (guards).
#pragma once

#include "core/closure/contact.h"
#include "core/closure/kernels/kernels.h"
#include "core/closure/model.h"
#include "core/closure/run.h"

namespace coapt {

struct RelaxationSettings {
  double residual_tolerance = 0.005;
  double way_tolerance_mm = 0.02;  ///< predicted rms way of the leaflets to rest
  int max_steps = 6000;
  double damping = 0.06;  ///< share of a velocity lost in a step at 650 triangles (relaxation.cpp)
  double longest_move_mm = 0.15;  ///< of a node in a step; longer ones let leaflets jump through
  /// A node's mass over the sum of its stiffness. The guaranteed bound is half of that sum; contact and
  /// damping take a little more. Less is a longer step, without guarantee.
  double mass_share = 0.55;
  ContactLaw contact;
  bool guards = true;   ///< see above; without, crossings are only reported
  int samples = 1;      ///< end states recorded, five steps apart
  bool motion = false;  ///< record states on the way, 15 steps apart
  kernels::InstructionSet instructions = kernels::best_instruction_set();
};

/// R is float or double. `start`: from its end and with its guards; null: from the unstressed shape.
/// Annulus and tips travel from where they are there.
template <class R>
ClosureRun relax(const ClosureModel& model, const RelaxationSettings& settings,
                 const ClosureRun* start = nullptr);

}  // namespace coapt
