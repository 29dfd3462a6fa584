#pragma once

#include "server/jobs/job_board.h"
#include "server/route.h"

namespace coapt {

/// GET /v1/jobs/{id}/events: server-sent events (WHATWG HTML, 9.2) from after Last-Event-ID on, a heartbeat every
/// 15 s, until the job has ended; 204, which tells a browser to ask no more, if nothing can come.
struct GetJobEvents {
  const JobStore& store;
  const JobBoard& jobs;
  Answer operator()(const Request& request) const;
};

}  // namespace coapt
