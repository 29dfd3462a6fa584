// Work that takes longer than a request: it becomes a job.
#pragma once

#include "operations/operation.h"
#include "server/jobs/import_reading.h"
#include "server/jobs/job_board.h"
#include "server/json_body.h"
#include "server/route.h"

namespace coapt {

/// What a submission needs, whatever its kind.
struct Submitting {
  ValveSource valves;
  JobBoard& jobs;
};

struct SubmittedWork {
  std::string kind;  ///< of job
  const Valve& valve;
  Json asked;              ///< by which an idempotency key knows its request
  std::string input = {};  ///< see NewJob
};

/// 202 and the job, or 200 if it ends within Prefer: wait; or why it is not taken.
Answer submit(const Submitting& to, const Request& request, const SubmittedWork& work);

/// POST /v1/plans {"valve", "search" (optional)}
struct PostPlans {
  Submitting submitting;
  Answer operator()(const Request& request) const;
};

/// POST /v1/studies {"valve", "study"}: likewise.
struct PostStudies {
  Submitting submitting;
  Answer operator()(const Request& request) const;
};

/// POST of an operation that runs as a job: likewise. The job keeps the request until it has ended.
struct SubmitOperation {
  Operation operation;
  Submitting submitting;
  const ImportReader& imports;  ///< of files in requests
  Compute& compute;             ///< turns for those files
  Answer operator()(const Request& request) const;
};

}  // namespace coapt
