#include "core/live/nearest_hold.h"

#include <algorithm>
#include <cmath>

namespace coapt {

Hold nearest_hold(const LiveValve& live, const Vec3& place_mm) {
  const Points& x = live.vertices_mm();
  Index vertex = 0;
  const double leaflet_mm = std::sqrt((x.topRows(live.vertices()).rowwise() - place_mm.transpose())
                                          .rowwise()
                                          .squaredNorm()
                                          .minCoeff(&vertex));
  Hold hold{static_cast<int>(vertex), -1, 0.0, x.row(vertex)};
  double nearest_mm = leaflet_mm - kHookRadius_mm;
  const std::vector<LiveCable> cables = live.cables();
  for (std::size_t c = 0; c < cables.size(); ++c) {
    const Vec3 way = cables[c].end_mm - cables[c].start_mm;
    const double length2 = std::max(way.squaredNorm(), 1e-12);
    const double share = std::clamp(way.dot(place_mm - cables[c].start_mm) / length2, 0.0, 1.0);
    const Vec3 spot = cables[c].start_mm + share * way;
    const double distance_mm = (place_mm - spot).norm();
    if (distance_mm >= nearest_mm) continue;
    nearest_mm = distance_mm;
    hold = {-1, static_cast<int>(c), share, spot};
  }
  return hold;
}

void grab(LiveValve& live, int hook, const Hold& hold) {
  if (hold.vertex >= 0) {
    live.grab(hook, hold.vertex);
  } else {
    live.grab_cable(hook, hold.cable, hold.share);
  }
}

}  // namespace coapt
