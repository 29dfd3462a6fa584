// Which marginal chordae hold which scallop, and a valve in which they are ruptured.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/valve/valve.h"

namespace coapt {

inline constexpr std::array kScallops = {Segment::A1, Segment::A2, Segment::A3,
                                         Segment::P1, Segment::P2, Segment::P3};

/// Of kScallops, in that order, those that marginal chordae which are not ruptured insert in.
std::vector<Segment> held_segments(const Valve& valve);

/// The scallop that a chorda holds: of its insertions' segments that of most of them, the first of equals. None if it is
/// commissural: it inserts at a commissure, or in both leaflets.
std::optional<Segment> held_by(const Valve& valve, const Chorda& chorda);

/// Whether a marginal chorda that is not ruptured, or a neochorda, inserts in each scallop.
/// @pre the valve is mitral.
bool holds_all_scallops(const Valve& valve);

/// The valve with the marginal chordae that hold a segment ruptured.
/// @pre the valve is mitral.
Valve with_ruptured(Valve valve, Segment segment);

}  // namespace coapt
