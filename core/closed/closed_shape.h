// The leaflets of a closed valve as a surface, to be compared with others.
#pragma once

#include "core/closed/closed_valve.h"
#include "core/metrics/shape_comparison.h"

namespace coapt {

/// The closed leaflets, anterior and posterior. @pre the closure is finite
LeafletMesh shape_of(const ClosedValve& closed);

}  // namespace coapt
