#pragma once

#include <atomic>

#include "core/repair/plan.h"
#include "server/answer.h"

namespace coapt {

/// POST /v1/plans {"valve": coapt.valve/1, "search": {...} (optional)}: searches repair plans.
/// Answers what `coapt plan --json` prints ("evaluations" of "search" are not all of its closures, see
/// SearchOptions); a server that stops answers with the best so far.
struct PostPlans {
  const std::vector<RingShape>& catalogue;
  const std::atomic<bool>& stopping;

  Answer operator()(std::string_view body) const;
};

}  // namespace coapt
