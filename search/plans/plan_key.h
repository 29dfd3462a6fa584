#pragma once

#include <string>

#include "core/repair/plan.h"

namespace coapt {

/// A plan as one line of text, for looking it up: steps in a fixed order, lengths rounded to 1e-6
/// mm. Plans with one key do the same to a valve.
std::string plan_key(const RepairPlan& plan);

/// What plans that are the same in surgical terms share: techniques, ring, anchors and leaflets, without lengths and places of sutures, neochordae and
/// resections.
std::string operation_key(const RepairPlan& plan);

}  // namespace coapt
