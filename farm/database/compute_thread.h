// The thread of a worker that computes, so that another one can keep leases while a task takes its time.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "farm/database/farm_database.h"
#include "farm/work/work.h"

namespace coapt {

using WorkOpener = std::function<Expected<Work>(const WorkRequest&)>;

struct ComputeJob {
  TaskKey key;
  int count = 0;
  std::string
      work;  ///< work_id() of the request: the number of a run may be another's after a restored backup
  std::shared_ptr<const WorkRequest> request;
};

struct ComputedTask {
  TaskKey key;
  int count = 0;
  std::string work{};
  std::string bytes{};
  std::string error{};   ///< if not empty, why there are no bytes
  bool stopped = false;  ///< by stop(): there is no answer, at no one's fault
  double seconds = 0.0;
};

/// Computes one job after the other in the order given. The last few works stay open.
class ComputeThread {
 public:
  /// @param threads of each computation
  ComputeThread(WorkOpener open, int threads);
  /// Stops the job in progress and waits for it; drops the others.
  ~ComputeThread();
  ComputeThread(const ComputeThread&) = delete;
  ComputeThread& operator=(const ComputeThread&) = delete;

  void give(ComputeJob job);
  /// What has been computed since the last call; waits up to `patience` if that is nothing.
  std::vector<ComputedTask> take(std::chrono::milliseconds patience);
  /// The jobs that have not begun; they never will.
  std::vector<TaskKey> take_back();
  /// Ends the job in progress soon, if its kind of work heeds that.
  void stop();
  /// Leaves the job in progress alone, if there is one: the thread ends with it, or with the program. Nothing may follow
  /// but the destructor, and the program must end by std::_Exit.
  void let_go();

 private:
  struct State;
  std::shared_ptr<State> state_;
  bool let_go_ = false;
};

}  // namespace coapt
