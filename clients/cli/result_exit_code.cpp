#include "clients/cli/result_exit_code.h"

#include "io/command_line/exit_code.h"
#include "io/json/json.h"

namespace coapt {

int exit_code_of_closure(const Json& closure) {
  const bool trusted = closure["status"] == "converged" && !closure["crossing"].get<bool>();
  return trusted ? exit_code::kOk : exit_code::kNotClosed;
}

int exit_code_of_plans(const Json& result) {
  if (result["stop"] == "cancelled") return exit_code::kInterrupted;
  // Plans that close robustly are ranked before those that do not.
  return result["any_competent"].get<bool>() ? exit_code::kOk : exit_code::kNoRobustPlan;
}

}  // namespace coapt
