#include "server/jobs/job_board.h"

#include <algorithm>
#include <stdexcept>

#include "server/answers.h"

namespace coapt {
namespace {

using std::chrono::milliseconds;

constexpr int kSuspendTries = 2;
constexpr milliseconds kRetry(1000);  // between tries to write

/// Whether the same call may succeed later.
bool may_pass(ErrorCode code) {
  return code == ErrorCode::Busy || code == ErrorCode::NoSpace || code == ErrorCode::InputOutput;
}

bool is_same(const Job& known, const NewJob& asked) {
  return known.kind == asked.kind && known.valve == asked.valve && known.request == asked.request;
}

}  // namespace

std::int64_t wall_clock_ms() {
  return std::chrono::duration_cast<milliseconds>(
             std::chrono::system_clock::now().time_since_epoch())
      .count();
}

Errors JobBoard::resume(bool crashed) {
  const Expected<std::vector<Job>> unfinished = store_.unfinished();
  if (!unfinished) return unfinished.errors();
  const auto was_running = [](const Job& job) { return job.state == JobState::Running; };
  const auto killed = std::count_if(unfinished->begin(), unfinished->end(), was_running);
  if (killed > 1 && !crashed)
    for (const Job& job : *unfinished)
      if (was_running(job))
        if (Errors errors = store_.suspend(job.id, job.seconds, ""); !errors.empty()) return errors;
  const std::lock_guard<std::mutex> lock(mutex_);
  for (const Job& job : *unfinished) queue_.push_back(job.id);
  return {};
}

Expected<JobBoard::Submission> JobBoard::submit(const NewJob& asked,
                                                const std::string& valve_document) {
  const std::lock_guard<std::mutex> intake(intake_);
  if (!asked.idempotency_key.empty()) {
    const Expected<std::optional<Job>> known = store_.job_of_key(asked.idempotency_key);
    if (!known) return known.errors();
    if (*known)
      return Submission{is_same(**known, asked) ? Taken::Known : Taken::OtherRequest, **known};
  }
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (stopping_) return Submission{Taken::Stopping, {}};
    if (std::ssize(queue_) >= queue_limit_) return Submission{Taken::QueueFull, {}};
  }
  const auto submitted = store_.submit(asked, valve_document, wall_clock_ms());
  if (!submitted) return submitted.errors();
  static_cast<void>(store_.retain(retention_, wall_clock_ms()));  // else with the next job
  const Job& job = submitted->job;
  const std::lock_guard<std::mutex> lock(mutex_);
  queue_.push_back(job.id);
  changed_.notify_all();
  return Submission{Taken::New, job};
}

JobView JobBoard::view(Job job) const {
  JobView view{std::move(job), nullptr, "", {}};
  const std::lock_guard<std::mutex> lock(mutex_);
  if (const auto found = running_.find(view.job.id); found != running_.end()) {
    if (!has_ended(view.job.state)) {
      const RunningJob& running = *found->second;
      view.progress = to_json(running.progress(), running.seconds());
      view.waiting_for = running.waiting_for();
    }
  }
  for (std::size_t i = 0; i < queue_.size(); ++i)
    if (queue_[i] == view.job.id) {
      view.queue_position = static_cast<int>(i);
      view.job.state =
          JobState::Queued;  // a killed one is RUNNING in the store until it runs again
    }
  if (view.progress.is_null() && !view.job.progress.empty())
    view.progress = Json::parse(view.job.progress);
  return view;
}

Expected<std::optional<JobView>> JobBoard::find(const std::string& id) const {
  Expected<std::optional<Job>> job = store_.job(id);
  if (!job) return job.errors();
  if (!*job) return std::optional<JobView>();
  return std::optional<JobView>(view(**std::move(job)));
}

Expected<bool> JobBoard::cancel(const std::string& id) {
  const std::lock_guard<std::mutex> intake(intake_);
  const Expected<std::optional<Job>> job = store_.job(id);
  if (!job) return job.errors();
  if (!*job) return false;
  if (has_ended((*job)->state)) return true;
  std::shared_ptr<RunningJob> running;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (const auto found = running_.find(id); found != running_.end()) running = found->second;
  }
  if (running || (*job)->started_ms > 0) {
    if (Errors errors = store_.request_cancel(id); !errors.empty()) return errors;
    if (!running) return true;  // its best so far is found when it is run again
    running->cancel_asked = true;
    running->cancelled = true;
    const std::lock_guard<std::mutex> lock(mutex_);
    changed_.notify_all();
    return true;
  }
  const JobEnd end{JobState::Cancelled, (*job)->seconds, (*job)->progress, "", "", {}};
  if (Errors errors = store_.finish(id, end, wall_clock_ms()); !errors.empty()) return errors;
  const std::lock_guard<std::mutex> lock(mutex_);
  std::erase(queue_, id);
  changed_.notify_all();
  return true;
}

void JobBoard::wait(milliseconds most) const {
  std::unique_lock<std::mutex> lock(mutex_);
  if (!stopping_) changed_.wait_for(lock, most);
}

bool JobBoard::wait_until_ended(const std::string& id, milliseconds most) const {
  const auto ended = [&] {
    return !running_.contains(id) && std::find(queue_.begin(), queue_.end(), id) == queue_.end();
  };
  std::unique_lock<std::mutex> lock(mutex_);
  if (waiting_ >= kMostWaiting) return ended();
  ++waiting_;
  changed_.wait_for(lock, most, [&] { return stopping_ || ended(); });
  --waiting_;
  return ended();
}

std::shared_ptr<RunningJob> JobBoard::take() {
  for (;;) {
    {
      std::unique_lock<std::mutex> lock(mutex_);
      changed_.wait(lock, [&] { return stopping_ || !queue_.empty(); });
      if (stopping_) return nullptr;
    }
    Expected<std::optional<Job>> job = std::optional<Job>();
    {
      const std::lock_guard<std::mutex> intake(intake_);
      std::string id;
      {
        const std::lock_guard<std::mutex> lock(mutex_);
        if (queue_.empty()) continue;
        id = queue_.front();
      }
      job = store_.job(id);
      const std::lock_guard<std::mutex> lock(mutex_);
      if (job) queue_.pop_front();
      if (job && *job && !stopping_) {
        const auto running = std::make_shared<RunningJob>(**std::move(job));
        running_.emplace(id, running);
        return running;
      }
    }
    // It stays where it is, until the store can be read.
    std::unique_lock<std::mutex> lock(mutex_);
    if (!job) changed_.wait_for(lock, kRetry, [this] { return stopping_; });
  }
}

bool JobBoard::persist(RunningJob& job, const std::function<Errors()>& write) {
  for (;;) {
    const Errors errors = write();
    job.wait_for(errors.empty() ? "" : without_folders(errors.front().message));
    if (errors.empty()) return true;
    if (!may_pass(errors.front().code))
      throw std::runtime_error(without_folders(errors.front().message));
    std::unique_lock<std::mutex> lock(mutex_);
    if (changed_.wait_for(lock, kRetry, [&] { return stopping_ || job.cancel_asked; }))
      return false;
  }
}

bool JobBoard::start(RunningJob& job, std::int64_t kept, int& stalled) {
  const bool started = persist(job, [&]() -> Errors {
    const Expected<int> attempts = store_.start(job.job.id, kept, wall_clock_ms());
    if (!attempts) return attempts.errors();
    stalled = *attempts;
    return {};
  });
  const std::lock_guard<std::mutex> lock(mutex_);
  changed_.notify_all();
  return started;
}

void JobBoard::tell_progress(const RunningJob& job) {
  const std::string progress = to_json(job.progress(), job.seconds()).dump();
  static_cast<void>(store_.add_event(job.job.id, "progress", progress, job.seconds()));
  const std::lock_guard<std::mutex> lock(mutex_);
  changed_.notify_all();
}

bool JobBoard::finish(const std::shared_ptr<RunningJob>& job, const std::optional<JobEnd>& end) {
  const std::string& id = job->job.id;
  bool is_kept = false;
  for (bool over = !end; !over;) {
    const Errors errors = store_.finish(id, *end, wall_clock_ms());
    job->wait_for(errors.empty() ? "" : without_folders(errors.front().message));
    is_kept = errors.empty();
    std::unique_lock<std::mutex> lock(mutex_);
    over = is_kept || !may_pass(errors.front().code) ||
           changed_.wait_for(lock, kRetry, [&] { return stopping_; });
  }
  if (!is_kept) suspend(*job);
  const std::lock_guard<std::mutex> lock(mutex_);
  running_.erase(id);
  changed_.notify_all();
  return is_kept;
}

void JobBoard::suspend(const RunningJob& job) {
  const std::string progress = to_json(job.progress(), job.seconds()).dump();
  for (int i = 0; i < kSuspendTries; ++i)
    if (store_.suspend(job.job.id, job.seconds(), progress).empty()) return;
}

void JobBoard::suspend_all() {
  std::vector<std::shared_ptr<RunningJob>> jobs;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    for (const auto& [id, job] : running_) jobs.push_back(job);
  }
  for (const auto& job : jobs) suspend(*job);
}

void JobBoard::stop() {
  const std::lock_guard<std::mutex> lock(mutex_);
  stopping_ = true;
  for (const auto& [id, job] : running_) job->cancelled = true;
  changed_.notify_all();
}

bool JobBoard::stopping() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return stopping_;
}

JobLoad JobBoard::load() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return {static_cast<int>(queue_.size()), static_cast<int>(running_.size())};
}

}  // namespace coapt
