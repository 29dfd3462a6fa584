// Calls of the database that wait out its trouble: a restart, a full disk, a network that breaks.
#pragma once

#include <algorithm>
#include <atomic>
#include <chrono>
#include <optional>
#include <string>
#include <thread>
#include <type_traits>
#include <utility>

#include "farm/database/farm_database.h"
#include "farm/program/farm_option.h"
#include "io/command_line/exit_code.h"

namespace coapt {

using PatientClock = std::chrono::steady_clock;

/// Ends early if interrupted.
inline void sleep_unless(PatientClock::duration time, const std::atomic<bool>& interrupted) {
  const PatientClock::time_point end = PatientClock::now() + time;
  while (!interrupted && PatientClock::now() < end)
    std::this_thread::sleep_for(
        std::min<PatientClock::duration>(end - PatientClock::now(), std::chrono::milliseconds(50)));
}

/// A farm that does not answer so often when it is first asked, a second apart, is not waited for.
inline constexpr int kFirstAttempts = 6;

/// Opens a farm; retrying while it may pass: a study asks anew for each batch, and does not end because the database restarts.
inline Expected<FarmDatabase> open_patiently(const std::string& url,
                                             const std::atomic<bool>& interrupted) {
  for (int attempt = 1;; ++attempt) {
    Expected<FarmDatabase> database = FarmDatabase::open(url);
    if (database || !may_pass(database.errors()) || interrupted || attempt == kFirstAttempts)
      return database;
    sleep_unless(std::chrono::seconds(1), interrupted);
  }
}

/// The answer, tried again while it may pass; none if interrupted, or refused (told, `status` is set).
template <class Call>
auto persistently(FarmDatabase& database, const std::atomic<bool>& interrupted, bool json,
                  int& status, const Call& call) -> std::optional<std::decay_t<decltype(*call())>> {
  std::string told;
  for (PatientClock::duration pause = std::chrono::milliseconds(20); !interrupted;
       pause = std::min<PatientClock::duration>(2 * pause, std::chrono::seconds(2))) {
    auto answer = call();
    if (answer) return *std::move(answer);
    Errors errors = answer.errors();
    if (may_pass(errors)) {
      if (told != errors.front().message && !json) say(errors.front().message + "; retrying");
      told = errors.front().message;
      sleep_unless(pause, interrupted);
      errors = database.reopen();
      if (errors.empty() || may_pass(errors)) continue;
    }
    status = report_farm_errors(errors, json);
    return std::nullopt;
  }
  status = exit_code::kInterrupted;
  return std::nullopt;
}

}  // namespace coapt
