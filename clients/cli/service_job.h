// Long work of a service, followed from here.
#pragma once

#include <atomic>
#include <string>

#include "clients/cli/service.h"

namespace coapt {

struct ServiceJob {
  std::string path;   ///< "/v1/jobs/ID"
  std::string state;  ///< "SUCCEEDED" or "CANCELLED"
};

/// Submits a request to /v1/plans or /v1/studies and shows its progress until it has ended. When `interrupted` becomes
/// true it is cancelled; then it ends soon, with the best so far. Errors: those of the service, or why the job failed.
Expected<ServiceJob> run_job(const Service& service, const std::string& path, const Json& request,
                             const std::atomic<bool>& interrupted);

}  // namespace coapt
