// Threads that run jobs, one job each at a time, below the priority of those that answer requests.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "server/jobs/job_board.h"

namespace coapt {

/// What a kind of job does, from the first closure to its files. No end: the server stops, and the job goes
/// on when it is started again. What it throws makes the job FAILED, unless the server stops.
using JobWork = std::function<std::optional<JobEnd>(RunningJob&)>;

class JobRunner {
 public:
  /// @param work by kind of job. @param after called with each job whose end is kept; must not throw
  JobRunner(JobBoard& board, std::map<std::string, JobWork> work, int threads,
            std::function<void(const Job&)> after = {});
  /// @pre board.stop() was called. Waits for the jobs to end.
  ~JobRunner();

 private:
  void run();
  std::optional<JobEnd> run_one(RunningJob& job) const;
  std::optional<JobEnd> end_of(RunningJob& job) const;

  JobBoard& board_;
  std::map<std::string, JobWork> work_;
  std::function<void(const Job&)> after_;
  std::vector<std::thread> threads_;
};

/// An end for a job that can never be done: why, as problems.
JobEnd failed(const RunningJob& job, const Errors& errors);

/// The end of a job with its time and progress, still without results.
JobEnd ended(const RunningJob& job, JobState state);

}  // namespace coapt
