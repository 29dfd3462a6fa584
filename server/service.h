// All that endpoints stand on, and the table of routes.
#pragma once

#include <functional>
#include <vector>

#include "core/repair/plan.h"
#include "server/compute.h"
#include "server/http.h"
#include "server/jobs/job_board.h"
#include "server/limits.h"
#include "server/metrics.h"
#include "server/route.h"

namespace coapt {

struct Service {
  const ServiceLimits& limits;
  const std::vector<RingShape>& rings;
  JobStore& store;
  JobBoard& jobs;
  Compute& compute;
  const Metrics& metrics;
  std::function<HttpLoad()> load;  ///< of the HTTP server
};

/// The service must outlive them.
Routes routes_of(const Service& service);

}  // namespace coapt
