// Valves beside what was measured in hearts, answered at once.
#pragma once

#include "server/compute.h"
#include "server/json_body.h"
#include "server/route.h"

namespace coapt {

/// POST /v1/physiology {"valve", "plan", "material", "kind", "species" (optional but for the valve)}: closes and opens the valve, repaired
/// if there is a plan, 17 times, all in one turn. Answers what `coapt study physiology --json` prints.
struct PostPhysiology {
  ValveSource valves;
  Compute& compute;
  Answer operator()(const Request& request) const;
};

}  // namespace coapt
