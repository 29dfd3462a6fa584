// Why a valve leaks, answered at once.
#pragma once

#include "server/compute.h"
#include "server/json_body.h"
#include "server/route.h"

namespace coapt {

/// POST /v1/diagnoses {"valve", "plan", "material" (optional but for the valve)}: closes and opens the valve, repaired if there is a plan.
/// Answers what `coapt diagnose --json` prints; 422 if the closure is not to be trusted.
struct PostDiagnosis {
  ValveSource valves;
  Compute& compute;
  Answer operator()(const Request& request) const;
};

}  // namespace coapt
