// A job that is being run: what its work, its clients and the clock say of it while it runs.
#pragma once

#include <atomic>
#include <chrono>
#include <limits>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "io/json/json.h"
#include "io/store/job_store.h"
#include "search/plans/search_progress.h"

namespace coapt {

struct JobProgress {
  std::string stage = "starting";
  int closures = 0, closures_planned = 0;                          ///< of a study: of its stage
  double best_leak_mm2 = std::numeric_limits<double>::infinity();  ///< of plans as planned
  /// Of a search: see SearchProgress.
  double best_cost = std::numeric_limits<double>::infinity();
  double random_cost = std::numeric_limits<double>::infinity();
  std::shared_ptr<const LeadingPlan> leading = {};
  std::optional<double> rms_mm = {};  ///< of a fit: distances left
};

class RunningJob {
 public:
  explicit RunningJob(Job running) : job(std::move(running)) {}

  const Job job;                           ///< as it was when it began to run
  std::atomic<bool> cancelled = false;     ///< its work is to end as soon as it can
  std::atomic<bool> cancel_asked = false;  ///< by a client; else the server stops

  void note(const JobProgress& progress);
  JobProgress progress() const;
  /// Why it stands still, in words; empty: it does not.
  void wait_for(const std::string& what);
  std::string waiting_for() const;
  /// That it stood still, in this attempt.
  double waited_s() const;
  /// Of running, over all attempts, without standing still.
  double seconds() const;

 private:
  std::chrono::steady_clock::time_point started_ = std::chrono::steady_clock::now();
  mutable std::mutex mutex_;
  JobProgress progress_;
  std::string waiting_for_;
  std::chrono::steady_clock::time_point waiting_since_;
  std::chrono::duration<double> waited_{0.0};  // but for now
};

/// That of a search (io/json/progress_json.h), "seconds" and "rms_mm" (of a fit).
Json to_json(const JobProgress& progress, double seconds);

}  // namespace coapt
