// Plans of one's own, scored at once as a search scores its finalists.
#pragma once

#include "server/compute.h"
#include "server/json_body.h"
#include "server/route.h"

namespace coapt {

/// POST /v1/evaluations {"valve", "plans": [...], "region_points" (optional, 1), "evidence" (optional, false)}: scores and ranks plans, answered in
/// the order asked, each with its "index" and "rank"; as one of coapt.plans/2 otherwise.
struct PostEvaluations {
  ValveSource valves;
  Compute& compute;
  Answer operator()(const Request& request) const;
};

/// POST /v1/reports, with the same body but ten plans at most: the report on them, one HTML page.
struct PostReports {
  ValveSource valves;
  Compute& compute;
  Answer operator()(const Request& request) const;
};

}  // namespace coapt
