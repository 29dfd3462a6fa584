#include "server/jobs/job_runner.h"

#include <sys/resource.h>

#include <algorithm>
#include <exception>
#include <system_error>

#include "io/json/result_json.h"

namespace coapt {
namespace {

// Progress events: four a second at first, some 400 for each factor of e in time later.
constexpr double kShortest_s = 0.25, kShareOfTime = 1.0 / 400.0;

/// Tells progress from time to time as long as it lives.
class Reporter {
 public:
  Reporter(JobBoard& board, const RunningJob& job)
      : thread_([this, &board, &job] { run(board, job); }) {}
  ~Reporter() {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      over_ = true;
    }
    changed_.notify_all();
    thread_.join();
  }

 private:
  void run(JobBoard& board, const RunningJob& job) {
    int told = 0;
    for (;;) {
      const std::chrono::duration<double> pause(
          std::max(kShortest_s, kShareOfTime * job.seconds()));
      {
        std::unique_lock<std::mutex> lock(mutex_);
        if (changed_.wait_for(lock, pause, [this] { return over_; })) return;
      }
      const int closures = job.progress().closures;
      if (closures == told) continue;
      told = closures;
      board.tell_progress(job);
    }
  }

  std::mutex mutex_;
  std::condition_variable changed_;
  bool over_ = false;
  std::thread thread_;
};

}  // namespace

JobEnd ended(const RunningJob& job, JobState state) {
  JobEnd end;
  end.state = state;
  end.seconds = job.seconds();
  end.progress = to_json(job.progress(), job.seconds()).dump();
  return end;
}

JobEnd failed(const RunningJob& job, const Errors& errors) {
  JobEnd end = ended(job, JobState::Failed);
  end.summary = Json{{"problems", to_json(errors)}}.dump();
  return end;
}

JobRunner::JobRunner(JobBoard& board, std::map<std::string, JobWork> work, int threads,
                     std::function<void(const Job&)> after, int nice)
    : board_(board), work_(std::move(work)), after_(std::move(after)), nice_(nice) {
  for (int i = 0; i < threads; ++i) threads_.emplace_back([this] { run(); });
}

JobRunner::~JobRunner() {
  for (std::thread& thread : threads_) thread.join();
}

void JobRunner::run() {
  // On Linux of this thread alone, and of those that it starts. Without it jobs are only less polite.
  static_cast<void>(setpriority(PRIO_PROCESS, 0, nice_));
  while (const std::shared_ptr<RunningJob> job = board_.take())
    if (board_.finish(job, run_one(*job)) && after_ && !board_.stopping()) after_(job->job);
}

std::optional<JobEnd> JobRunner::run_one(RunningJob& job) const {
  try {
    const Reporter reporter(board_, job);
    return end_of(job);
  } catch (const std::system_error&) {  // no thread can be had for the reporter
    return end_of(job);
  }
}

std::optional<JobEnd> JobRunner::end_of(RunningJob& job) const {
  const auto work = work_.find(job.job.kind);
  if (work == work_.end())
    return failed(
        job, {Error{ErrorCode::Unsupported, "", "this server does not support this kind of job"}});
  try {
    return work->second(job);
  } catch (const std::exception& error) {
    if (job.cancel_asked) return ended(job, JobState::Cancelled);
    if (board_.stopping()) return std::nullopt;
    return failed(job, {Error{ErrorCode::InputOutput, "", error.what()}});
  }
}

}  // namespace coapt
