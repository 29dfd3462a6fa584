// A search for plans that a farm makes.
#pragma once

#include <optional>

#include "core/valve/valve.h"
#include "farm/ask/ask.h"
#include "search/plans/search_options.h"
#include "server/jobs/job_runner.h"
#include "server/limits.h"

namespace coapt {

struct FarmPlan {
  JobBoard& board;
  const ServiceLimits& limits;
  Asker farm;

  /// Its end as PlanJob's, but that nothing is found if it is cancelled. Of searches without a limit of time: no clock may
  /// decide what a farm answers. Out of the service's time it is FAILED; the farm goes on, and asked for again it is there.
  std::optional<JobEnd> operator()(RunningJob& job, const Valve& valve,
                                   const SearchOptions& asked) const;
};

}  // namespace coapt
