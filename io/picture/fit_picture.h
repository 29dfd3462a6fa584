// A fit for people: its map and its sentence.
#pragma once

#include <string>

#include "core/metrics/shape_comparison.h"
#include "search/fit/fit.h"

namespace coapt {

/// PNG bytes: what distance is left of a surface with faces. @param name of the surface
std::string fit_map_png(const LeafletMesh& surface, const ValveFit& fit, MeasuredSide side,
                        const std::string& name);

/// For the fitted valve's provenance: "fitted to NAME: distances 1.20 mm rms before, 0.40 mm after; ..."
std::string fit_sentence(const ValveFit& fit, const std::string& name);

}  // namespace coapt
