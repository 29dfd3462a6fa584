// Imported chordae and ties attached to a resampled skirt.
#pragma once

#include "io/mesh/skirt.h"

namespace coapt {

/// Adds heads (tips within 0.1 mm of each other are one) and chordae to a valve that has its mesh.
/// An insertion within 3 mm of the free edge is marginal: it goes to the nearest point of the edge
/// and branches there. Others go to the nearest point of the surface, without branches. A traced tree is kept: each of its insertions is moved so, and a given rest length changes by as much
/// as the piece's. Says in the
/// valve's provenance what was moved. Errors: an insertion further than 8 mm from the leaflets.
Errors add_imported_chordae(const FramedSource& source, const Skirt& skirt,
                            const ImportOptions& options, Valve& valve,
                            std::vector<ImportDecision>& decisions);

/// Adds ties, each end at the nearest point of its leaflet. Errors: an end further than 8 mm from it; ties of leaflets that were
/// imaged closed, whose edges nobody saw.
Errors add_imported_ties(const FramedSource& source, bool closed, Valve& valve,
                         std::vector<ImportDecision>& decisions);

}  // namespace coapt
