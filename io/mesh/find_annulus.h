// The annulus where none was traced: the outlines of the sheets know it.
//
// Idea: the outline of a leaflet is its annular part and its free edge. Seen from a point q on the valve's axis, as far below
// the sheets' outlines as they reach, the annular part is the one that leads round the axis at the greatest distance g from q.
// Of each outline the stretch i to j is taken that makes
//   J(i, j) = integral of (g / mean g) r dphi + kEnds (g_i + g_j)
// greatest, less kJoin times the gap to the ends of the other sheet's stretch, in turns: along an edge at the commissure g falls without progress, along the free edge progress is negative. 26 directions of
// the axis about the principal ones of the outlines are tried, each again with the normal of its loop; the loop with the greatest
// score wins: projected area less perimeter times (distance from its plane, rms, beyond that of a saddle, + half the mean gap where stretches meet + 1.5 times how far
// the sheets lie on either side of its plane), less twice the share of the outlines outside of it. Papillary tips, where there are any, must lie on the side of q.
//
// Limits: a funnel as wide at the free edge as at the annulus tells them apart only by tips; without, the two loops score alike
// and the import asks for the annulus.
#pragma once

#include "io/mesh/import_valve.h"

namespace coapt {

struct FoundAnnulus {
  Points annulus_mm;    ///< closed loop, at equal angles about its axis
  double margin = 0.0;  ///< by how much its score exceeds that of the next other loop, of its own
  double off_plane_mm = 0.0;  ///< rms
  double gap_mm =
      0.0;  ///< where the stretches of the two sheets meet, in the mean; at least half of what neither leads through
};

/// Sheets must be repaired ones (sheet_repair.h). Errors at /annulus_mm: it cannot be told.
Expected<FoundAnnulus> find_annulus(const ImportSource& source);

}  // namespace coapt
