#include "farm/database/worker.h"

#include <algorithm>
#include <chrono>
#include <list>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <thread>
#include <utility>

#include "core/valve/counted.h"

namespace coapt {
namespace {

using Clock = std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;

// Two tasks: the next is there when one is done. More of those that take no time, so that it is not the way to the database that
// takes it.
constexpr int kLeastAtHand = 2, kMostAtHand = 16;
constexpr double kAhead_s = 0.2;
constexpr double kShortestPause_s = 0.05, kLongestPause_s = 2.0;
constexpr double kLongestIdle_s = 0.5;   // between questions for tasks
constexpr double kStopPatience_s = 5.0;  // to hand in, once stopped
constexpr double kStopping_s = 1.0;      // for a computation to heed Work::stop
constexpr double kSlack_s = 0.5;         // for the database's answers at the end
constexpr std::chrono::milliseconds kTick(50);
constexpr std::size_t kKnownRequests = 4;  // as ComputeThread's open works

double seconds_since(Clock::time_point start) { return Seconds(Clock::now() - start).count(); }

class Worker {
 public:
  Worker(FarmDatabase& database, const WorkOpener& open, const WorkerOptions& options,
         const std::atomic<bool>& stop, const std::function<void(const std::string&)>& say)
      : database_(database),
        options_(options),
        stop_(stop),
        say_(say),
        compute_(open, options.threads) {}

  WorkerReport run() {
    const auto joined = ask<std::int64_t>([&] { return database_.join(options_.name); });
    if (joined) {
      id_ = *joined;
      while (!ended()) step();
      finish_up();
    }
    report_.seconds = seconds_since(start_);
    return report_;
  }

 private:
  /// The answer of `call`, tried again while it may pass. None if the worker has to end.
  template <class T, class Call>
  std::optional<T> ask(const Call& call) {
    for (double pause_s = kShortestPause_s;; pause_s = std::min(2.0 * pause_s, kLongestPause_s)) {
      Expected<T> answer = call();
      if (answer) {
        if (!troubled_.empty()) say_("goes on");
        troubled_.clear();
        return *std::move(answer);
      }
      if (!may_pass(answer.errors())) {
        report_.end = WorkerEnd::Refused;
        report_.errors = answer.errors();
        refused_ = true;
        return std::nullopt;
      }
      note_trouble(answer.errors().front().message);
      if (gives_up()) return std::nullopt;
      pause(pause_s);
      if (Errors errors = database_.reopen(); !errors.empty() && !may_pass(errors)) {
        report_.end = WorkerEnd::Refused;
        report_.errors = std::move(errors);
        refused_ = true;
        return std::nullopt;
      }
    }
  }

  bool tell(const std::function<Errors()>& call) {
    return ask<bool>([&]() -> Expected<bool> {
             Errors errors = call();
             if (errors.empty()) return true;
             return errors;
           })
        .has_value();
  }

  void note_trouble(const std::string& message) {
    if (message != troubled_) say_(message + "; retrying");
    troubled_ = message;
  }

  bool gives_up() {
    if (!stop_ && !out_of_time()) return false;
    if (!stopped_at_) stopped_at_ = Clock::now();
    return seconds_since(*stopped_at_) > kStopPatience_s;
  }

  /// Computing goes on.
  void pause(double pause_s) const {
    const Clock::time_point begin = Clock::now();
    while (seconds_since(begin) < pause_s && !(stop_ && !stopped_at_))
      std::this_thread::sleep_for(kTick);
  }

  double left_s() const {
    return options_.seconds > 0.0 ? options_.seconds - seconds_since(start_) : 1e300;
  }
  bool out_of_time() const { return left_s() < options_.grace_s + kStopping_s + kSlack_s; }

  bool ended() {
    if (refused_ || is_dry_) return true;
    if (stop_) report_.end = WorkerEnd::Stopped;
    if (!stop_ && out_of_time()) report_.end = WorkerEnd::TimeLimit;
    return stop_ || out_of_time();
  }

  int wanted() const {
    const int ahead = task_s_ > 0.0 ? static_cast<int>(std::min(kAhead_s / task_s_, 1e3)) : 0;
    return std::clamp(ahead, kLeastAtHand, kMostAtHand) - static_cast<int>(held_.size());
  }

  void step() {
    hand_in(compute_.take(next_tick()));
    if (refused_ || stop_) return;
    if (seconds_since(renewed_) > options_.name.lease_s / 3.0) renew();
    if (!refused_ && wanted() > 0 && Clock::now() >= next_claim_) claim();
  }

  std::chrono::milliseconds next_tick() const {
    if (wanted() <= 0) return kTick;
    const auto until = std::chrono::ceil<std::chrono::milliseconds>(next_claim_ - Clock::now());
    return std::clamp(until, std::chrono::milliseconds(0), kTick);
  }

  void renew() {
    renewed_ = Clock::now();
    if (!held_.empty()) tell([&] { return database_.renew(id_, held_); });
  }

  void claim() {
    // What could not end in time is not begun.
    if (left_s() < options_.grace_s + task_s_ * static_cast<double>(held_.size() + 1)) return;
    const auto tasks =
        ask<std::vector<ClaimedTask>>([&] { return database_.claim(id_, wanted()); });
    if (!tasks) return;
    if (held_.empty()) renewed_ = Clock::now();
    std::vector<TaskKey> not_begun;
    for (const ClaimedTask& task : *tasks) {
      held_.push_back(task.key);
      if (!begin(task)) not_begun.push_back(task.key);
    }
    if (!refused_) give_back(not_begun);
    if (!tasks->empty()) {
      pause_s_ = kShortestPause_s;
      return;
    }
    if (held_.empty() && options_.until_dry && is_dry()) return;
    next_claim_ = Clock::now() + std::chrono::duration_cast<Clock::duration>(Seconds(pause_s_));
    pause_s_ = std::min(1.5 * pause_s_, kLongestIdle_s);
  }

  bool begin(const ClaimedTask& task) {
    const std::string work = work_id(task.kind, task.parts);
    std::shared_ptr<const WorkRequest> request = refused_ ? nullptr : request_of(task, work);
    if (request == nullptr) return false;
    compute_.give({task.key, task.count, work, std::move(request)});
    return true;
  }

  /// Null if it cannot be read: the lease has run out meanwhile, or the worker has to end.
  std::shared_ptr<const WorkRequest> request_of(const ClaimedTask& task, const std::string& work) {
    for (const auto& [known, request] : requests_)
      if (known == work) return request;
    auto request = std::make_shared<WorkRequest>(WorkRequest{task.kind, {}});
    for (const std::string& name : task.parts) {
      auto part = ask<std::optional<std::string>>([&] { return part_of(task, name); });
      if (!part || !*part) return nullptr;
      request->parts.push_back(**std::move(part));
    }
    if (work_id(*request) != work) {
      const std::string why = "the parts of the request are not those that it names";
      say_("run " + std::to_string(task.key.run) + ": " + why);
      tell([&] { return database_.fail(id_, task.key, why); });
      return nullptr;
    }
    requests_.emplace_front(work, request);
    if (requests_.size() > kKnownRequests) requests_.pop_back();
    return request;
  }

  Expected<std::optional<std::string>> part_of(const ClaimedTask& task, const std::string& name) {
    Expected<std::string> part = database_.read_part(id_, task.key.run, name);
    if (part) return std::optional<std::string>(*std::move(part));
    if (part.errors().front().code == ErrorCode::OutOfRange) return std::optional<std::string>();
    return part.errors();
  }

  bool is_dry() {
    const auto text = ask<std::string>([&] { return database_.waiting(id_); });
    if (!text) return false;
    const auto waiting = nlohmann::ordered_json::parse(*text);
    if (waiting["mine"] != 0) return false;
    for (const auto& other : waiting["others"])
      say_(counted(other["runs"].get<int>(), "run waits", "runs wait") +
           " for workers of revision " + other["revision"].get<std::string>() +
           "; this worker has " + options_.name.revision);
    is_dry_ = true;
    report_.end = WorkerEnd::Dry;
    return true;
  }

  void hand_in(const std::vector<ComputedTask>& tasks) {
    for (const ComputedTask& task : tasks) {
      if (refused_) return;
      if (task.stopped) continue;  // still held: it is given back
      if (task.error.empty()) {
        const auto verdict = ask<std::string>(
            [&] { return database_.finish(id_, task.key, task.work, task.seconds, task.bytes); });
        if (!verdict) return;
        if (*verdict == "unclaimed" || *verdict == "unknown")
          say_("items from " + std::to_string(task.key.first) + " of run " +
               std::to_string(task.key.run) + " are no longer assigned to this worker");
        if (*verdict == "differs")
          say_("another worker returned different results for items from " +
               std::to_string(task.key.first) + " of run " + std::to_string(task.key.run));
        ++report_.tasks;
        report_.items += task.count;
      } else {
        say_("run " + std::to_string(task.key.run) + ", items from " +
             std::to_string(task.key.first) + ": " + task.error);
        if (!tell([&] { return database_.fail(id_, task.key, task.error); })) return;
      }
      report_.computing_s += task.seconds;
      task_s_ = task_s_ > 0.0 ? 0.8 * task_s_ + 0.2 * task.seconds : std::max(task.seconds, 1e-6);
      drop(task.key);
    }
  }

  void drop(TaskKey key) {
    std::erase_if(
        held_, [&](const TaskKey& held) { return held.run == key.run && held.first == key.first; });
  }

  void give_back(std::vector<TaskKey> tasks) {
    if (tasks.empty() || !tell([&] { return database_.give_back(id_, tasks); })) return;
    for (const TaskKey& task : tasks) drop(task);
  }

  /// The task in progress may end within the grace; what has not begun goes back at once.
  void finish_up() {
    std::size_t in_progress = held_.size();
    const std::vector<TaskKey> idle = compute_.take_back();
    if (!refused_) give_back(idle);
    in_progress -= std::min(in_progress, idle.size());
    const auto await = [&](double patience_s) {
      const Clock::time_point begin = Clock::now();
      while (in_progress > 0 && seconds_since(begin) < patience_s) {
        const std::vector<ComputedTask> computed = compute_.take(kTick);
        hand_in(computed);
        in_progress -= std::min(in_progress, computed.size());
      }
    };
    if (!refused_) await(options_.grace_s);
    compute_.stop();
    await(kStopping_s);
    if (!refused_ && !held_.empty()) give_back(held_);
    if (!refused_) tell([&] { return database_.leave(id_); });
    report_.let_go = in_progress > 0;
    if (report_.let_go) compute_.let_go();
  }

  FarmDatabase& database_;
  const WorkerOptions& options_;
  const std::atomic<bool>& stop_;
  const std::function<void(const std::string&)>& say_;
  ComputeThread compute_;
  const Clock::time_point start_ = Clock::now();

  std::int64_t id_ = 0;
  std::vector<TaskKey> held_;  ///< claimed and not handed in
  std::list<std::pair<std::string, std::shared_ptr<const WorkRequest>>>
      requests_;         ///< by work_id()
  double task_s_ = 0.0;  ///< of late
  double pause_s_ = kShortestPause_s;
  Clock::time_point next_claim_ = Clock::now(), renewed_ = Clock::now();
  std::optional<Clock::time_point> stopped_at_;
  std::string troubled_;
  bool refused_ = false, is_dry_ = false;
  WorkerReport report_;
};

}  // namespace

WorkerReport run_worker(FarmDatabase& database, const WorkOpener& open,
                        const WorkerOptions& options, const std::atomic<bool>& stop,
                        const std::function<void(const std::string&)>& say) {
  return Worker(database, open, options, stop, say).run();
}

}  // namespace coapt
