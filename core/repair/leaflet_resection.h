// Leaflet resection: a wedge or a strip of a leaflet is cut out and the edges of the cut are sewn
// together.
//
// What is left of the leaflet is told to the same mesh: in each row from commissure to commissure the
// vertices on either side of the cut spread over the tissue that is left there, and the cut lies
// between them. Rest lengths are those of that tissue, and the unstressed shape follows from them
// (sewn_shape.h). So faces and vertices keep their indices, and a place on the leaflet
// (LeafletPoint) is from now on one on what is left.
//
// - Triangular: as wide as told at the free edge, nothing where it ends, `height` of the way to the
//   annulus. The annulus stays.
// - Quadrangular, posterior leaflet only: as wide from the free edge to the annulus. With sliding
//   what is left is detached from commissure to commissure and sewn to the whole posterior annulus
//   again, evenly, which stays. Without, the annulus where the tissue was is gathered away
//   (plication): its two halves turn about the commissures until they meet.
// - Chordae that inserted into what was cut out are cut: of a tree those branches.
//
// Assumed: the seam is as soft as the leaflet and takes no tissue. Not modelled: the lower leaflet
// that a sliding plasty makes of a high one.
#pragma once

#include <string>

#include "core/repair/plan.h"
#include "core/valve/problem_list.h"

namespace coapt {

bool check_resection(const LeafletResection& step, const LeafletCoordinates& coordinates,
                     const Valve& valve, const std::string& path, ProblemList& problems);

/// @pre check_resection()
void apply_resection(const LeafletResection& step, const LeafletCoordinates& coordinates,
                     Valve& valve);

/// The seam, from its end towards the annulus to the free edge. @param valve the repaired one, and
/// its coordinates
std::vector<Insertion> seam_of(const LeafletResection& step, const LeafletCoordinates& coordinates,
                               const Valve& valve);

}  // namespace coapt
