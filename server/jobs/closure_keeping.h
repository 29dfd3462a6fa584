// What the kinds of jobs have in common: a valve from the store, closures kept one by one.
#pragma once

#include <functional>
#include <optional>
#include <stdexcept>
#include <string>

#include "core/valve/valve.h"
#include "server/jobs/job_runner.h"

namespace coapt {

inline constexpr const char* kHtmlType = "text/html; charset=utf-8";

/// Opens a store of closures, however long that cannot be done. Throws if the server stops.
template <class Store>
Store open_closures(JobBoard& board, RunningJob& job, const std::string& path) {
  std::optional<Store> store;
  const bool is_open = board.persist(job, [&]() -> Errors {
    Expected<Store> opened = Store::open(path);
    if (!opened) return opened.errors();
    store = *std::move(opened);
    return {};
  });
  if (!is_open) throw std::runtime_error("the server stops");
  return *std::move(store);
}

Expected<Valve> valve_of(const JobStore& store, const Job& job);

/// Makes the job RUNNING, with so many closures known. FAILED if the server was killed by it again and again (no
/// attempt kept anything new). Throws if the server stops.
std::optional<JobEnd> begin(JobBoard& board, RunningJob& job, std::int64_t known);

/// Calls `keep` until the closure is kept, however long a disk stays full. If a client asked for the job's end
/// before it was started again, it ends here: with the first closure that is new. Throws if the server stops.
void keep_closure(JobBoard& board, RunningJob& job, const std::function<Errors()>& keep);

}  // namespace coapt
