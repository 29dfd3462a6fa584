// All jobs: those waiting and running in memory, all of them in the store.
//
// A job is QUEUED, then RUNNING, then SUCCEEDED, FAILED or CANCELLED. Each change is in the store before
// anyone hears of it. A server that stops or dies leaves its jobs QUEUED or RUNNING there; the next one queues
// them again, in the order of submission.
#pragma once

#include <chrono>
#include <condition_variable>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "io/store/job_store.h"
#include "server/jobs/running_job.h"

namespace coapt {

/// A job as clients see it.
struct JobView {
  Job job;
  Json progress;                      ///< of a running job the newest
  std::string waiting_for;            ///< why a running job stands still; empty: it does not
  std::optional<int> queue_position;  ///< jobs before it, of a waiting one
};

struct JobLoad {
  int queued = 0, running = 0;
};

class JobBoard {
 public:
  static constexpr int kMostWaiting = 16;

  /// @param queue jobs that may wait.
  JobBoard(JobStore& store, int queue, const Retention& retention = {})
      : store_(store), queue_limit_(queue), retention_(retention) {}

  /// Queues what the store has unfinished. Before anything else. A job that was running when the server died is blamed for it
  /// (Job::stalled) if it ran alone, or if the server `crashed` by a fault of its own; beside others a kill from outside is nobody's.
  Errors resume(bool crashed = false);

  enum class Taken { New, Known, OtherRequest, QueueFull, Stopping };
  struct Submission {
    Taken taken = Taken::New;
    Job job;  ///< unless the queue is full or the server stops
  };
  /// Known and OtherRequest: the idempotency key was used before, for this very request or for another one.
  Expected<Submission> submit(const NewJob& job, const std::string& valve_document);

  Expected<std::optional<JobView>> find(const std::string& id) const;
  JobView view(Job job) const;

  /// A job that was never started is CANCELLED at once, a running one ends soon, one that goes on later ends then; an
  /// ended one stays as it is. False if there is
  /// no such job.
  Expected<bool> cancel(const std::string& id);

  /// Waits until something may be new of any job, the server stops, or the time is over.
  void wait(std::chrono::milliseconds most) const;
  /// Whether the job has ended, after waiting for it that long at most; not at all if kMostWaiting others wait
  /// already, since each holds a thread that answers requests.
  bool wait_until_ended(const std::string& id, std::chrono::milliseconds most) const;

  /// For those that run jobs: waits for the next one; null when the server stops.
  std::shared_ptr<RunningJob> take();
  /// The job is RUNNING now, with so many closures known. Repeated until the store takes it; false if the server
  /// stops before. `stalled`: see Job.
  bool start(RunningJob& job, std::int64_t kept, int& stalled);
  /// A progress event, if the store takes it.
  void tell_progress(const RunningJob& job);
  /// Ended; without an end, or if the server stops before the store takes it, it is QUEUED again, for the next server.
  /// True if the end is kept.
  bool finish(const std::shared_ptr<RunningJob>& job, const std::optional<JobEnd>& end);
  /// Calls `write` until it has no errors; meanwhile the job says what it waits for. False if the server stops or the
  /// job is cancelled before. Throws (std::runtime_error) what will not pass: no disk, lock or file is its cause.
  bool persist(RunningJob& job, const std::function<Errors()>& write);

  /// No more jobs are taken; running ones are told to end.
  void stop();
  bool stopping() const;
  /// Running jobs are QUEUED again in the store, for a process that ends without waiting for them.
  void suspend_all();
  JobLoad load() const;

 private:
  void suspend(const RunningJob& job);

  JobStore& store_;
  const int queue_limit_;
  const Retention retention_;  // enforced with each new job
  std::mutex intake_;  // over every change of the queue, together with its place in the store
  mutable std::mutex mutex_;  // over what follows; never held while the store works
  mutable std::condition_variable changed_;
  std::deque<std::string> queue_;  // ids
  std::map<std::string, std::shared_ptr<RunningJob>> running_;
  mutable int waiting_ = 0;
  bool stopping_ = false;
};

/// Milliseconds since 1970 by the system's clock, for people to read.
std::int64_t wall_clock_ms();

}  // namespace coapt
