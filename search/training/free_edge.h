// The free edge of the leaflets, segment by segment: where a valve is pulled when its mobility is judged.
#pragma once

#include <array>
#include <vector>

#include "core/valve/valve.h"

namespace coapt {

inline constexpr std::size_t kSegments = 8;
/// In the order of their enumeration.
inline constexpr std::array<Segment, kSegments> kAllSegments = {
    Segment::A1, Segment::A2, Segment::A3, Segment::P1,
    Segment::P2, Segment::P3, Segment::AC, Segment::PC};

/// Clockwise from the reference P1 as the surgeon sees the valve, from the atrium (thesis 3.4).
inline constexpr std::array<Segment, kSegments> kVisitingOrder = {
    Segment::P1, Segment::AC, Segment::A1, Segment::A2,
    Segment::A3, Segment::PC, Segment::P3, Segment::P2};

struct FreeEdge {
  std::vector<int> vertices;                 ///< ascending
  std::array<int, kSegments> middle_vertex;  ///< by Segment, of each segment's part
};

/// Error: a segment has no free edge, "/segments". @pre validate(valve) is empty; the valve is mitral.
Expected<FreeEdge> free_edge(const Valve& valve);

}  // namespace coapt
