// How far a state is from rest: the one measure by which every method is judged.
#pragma once

#include "core/closure/model.h"

namespace coapt {

/// Rms over the nodes that move, N. `nodes`: the first so many of them.
double rms_free(const ClosureModel& model, const Points& force, int nodes);

/// Rms of the free nodes' force / rms of the free vertices' pressure force (the former alone
/// without pressure). `force` |N| x 3: of membrane, cables, pressure and contact at `x`.
double residual(const ClosureModel& model, const Points& x, const Points& force);

}  // namespace coapt
