// Which marginal chordae hold which scallop, and a valve in which they are ruptured.
#pragma once

#include <vector>

#include "core/valve/valve.h"

namespace coapt {

/// Of A1 to A3 and P1 to P3, in that order, those that marginal chordae which are not ruptured insert in.
std::vector<Segment> held_segments(const Valve& valve);

/// The valve with the marginal chordae that insert in a segment ruptured. Of a chorda with several insertions it is the segment of
/// most of them, the first of equals. One that inserts at a commissure, or in both leaflets, is commissural: it stays.
/// @pre the valve is mitral.
Valve with_ruptured(Valve valve, Segment segment);

}  // namespace coapt
