// How the service is, for those that watch it.
#pragma once

#include <functional>

#include "server/farm_watch.h"
#include "server/jobs/job_board.h"
#include "server/metrics.h"
#include "server/route.h"

namespace coapt {

/// GET /healthz/live: the process answers.
struct GetLive {
  Answer operator()(const Request& request) const;
};

/// GET /healthz/ready: a small valve closes, the store can be written, the server is not about to stop.
struct GetReady {
  JobStore& store;
  const JobBoard& jobs;
  Answer operator()(const Request& request) const;
};

/// GET /metrics
struct GetMetrics {
  const Metrics& metrics;
  const JobBoard& jobs;
  std::function<HttpLoad()> load;
  Answer operator()(const Request& request) const;
};

/// GET /v1/farm: 404 if the service has none.
struct GetFarm {
  FarmWatch& farm;
  Answer operator()(const Request& request) const;
};

/// GET /version
struct GetVersion {
  const FarmWatch& farm;
  Answer operator()(const Request& request) const;
};

/// GET /openapi.json
struct GetOpenApi {
  Answer operator()(const Request& request) const;
};

}  // namespace coapt
