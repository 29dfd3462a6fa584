// A job that searches repair plans.
#pragma once

#include <string>

#include "core/repair/plan.h"
#include "server/jobs/job_runner.h"
#include "server/limits.h"

namespace coapt {

/// Every closure is kept in `closures` (a PlanStore) as it is made: a job that was killed goes on from them, to the
/// same plans. Result: coapt.plans/1. Files: report.html, and plan-RANK.html of each plan alone.
struct PlanJob {
  JobBoard& board;
  const JobStore& store;
  const ServiceLimits& limits;
  const std::vector<RingShape>& rings;
  std::string closures;  ///< path

  std::optional<JobEnd> operator()(RunningJob& job) const;
};

}  // namespace coapt
