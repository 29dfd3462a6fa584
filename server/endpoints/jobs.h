// Jobs: seen, listed, cancelled, removed.
#pragma once

#include "server/jobs/job_board.h"
#include "server/page_tokens.h"
#include "server/route.h"

namespace coapt {

/// GET /v1/jobs/{id}
struct GetJob {
  const JobBoard& jobs;
  Answer operator()(const Request& request) const;
};

/// GET /v1/jobs?page_size=&page_token=&state=: newest first.
struct GetJobs {
  const JobStore& store;
  const JobBoard& jobs;
  const PageTokens& tokens;
  Answer operator()(const Request& request) const;
};

/// POST /v1/jobs/{id}:cancel: keeps the best so far.
struct CancelJob {
  JobBoard& jobs;
  Answer operator()(const Request& request) const;
};

/// DELETE /v1/jobs/{id}, when it has ended.
struct DeleteJob {
  JobStore& store;
  Answer operator()(const Request& request) const;
};

}  // namespace coapt
