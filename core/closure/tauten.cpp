#include "core/closure/tauten.h"

#include "core/closure/insertion_zone.h"

namespace coapt {

Valve tauten(const Valve& valve, const ClosureResult& closed, double slack) {
  Valve taut = valve;
  for (std::size_t c = 0; c < taut.chordae.size(); ++c) {
    Chorda& chorda = taut.chordae[c];
    if (chorda.ruptured) continue;
    for (std::size_t s = 0; s < chorda.segments.size(); ++s) {
      ChordaSegment& segment = chorda.segments[s];
      const Vec3 start = segment.parent < 0 ? taut.heads[chorda.head].tip_mm
                                            : Vec3(closed.branch_points_mm[c].row(segment.parent));
      const Vec3 end =
          segment.inserts ? mean_position(insertion_zone(valve, segment.insertion, segment.zone_mm),
                                          closed.closed_mm)
                          : Vec3(closed.branch_points_mm[c].row(s));
      segment.rest_length_mm = slack * (end - start).norm();
    }
  }
  return taut;
}

}  // namespace coapt
