// What the kinds of jobs have in common: a valve from the store, closures kept one by one.
#pragma once

#include <functional>
#include <optional>
#include <stdexcept>
#include <string>

#include "core/valve/valve.h"
#include "server/jobs/job_runner.h"

namespace coapt {

inline constexpr const char* kJobStops = "the job stops";

/// What `read` answers, however long it cannot: a file that is locked, a disk that is full. Throws if the server stops,
/// the job is cancelled, or it never will.
template <class T, class Read>
T retried(JobBoard& board, RunningJob& job, const Read& read) {
  std::optional<T> value;
  const bool is_there = board.persist(job, [&]() -> Errors {
    Expected<T> answer = read();
    if (!answer) return answer.errors();
    value = *std::move(answer);
    return {};
  });
  if (!is_there) throw std::runtime_error(kJobStops);
  return *std::move(value);
}

Expected<Valve> valve_of(const JobStore& store, const Job& job);

/// Makes the job RUNNING, with so many closures known. FAILED if the server was killed by it again and again (no
/// attempt kept anything new). Throws if the server stops.
std::optional<JobEnd> begin(JobBoard& board, RunningJob& job, std::int64_t known);

/// Calls `keep` until the closure is kept, however long a disk stays full. If a client asked for the job's end
/// before it was started again, it ends here: with the first closure that is new. Throws as retried().
void keep_closure(JobBoard& board, RunningJob& job, const std::function<Errors()>& keep);

}  // namespace coapt
