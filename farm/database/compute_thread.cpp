#include "farm/database/compute_thread.h"

#include <atomic>
#include <condition_variable>
#include <deque>
#include <exception>
#include <list>
#include <mutex>
#include <thread>
#include <utility>

namespace coapt {
namespace {

// Some works are taken in turn (several coordinators); an open work may hold hundreds of megabytes.
constexpr std::size_t kOpenWorks = 4;

using Clock = std::chrono::steady_clock;

std::string text_of(const Errors& errors) {
  std::string text;
  for (const Error& error : errors)
    text +=
        (text.empty() ? "" : "; ") + (error.path.empty() ? "" : error.path + ": ") + error.message;
  return text;
}

}  // namespace

struct ComputeThread::State {
  struct OpenWork {
    std::string id;
    Expected<Work> work;
  };

  WorkOpener open;
  int threads = 1;
  std::list<OpenWork> works;  ///< of the thread alone; the one used last in front

  std::mutex mutex;
  std::condition_variable given, taken;
  std::deque<ComputeJob> jobs;
  std::vector<ComputedTask> computed;
  bool ends = false, stops = false;
  std::shared_ptr<std::atomic<bool>> stop;  ///< of the work in progress
  std::thread thread;

  const Expected<Work>& work_of(const ComputeJob& job) {
    for (auto known = works.begin(); known != works.end(); ++known)
      if (known->id == job.work) {
        works.splice(works.begin(), works, known);
        return works.front().work;
      }
    works.push_front({job.work, open(*job.request)});
    if (works.size() > kOpenWorks) works.pop_back();
    return works.front().work;
  }

  void let_stop(const std::shared_ptr<std::atomic<bool>>& flag) {
    const std::lock_guard<std::mutex> lock(mutex);
    stop = flag;
    if (stops) *stop = true;
  }

  ComputedTask compute(const ComputeJob& job) {
    ComputedTask task{.key = job.key, .count = job.count, .work = job.work};
    const Clock::time_point start = Clock::now();
    try {
      const Expected<Work>& work = work_of(job);
      if (work) {
        let_stop(work->stop);
        task.bytes = work->compute(job.key.first, job.count, threads);
      } else {
        task.error = "the request: " + text_of(work.errors());
      }
    } catch (const WorkStopped&) {
      task.stopped = true;
    } catch (const std::exception& error) {
      task.error = std::string("computing: ") + error.what();
    }
    task.seconds = std::chrono::duration<double>(Clock::now() - start).count();
    return task;
  }

  void loop() {
    std::unique_lock<std::mutex> lock(mutex);
    for (;;) {
      given.wait(lock, [this] { return ends || !jobs.empty(); });
      if (ends) return;
      const ComputeJob job = std::move(jobs.front());
      jobs.pop_front();
      lock.unlock();
      ComputedTask task = compute(job);
      lock.lock();
      computed.push_back(std::move(task));
      taken.notify_all();
    }
  }
};

ComputeThread::ComputeThread(WorkOpener open, int threads) : state_(std::make_shared<State>()) {
  state_->open = std::move(open);
  state_->threads = threads;
  // Holds the state, too: it may outlive this object.
  state_->thread = std::thread([state = state_] { state->loop(); });
}

ComputeThread::~ComputeThread() {
  if (let_go_) return;
  take_back();
  stop();
  {
    const std::lock_guard<std::mutex> lock(state_->mutex);
    state_->ends = true;
  }
  state_->given.notify_all();
  state_->thread.join();
}

void ComputeThread::give(ComputeJob job) {
  {
    const std::lock_guard<std::mutex> lock(state_->mutex);
    state_->jobs.push_back(std::move(job));
  }
  state_->given.notify_all();
}

std::vector<ComputedTask> ComputeThread::take(std::chrono::milliseconds patience) {
  std::unique_lock<std::mutex> lock(state_->mutex);
  state_->taken.wait_for(lock, patience, [this] { return !state_->computed.empty(); });
  return std::exchange(state_->computed, {});
}

std::vector<TaskKey> ComputeThread::take_back() {
  const std::lock_guard<std::mutex> lock(state_->mutex);
  std::vector<TaskKey> keys;
  for (const ComputeJob& job : state_->jobs) keys.push_back(job.key);
  state_->jobs.clear();
  return keys;
}

void ComputeThread::stop() {
  const std::lock_guard<std::mutex> lock(state_->mutex);
  state_->stops = true;
  if (state_->stop) *state_->stop = true;
}

void ComputeThread::let_go() {
  let_go_ = true;
  state_->thread.detach();
}

}  // namespace coapt
