#pragma once

#include <string>

#include "core/repair/plan.h"

namespace coapt {

/// A plan as one line of text, for looking it up: steps in a fixed order, lengths rounded to 1e-6
/// mm. Plans with one key do the same to a valve.
std::string plan_key(const RepairPlan& plan);

}  // namespace coapt
