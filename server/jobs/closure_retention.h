// The limits of closures that searches and studies keep, so that jobs asked for again, or killed, need not make them
// anew.
#pragma once

#include <string>

#include "io/store/job_store.h"

namespace coapt {

/// Closures of a job that has not ended stay, whatever the limits say. Holds up no request: it works on files that
/// jobs alone use.
struct ClosureRetention {
  const JobStore& store;
  Retention limits;
  std::string plans, studies;  ///< paths of a PlanStore and a ClosureStore

  /// Removes what is over the limits. What cannot be done now is done after the next job. Does not throw.
  Errors operator()(std::int64_t now_ms) const noexcept;
  /// The same, after a job that used its closures until now.
  Errors operator()(const Job& ended, std::int64_t now_ms) const noexcept;
};

}  // namespace coapt
