// A job that redoes studies of the thesis on a valve.
#pragma once

#include <string>

#include "server/jobs/job_runner.h"
#include "server/limits.h"

namespace coapt {

/// Every closure is kept in `closures` (a ClosureStore) as it is made. Result: what study.json holds, and the findings.
/// Files: those of `coapt study`, index.html too. Out of time it is FAILED; asked for again it goes on.
struct StudyJob {
  JobBoard& board;
  const JobStore& store;
  const ServiceLimits& limits;
  std::string closures;  ///< path
  std::string farm{};    ///< that closes a study's batches; empty: this process

  std::optional<JobEnd> operator()(RunningJob& job) const;
};

}  // namespace coapt
