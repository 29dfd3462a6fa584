// A worker of a farm: takes tasks, computes them, hands in the answers, until it is stopped.
//
// One thread computes, the caller's owns the connection: it claims ahead, renews leases, hands in, and connects again after a
// break. Work is done outside any transaction. An answer is kept until the database has it; a worker that is killed loses
// what it held, which others take once its leases have run out.
#pragma once

#include <atomic>
#include <functional>
#include <string>

#include "farm/database/compute_thread.h"
#include "farm/database/farm_database.h"

namespace coapt {

struct WorkerOptions {
  WorkerName name;
  int threads = 1;         ///< of one computation
  bool until_dry = false;  ///< ends when no run is open that it may answer
  double seconds = 0.0;    ///< ends before so long; 0: no limit
  double grace_s = 2.0;    ///< what a task in progress may still take when the worker is stopped
};

enum class WorkerEnd {
  Dry,
  TimeLimit,
  Stopped,
  Refused,  ///< by the database, in a way that trying again does not change: see `errors`
};

struct WorkerReport {
  WorkerEnd end = WorkerEnd::Dry;
  std::int64_t tasks = 0, items = 0;  ///< handed in
  double computing_s = 0.0, seconds = 0.0;
  bool let_go =
      false;  ///< a task is still being computed, for nobody: the program must end by std::_Exit
  Errors errors{};
};

/// @param stop set from outside, ends the worker within grace_s and what the database takes; tasks are given back.
/// @param say one line about what it waits for.
WorkerReport run_worker(FarmDatabase& database, const WorkOpener& open,
                        const WorkerOptions& options, const std::atomic<bool>& stop,
                        const std::function<void(const std::string&)>& say);

}  // namespace coapt
