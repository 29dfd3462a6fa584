#include "core/valve/ruptures.h"

#include <algorithm>

#include "core/valve/leaflet_of.h"

namespace coapt {
namespace {

bool holds_still(const Valve& valve, const Chorda& chorda, Segment segment) {
  return chorda.kind == ChordaKind::Marginal && !chorda.ruptured &&
         held_by(valve, chorda) == segment;
}

}  // namespace

std::optional<Segment> held_by(const Valve& valve, const Chorda& chorda) {
  std::vector<Segment> ends;
  for (const ChordaSegment& segment : chorda.segments)
    if (segment.inserts)
      ends.push_back(valve.segments[static_cast<std::size_t>(segment.insertion.face)]);
  const bool one_leaflet = std::all_of(ends.begin(), ends.end(), [&](Segment end) {
    return leaflet_of(end) && leaflet_of(end) == leaflet_of(ends.front());
  });
  if (!one_leaflet) return std::nullopt;
  const auto count = [&](Segment end) { return std::count(ends.begin(), ends.end(), end); };
  return *std::max_element(ends.begin(), ends.end(),
                           [&](Segment a, Segment b) { return count(a) < count(b); });
}

std::vector<Segment> held_segments(const Valve& valve) {
  std::vector<Segment> held;
  for (const Segment scallop : kScallops)
    if (std::any_of(valve.chordae.begin(), valve.chordae.end(),
                    [&](const Chorda& chorda) { return holds_still(valve, chorda, scallop); }))
      held.push_back(scallop);
  return held;
}

bool holds_all_scallops(const Valve& valve) {
  std::vector<Segment> held;
  for (const Chorda& chorda : valve.chordae) {
    const bool holds = chorda.kind == ChordaKind::Marginal || chorda.kind == ChordaKind::Neochorda;
    if (!holds || chorda.ruptured) continue;
    for (const ChordaSegment& segment : chorda.segments)
      if (segment.inserts)
        held.push_back(valve.segments[static_cast<std::size_t>(segment.insertion.face)]);
  }
  return std::all_of(kScallops.begin(), kScallops.end(), [&](Segment scallop) {
    return std::find(held.begin(), held.end(), scallop) != held.end();
  });
}

Valve with_ruptured(Valve valve, Segment segment) {
  for (Chorda& chorda : valve.chordae)
    if (holds_still(valve, chorda, segment)) chorda.ruptured = true;
  return valve;
}

}  // namespace coapt
