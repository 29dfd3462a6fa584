#pragma once

#include "core/repair/plan.h"
#include "server/answer.h"

namespace coapt {

/// POST /v1/closures {"valve": coapt.valve/1, "plan": coapt.plan/1 (optional)}: closes the valve,
/// repaired if there is a plan. Answers what `coapt close --json` prints.
struct PostClosures {
  const std::vector<RingShape>& catalogue;

  Answer operator()(std::string_view body) const;
};

}  // namespace coapt
