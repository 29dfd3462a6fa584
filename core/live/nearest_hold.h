// What a hook at a place would take hold of.
#pragma once

#include "core/live/live_valve.h"

namespace coapt {

struct Hold {
  int vertex = -1;     ///< of a leaflet, or
  int cable = -1;      ///< as in LiveValve::cables(), and
  double share = 0.0;  ///< of the way along it
  Vec3 spot_mm = Vec3::Zero();
};

/// The leaflet vertex or the place on a chorda that is nearest. Where a chorda ends in a leaflet, the leaflet: a chorda must be
/// nearer by the radius of the hook.
Hold nearest_hold(const LiveValve& live, const Vec3& place_mm);

void grab(LiveValve& live, int hook, const Hold& hold);

}  // namespace coapt
