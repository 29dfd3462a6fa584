// A job that searches repair plans.
#pragma once

#include <optional>
#include <string>

#include "io/json/plans_json.h"
#include "server/jobs/job_runner.h"
#include "server/limits.h"

namespace coapt {

/// Of a search that has ended: every plan tried (io/picture/search_csv.h).
inline constexpr const char* kTriedPlansFile = "evaluations.csv";

/// Every closure is kept in `closures` (a PlanStore) as it is made: a job that was killed goes on from them, to the
/// same plans. Result: coapt.plans/2. Files: evaluations.csv. Reports: search_reports.h.
struct PlanJob {
  JobBoard& board;
  const JobStore& store;
  const ServiceLimits& limits;
  std::string closures;  ///< path
  std::string farm{};    ///< that makes searches without a limit of time; empty: this process

  std::optional<JobEnd> operator()(RunningJob& job) const;
};

/// What is told in the job itself of a search that has ended: {"stop", "any_competent", "plans"}.
/// @param plans coapt.plans/2
std::string search_summary(const Json& plans);

}  // namespace coapt
