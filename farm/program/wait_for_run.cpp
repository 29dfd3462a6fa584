#include "farm/program/wait_for_run.h"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <iostream>
#include <optional>
#include <random>
#include <thread>
#include <vector>

#include "farm/program/farm_option.h"
#include "farm/program/persistence.h"
#include "farm/program/status_text.h"
#include "io/command_line/exit_code.h"
#include "io/command_line/progress_bar.h"
#include "io/json/json.h"

namespace coapt {
namespace {

constexpr std::chrono::milliseconds kShortest(20), kLongest(500), kLine(1000);
// The question costs the database the more, the more tasks are left: it has other things to do.
constexpr int kRestPerAnswer = 20;
constexpr int kRounds = 4;  // of answers that turn out wrong: then somebody must look

Json line_of(const Json& progress) {
  Json line;
  for (const char* key : {"done", "items", "workers", "rate_per_s", "eta_s"})
    line[key] = progress[key];
  return line;
}

/// Some of the tasks offered, each set of them as likely as any other, and known to nobody before (Vitter 1985, algorithm R).
class Drawing {
 public:
  explicit Drawing(int wanted) : wanted_(static_cast<std::size_t>(wanted)) {}

  void offer(const AnsweredTask& task) {
    ++offered_;
    if (drawn_.size() < wanted_) {
      drawn_.push_back(task);
    } else if (wanted_ > 0) {
      const std::size_t place =
          std::uniform_int_distribution<std::size_t>(0, offered_ - 1)(chance_);
      if (place < wanted_) drawn_[place] = task;
    }
  }
  const std::vector<AnsweredTask>& drawn() const { return drawn_; }

 private:
  std::random_device chance_;
  std::size_t wanted_, offered_ = 0;
  std::vector<AnsweredTask> drawn_;
};

struct Wrong {
  std::int64_t first = 0;
  std::string why;
};

/// What cannot even be looked at is doubtful.
bool is_doubtful(const Work& work, const AnsweredTask& task) {
  try {
    return work.doubt && work.doubt(task.first, task.count, task.bytes);
  } catch (const std::exception&) {
    return true;
  }
}

int usable_threads() { return static_cast<int>(std::max(1u, std::thread::hardware_concurrency())); }

/// In order; all of them unless `with_holes`. `take` returns whether to go on. Returns an exit code; kFailure also after a false.
template <class Take>
int for_each_answer(FarmDatabase& database, const AskedRun& asked, bool with_holes, bool json,
                    const std::atomic<bool>& interrupted, const Take& take) {
  int status = exit_code::kOk;
  const std::string run = "run " + std::to_string(asked.run);
  for (std::int64_t next = 0;;) {
    const auto tasks = persistently(database, interrupted, json, status,
                                    [&] { return database.answers(asked.run, next, with_holes); });
    if (!tasks) return status;
    if (tasks->empty()) return exit_code::kOk;
    for (const AnsweredTask& task : *tasks) {
      if (task.work != asked.work)
        return report_farm_errors(
            {{ErrorCode::InputOutput, "", run + " belongs to another request"}}, json);
      if (!with_holes && task.first != next)
        return report_farm_errors({{ErrorCode::InputOutput, "",
                                    run + ": no result for items from " + std::to_string(next)}},
                                  json);
      if (!take(task)) return exit_code::kFailure;
      next = task.first + task.count;
    }
  }
}

int report_holes(const Json& progress, bool json) {
  Errors errors;
  for (const Json& hole : progress["poison"])
    errors.push_back({ErrorCode::ImpossibleStep, "",
                      "items from " + std::to_string(hole["first"].get<std::int64_t>()) + " (" +
                          std::to_string(hole["items"].get<int>()) +
                          "): " + hole["error"].get<std::string>()});
  const auto all = progress["tasks_poison"].get<std::size_t>();
  if (all > errors.size())
    errors.push_back({ErrorCode::ImpossibleStep, "",
                      "and " + std::to_string(all - errors.size()) + " more tasks without result"});
  report_farm_errors(errors, json);
  return kHoles;
}

/// Computes a task that workers differ on, if that is for this side to do. Returns an exit code.
int settle(FarmDatabase& database, const AskedRun& asked, bool json,
           const std::atomic<bool>& interrupted) {
  if (asked.check == nullptr || asked.sampled == 0) return exit_code::kOk;
  int status = exit_code::kOk;
  const auto task = persistently(database, interrupted, json, status,
                                 [&] { return database.disputed(asked.run); });
  if (!task || !*task) return status;
  std::string bytes;
  try {
    bytes = asked.check->compute((*task)->first, (*task)->count, usable_threads());
  } catch (const std::exception&) {
    return exit_code::kOk;  // then a third worker has to
  }
  persistently(database, interrupted, json, status, [&]() -> Expected<bool> {
    Errors errors = database.judge(asked.run, (*task)->first, bytes);
    if (errors.empty()) return true;
    return errors;
  });
  return status;
}

int wait_for_run(FarmDatabase& database, const AskedRun& asked, const Waiting& waiting,
                 const std::atomic<bool>& interrupted) {
  int status = exit_code::kOk;
  const ProgressBar bar;
  std::optional<PatientClock::time_point> last_line;
  for (PatientClock::duration pause = kShortest;;
       pause = std::min<PatientClock::duration>(pause * 3 / 2, kLongest)) {
    const PatientClock::time_point begin = PatientClock::now();
    const auto text = persistently(database, interrupted, waiting.json_progress, status,
                                   [&] { return database.progress(asked.run); });
    if (!text) return status;
    const Json progress = Json::parse(*text);
    const bool ended = progress["state"] != "open";
    if (waiting.json_progress &&
        (ended || !last_line || PatientClock::now() - *last_line > kLine)) {
      std::cerr << json_text(line_of(progress)) + '\n';
      last_line = PatientClock::now();
    }
    if (!waiting.json_progress && !waiting.quiet)
      bar.show(progress["done"].get<std::int64_t>(), progress["items"].get<std::int64_t>(),
               progress_words(progress));
    if (progress["state"] == "done") return exit_code::kOk;
    if (progress["state"] == "holes") return report_holes(progress, waiting.json_progress);
    if (ended)
      return report_farm_errors(
          {{ErrorCode::InputOutput, "", "run " + std::to_string(asked.run) + " was cancelled"}},
          waiting.json_progress);
    if (progress["tasks_disputed"] != 0)
      if (const int failed = settle(database, asked, waiting.json_progress, interrupted))
        return failed;
    const PatientClock::duration rest = kRestPerAnswer * (PatientClock::now() - begin);
    // A line a second, whatever the pause.
    sleep_unless(std::clamp<PatientClock::duration>(rest, pause, std::chrono::milliseconds(900)),
                 interrupted);
  }
}

}  // namespace

int check_answers(FarmDatabase& database, const AskedRun& asked, bool json_errors,
                  const std::atomic<bool>& interrupted) {
  if (asked.check == nullptr) return exit_code::kOk;
  Drawing drawing(asked.sampled);
  std::vector<AnsweredTask> recomputed;  // doubtful ones first
  std::optional<Wrong> wrong;
  int status = for_each_answer(
      database, asked, true, json_errors, interrupted, [&](const AnsweredTask& task) {
        const std::string objection =
            asked.check->objection ? asked.check->objection(task.first, task.count, task.bytes)
                                   : "";
        if (!objection.empty())
          wrong = {task.first, objection};
        else if (is_doubtful(*asked.check, task))
          recomputed.push_back(task);
        else
          drawing.offer(task);
        return !wrong && !interrupted;
      });
  if (interrupted) return exit_code::kInterrupted;
  if (status != exit_code::kOk && !wrong) return status;
  recomputed.insert(recomputed.end(), drawing.drawn().begin(), drawing.drawn().end());
  for (std::size_t i = 0; !wrong && !interrupted && i < recomputed.size(); ++i) {
    const AnsweredTask& task = recomputed[i];
    try {
      if (asked.check->compute(task.first, task.count, usable_threads()) != task.bytes)
        wrong = {task.first, "recomputed here, they differ"};
    } catch (const std::exception& error) {
      wrong = {task.first, std::string("they could not be recomputed here: ") + error.what()};
    }
  }
  if (interrupted) return exit_code::kInterrupted;
  if (!wrong) return exit_code::kOk;
  const auto whose = persistently(database, interrupted, json_errors, status, [&] {
    return database.doubt(asked.run, wrong->first, wrong->why);
  });
  if (!whose) return status;
  return report_farm_errors(
      {{ErrorCode::Unsupported, "",
        "run " + std::to_string(asked.run) + ": the results for items from " +
            std::to_string(wrong->first) + " are wrong (" + wrong->why + "); they came from " +
            *whose + ", whose items are assigned to other workers"}},
      json_errors);
}

int wait_and_check(FarmDatabase& database, const AskedRun& asked, const Waiting& waiting,
                   const std::atomic<bool>& interrupted) {
  for (int round = 1;; ++round) {
    const int ended = wait_for_run(database, asked, waiting, interrupted);
    if (ended != exit_code::kOk && ended != kHoles) return ended;
    const int checked = check_answers(database, asked, waiting.json_progress, interrupted);
    if (checked == exit_code::kOk) return ended;
    if (checked != exit_code::kFailure || round == kRounds) return checked;
  }
}

int write_answers(FarmDatabase& database, const AskedRun& asked, bool frames, std::ostream& out,
                  const std::atomic<bool>& interrupted) {
  return for_each_answer(
      database, asked, frames, false, interrupted, [&](const AnsweredTask& task) {
        if (frames) out << task.first << ' ' << task.count << ' ' << task.bytes.size() << '\n';
        out << task.bytes;
        if (out.flush()) return true;
        say("the results cannot be written");
        return false;
      });
}

}  // namespace coapt
