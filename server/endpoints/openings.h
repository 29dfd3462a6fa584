// Valves in diastole, answered at once.
#pragma once

#include "server/compute.h"
#include "server/json_body.h"
#include "server/route.h"

namespace coapt {

/// POST /v1/openings {"valve", "plan", "pressure_mmhg", "flow_ml_s", "exercise", "frames" (optional but for the valve)}: opens the
/// valve, repaired if there is a plan. Answers what `coapt open --json` prints, and what is drawn of it (scene_json.h).
struct PostOpenings {
  ValveSource valves;
  Compute& compute;
  Answer operator()(const Request& request) const;
};

}  // namespace coapt
