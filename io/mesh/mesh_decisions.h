// What an import tells of the mesh that it made.
#pragma once

#include "io/mesh/skirt.h"

namespace coapt {

/// Of leaflets that were imaged closed.
std::vector<ImportDecision> closed_decisions(const Skirt& skirt, double hidden_mm,
                                             const Valve& valve);

/// Of the others. @param own_tissue it came with the source. @param budget cancelled: the distance is that of some vertices
std::vector<ImportDecision> mesh_decisions(const FramedSource& source, const Skirt& skirt,
                                           const Valve& valve, bool own_tissue,
                                           const ClosureBudget& budget);

}  // namespace coapt
