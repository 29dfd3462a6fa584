// Asking for work to be done: here, or by a farm through the program coapt-farm. Whoever asks has one way for both.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <limits>
#include <string>

#include "farm/work/work.h"

namespace coapt {

struct AskProgress {
  std::int64_t done = 0, items = 0;
  int workers = 0;  ///< alive; 0 where the work is done here
  double rate_per_s = 0.0;
  double eta_s = std::numeric_limits<double>::quiet_NaN();  ///< NaN: not known
};

struct AskContext {
  std::string label = {};                                 ///< what people read in the farm's lists
  std::function<void(const AskProgress&)> progress = {};  ///< from one thread at a time
  const std::atomic<bool>* cancelled = nullptr;  ///< ends the asking by an error; may be null
};

/// The answers of all items, one after another. Errors: those of open_work(), what became of the work, or that it was
/// cancelled.
using Asker = std::function<Expected<std::string>(const WorkRequest&, const AskContext&)>;

/// Done in this process, task by task, on `threads` threads (0: all cores).
Asker ask_here(int threads);

}  // namespace coapt
