#pragma once

#include <string>
#include <vector>

#include "core/repair/plan.h"

namespace coapt {

/// The plan in surgical words, one line a step ("annuloplasty: generic-classic ring, size 30 mm").
std::vector<std::string> describe(const Valve& valve, const RepairPlan& plan);

}  // namespace coapt
