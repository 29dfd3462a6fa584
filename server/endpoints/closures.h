// Closures that are answered at once.
#pragma once

#include "server/compute.h"
#include "server/json_body.h"
#include "server/route.h"

namespace coapt {

/// POST /v1/closures {"valve", "plan" (optional)}: closes the valve, repaired if there is a plan. Answers what `coapt close --json` prints.
struct PostClosures {
  ValveSource valves;
  Compute& compute;
  Answer operator()(const Request& request) const;
};

/// POST /v1/scenes {"valve", "plan" (optional), "frames" (optional, 0)}: the same closure as everything that is drawn of
/// it (scene_json.h); with frames, the way there.
struct PostScenes {
  ValveSource valves;
  Compute& compute;
  Answer operator()(const Request& request) const;
};

}  // namespace coapt
