// All that endpoints stand on.
#pragma once

#include <functional>

#include "server/compute.h"
#include "server/farm_watch.h"
#include "server/http.h"
#include "server/jobs/import_reading.h"
#include "server/jobs/job_board.h"
#include "server/jobs/search_reports.h"
#include "server/limits.h"
#include "server/metrics.h"
#include "server/page.h"
#include "server/page_tokens.h"
#include "server/route.h"
#include "server/valve_cache.h"

namespace coapt {

struct Service {
  const ServiceLimits& limits;
  JobStore& store;
  JobBoard& jobs;
  ValveCache& known;
  Compute& parsing;  ///< turns for bodies that are read
  Compute& compute;  ///< turns for closures that are waited for
  ImportReader imports;
  SearchReports& reports;
  FarmWatch& farm;
  const Metrics& metrics;
  const Page& page;
  const PageTokens& tokens;
  std::function<HttpLoad()> load;  ///< of the HTTP server
};

}  // namespace coapt
