// An operation that takes longer than a request, as a job.
#pragma once

#include "operations/operation.h"
#include "server/jobs/import_reading.h"
#include "server/jobs/job_board.h"
#include "server/jobs/job_runner.h"

namespace coapt {

/// Runs the request that was kept as the job's input. After a restart it begins anew.
struct OperationJob {
  Operation operation;
  JobBoard& board;
  JobStore& store;
  ImportReader reader;  ///< of files in requests

  std::optional<JobEnd> operator()(RunningJob& job) const;
};

/// Adds the works of all operations that services run as jobs, by their names.
std::map<std::string, JobWork> with_operations(std::map<std::string, JobWork> works,
                                               JobBoard& board, JobStore& store,
                                               const ImportReader& reader);

}  // namespace coapt
