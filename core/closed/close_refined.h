// The same valve on a mesh of four times the triangles.
#pragma once

#include <optional>

#include "core/closed/closed_valve.h"

namespace coapt {

/// Closes the refined valve from the closed state it has (core/closure/refined_start.h); its plan
/// and marks are left out. Empty where that mesh would have more than `most_vertices` vertices, or
/// validate() refuses it.
std::optional<ClosedValve> close_refined(const ClosedValve& closed, const ClosureOptions& options,
                                         int most_vertices);

}  // namespace coapt
