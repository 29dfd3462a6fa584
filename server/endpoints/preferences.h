// Which of two plans an expert would rather do, and what that says of the weights of the cost.
#pragma once

#include "server/compute.h"
#include "server/json_body.h"
#include "server/route.h"

namespace coapt {

/// POST /v1/preferences {"cases", "answers", "hide_figures" (optional)}: what the answers say so far and the next question.
/// Nothing is kept.
struct PostPreferences {
  ValveSource valves;
  Compute& compute;
  Answer operator()(const Request& request) const;
};

}  // namespace coapt
