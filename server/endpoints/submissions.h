// Work that takes longer than a request: it becomes a job.
#pragma once

#include "server/jobs/job_board.h"
#include "server/json_body.h"
#include "server/route.h"

namespace coapt {

/// What a submission needs, whatever its kind.
struct Submitting {
  ValveSource valves;
  JobBoard& jobs;
};

/// POST /v1/plans {"valve", "search" (optional)}: 202 and the job, or 200 if it ends within Prefer: wait.
struct PostPlans {
  Submitting submitting;
  Answer operator()(const Request& request) const;
};

/// POST /v1/studies {"valve", "study"}: likewise.
struct PostStudies {
  Submitting submitting;
  Answer operator()(const Request& request) const;
};

}  // namespace coapt
