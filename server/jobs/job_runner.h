// Threads that run jobs, one job each at a time, at a priority of their own.
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
  /// Against a request, where both want a core: nice 10 has a ninth of the weight of nice 0. With 19, a sixty-eighth, a
  /// busy machine starved searches (26 closures in 300 s).
  static constexpr int kBelowRequests = 10;

  /// @param work by kind of job. @param after called with each job whose end is kept; must not throw. @param nice of the
  /// threads
  JobRunner(JobBoard& board, std::map<std::string, JobWork> work, int threads,
            std::function<void(const Job&)> after = {}, int nice = kBelowRequests);
  /// @pre board.stop() was called. Waits for the jobs to end.
  ~JobRunner();

 private:
  void run();
  std::optional<JobEnd> run_one(RunningJob& job) const;
  std::optional<JobEnd> end_of(RunningJob& job) const;

  JobBoard& board_;
  std::map<std::string, JobWork> work_;
  std::function<void(const Job&)> after_;
  const int nice_;
  std::vector<std::thread> threads_;
};

/// An end for a job that can never be done: why, as problems.
JobEnd failed(const RunningJob& job, const Errors& errors);

/// The end of a job with its time and progress, still without results.
JobEnd ended(const RunningJob& job, JobState state);

}  // namespace coapt
