#include "operations/plan_operations.h"

#include <array>

#include "operations/table.h"

namespace coapt {
namespace {

using namespace door;

constexpr std::array kPlanOperations = {
    Operation{"evaluate", "evaluate", "/v1/evaluations", "Scores and ranks given plans.",
              kEverywhere, read_evaluate},
    // A service searches as a job, whose closures outlive it.
    Operation{"plan", "plan", "/v1/plans", "Searches for repair plans and ranks them.",
              kEverywhere | kFarm, read_plan, true}};

}  // namespace

std::span<const Operation> plan_operations() { return kPlanOperations; }

}  // namespace coapt
