// The service without a network: what coapt-server answers, from its own endpoints, in this process.
#pragma once

#include <memory>
#include <string>

#include "clients/python/engine/local_valve.h"
#include "operations/operation.h"
#include "server/jobs/closure_retention.h"
#include "server/jobs/job_runner.h"
#include "server/route.h"
#include "server/service.h"

namespace coapt {

/// Limits of a service that only its own process asks: none.
ServiceLimits local_limits(int threads);

class LocalService {
 public:
  /// @param database file of valves, jobs and closures; made if it is not there @param threads of a job or an evaluation, and
  /// requests computed at once; 0: all cores. Does not change any answer. Throws Problems: the file cannot be used.
  LocalService(const std::string& database, int threads);
  /// Jobs that run are QUEUED again in the file. Waits for their closures to end.
  ~LocalService() { board_.stop(); }
  LocalService(const LocalService&) = delete;

  /// From many threads at once.
  Answer answer(Request request) const;
  /// What an operation answers to a request as JSON, without an endpoint: within `context`, whose valves, files and threads are
  /// those of this service. Throws Problems.
  std::string compute(const std::string& operation, const std::string& request, Context& context);
  /// A preset or a stored valve. Throws Problems at "/valve".
  LocalValve named(const std::string& name);

 private:
  const std::string database_;
  const ServiceLimits limits_;
  JobStore store_;
  JobBoard board_;
  ClosureRetention retention_;
  Metrics metrics_;
  ValveCache known_;
  Compute parsing_, compute_;
  SearchReports reports_;
  FarmWatch farm_{std::nullopt};
  const Page page_;
  const PageTokens tokens_;
  const Service service_;
  const Routes routes_;
  std::unique_ptr<JobRunner> runner_;  // ends first
};

}  // namespace coapt
