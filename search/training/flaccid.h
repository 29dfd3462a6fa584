// The valve without pressure: how it lies, and how far its free edge can be pulled towards the atrium.
#pragma once

#include <array>

#include "search/training/free_edge.h"

namespace coapt {

/// The valve of an arrested, empty heart: nothing draws the papillary muscles from the annulus, so that chordae hang slack and tell
/// nothing of their lengths until a hook pulls them. Its tips are nearer to the annulus than in systole by a quarter (assumed).
Valve arrested(Valve valve);

/// The leaflets without pressure, of the arrested heart, |V| x 3. After 1,800 steps of the moving valve
/// (core/live): within 0.2 mm rms of where it would come to rest after 8,000 (presets), and two valves of one mesh are no more
/// than 0.02 mm farther apart than there.
Points flaccid_mm(const Valve& valve);

/// Between two valves of one mesh without pressure, rms: over all vertices or over those of the free edge, which an eye follows,
/// whichever is more. @param one_mm |V| x 3
double flaccid_difference_mm(const FreeEdge& edge, const Points& one_mm, const Points& other_mm);

/// By Segment.
using SegmentHeights = std::array<double, kSegments>;

/// Surgical force of a nerve hook on one segment.
inline constexpr double kAnalysisPull_n = 0.2;

/// Heights (z) that the middles of the free edges reach in the arrested heart when each is pulled by itself towards the atrium, within
/// 0.1 mm of where they come to rest; the difference of two valves of one mesh within 0.05 mm.
SegmentHeights pulled_heights_mm(const Valve& valve, const FreeEdge& edge,
                                 double pull_n = kAnalysisPull_n);

}  // namespace coapt
