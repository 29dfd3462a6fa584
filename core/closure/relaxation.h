// Method fast: relaxation to rest. Each node weighs as much as its present stiffness asks for
// (Gershgorin), so that all modes may take a step of the same length; heavy damping; SIMD kernels.
//
// The path to rest is not that of real time: only the end counts. Start: the unstressed shape under
// full pressure, annulus and papillary tips travelling to their places. At rest means: rms free
// force / rms pressure force below the tolerance and the predicted way to rest, from how fast the
// moves of the last steps shrink, below its own.
//
// Contact of vertices and faces lets sharp folds pass through each other edge by edge; contact of
// all edges costs as much again. So crossings are looked for on the way: where there are some, the
// relaxation goes back to when there were none and on with contact of the edges around them
// (guards).
#pragma once

#include "core/closure/model.h"
#include "core/closure/relaxation_settings.h"
#include "core/closure/run.h"

namespace coapt {

/// R is float or double. `start`: from its end and with its guards; null: from the unstressed
/// shape. Annulus and tips travel from where they are there.
template <class R>
ClosureRun relax(const ClosureModel& model, const RelaxationSettings& settings,
                 const ClosureRun* start = nullptr);

}  // namespace coapt
