#include "server/jobs/running_job.h"

#include "io/json/progress_json.h"

namespace coapt {

void RunningJob::note(const JobProgress& progress) {
  const std::lock_guard<std::mutex> lock(mutex_);
  progress_ = progress;
}

JobProgress RunningJob::progress() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return progress_;
}

void RunningJob::wait_for(const std::string& what) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto now = std::chrono::steady_clock::now();
  if (!waiting_for_.empty()) waited_ += now - waiting_since_;
  waiting_since_ = now;
  waiting_for_ = what;
}

std::string RunningJob::waiting_for() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return waiting_for_;
}

double RunningJob::waited_s() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (waiting_for_.empty()) return waited_.count();
  const std::chrono::duration<double> now = std::chrono::steady_clock::now() - waiting_since_;
  return (waited_ + now).count();
}

double RunningJob::seconds() const {
  const std::chrono::duration<double> now = std::chrono::steady_clock::now() - started_;
  return job.seconds + now.count() - waited_s();
}

Json to_json(const JobProgress& progress, double seconds) {
  Json json = to_json(SearchProgress{progress.closures, progress.closures_planned,
                                     progress.best_leak_mm2, progress.stage, progress.best_cost,
                                     progress.random_cost, progress.leading});
  json["seconds"] = seconds;
  if (progress.rms_mm) json["rms_mm"] = *progress.rms_mm;
  return json;
}

}  // namespace coapt
