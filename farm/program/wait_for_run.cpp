#include "farm/program/wait_for_run.h"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <iostream>
#include <optional>

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

Json line_of(const Json& progress) {
  Json line;
  for (const char* key : {"done", "items", "workers", "rate_per_s", "eta_s"})
    line[key] = progress[key];
  return line;
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
                      "and " + std::to_string(all - errors.size()) + " more tasks without answer"});
  report_farm_errors(errors, json);
  return kHoles;
}

}  // namespace

int wait_for_run(FarmDatabase& database, std::int64_t run, const Waiting& waiting,
                 const std::atomic<bool>& interrupted) {
  int status = exit_code::kOk;
  const ProgressBar bar;
  std::optional<PatientClock::time_point> last_line;
  for (PatientClock::duration pause = kShortest;;
       pause = std::min<PatientClock::duration>(pause * 3 / 2, kLongest)) {
    const PatientClock::time_point asked = PatientClock::now();
    const auto text = persistently(database, interrupted, waiting.json_progress, status,
                                   [&] { return database.progress(run); });
    if (!text) return status;
    const Json progress = Json::parse(*text);
    const bool ended = progress["state"] != "open";
    if (waiting.json_progress &&
        (ended || !last_line || PatientClock::now() - *last_line > kLine)) {
      std::cerr << line_of(progress).dump() + '\n';
      last_line = PatientClock::now();
    }
    if (!waiting.json_progress && !waiting.quiet)
      bar.show(progress["done"].get<std::int64_t>(), progress["items"].get<std::int64_t>(),
               progress_words(progress));
    if (progress["state"] == "done") return exit_code::kOk;
    if (progress["state"] == "holes") return report_holes(progress, waiting.json_progress);
    if (ended)
      return report_farm_errors(
          {{ErrorCode::InputOutput, "", "run " + std::to_string(run) + " was cancelled"}},
          waiting.json_progress);
    const PatientClock::duration rest = kRestPerAnswer * (PatientClock::now() - asked);
    // A line a second, whatever the pause.
    sleep_unless(std::clamp<PatientClock::duration>(rest, pause, std::chrono::milliseconds(900)),
                 interrupted);
  }
}

int write_answers(FarmDatabase& database, std::int64_t run, bool frames, std::ostream& out,
                  const std::atomic<bool>& interrupted) {
  int status = exit_code::kOk;
  for (std::int64_t next = 0;;) {
    const auto tasks = persistently(database, interrupted, false, status,
                                    [&] { return database.answers(run, next, frames); });
    if (!tasks) return status;
    if (tasks->empty()) return exit_code::kOk;
    for (const AnsweredTask& task : *tasks) {
      if (frames)
        out << task.first << ' ' << task.count << ' ' << task.bytes.size() << '\n';
      else if (task.first != next)
        return report_farm_errors({{ErrorCode::InputOutput, "",
                                    "run " + std::to_string(run) + ": no answer for items from " +
                                        std::to_string(next)}});
      out << task.bytes;
      next = task.first + task.count;
    }
    if (!out.flush()) {
      say("the answers cannot be written");
      return exit_code::kFailure;
    }
  }
}

}  // namespace coapt
