#include "clients/cli/result_exit_code.h"

#include <iostream>

#include "core/closure/standing.h"
#include "core/valve/printable.h"
#include "io/command_line/exit_code.h"
#include "io/json/json.h"

namespace coapt {

int exit_code_of_closure(const Json& closure) {
  const bool trusted = closure["status"] == "converged" && !closure["crossing"].get<bool>();
  return trusted ? exit_code::kOk : exit_code::kNotClosed;
}

void note_doubt(const std::string& what, const ClosureResult& closure) {
  if (const std::string doubt = doubt_about(closure); !doubt.empty())
    std::cerr << "coapt: " + printable(what) + ": " + doubt + '\n';
}

int exit_code_of_plans(const Json& result) {
  if (result["stop"] == "cancelled") return exit_code::kInterrupted;
  // Plans that close robustly are ranked before those that do not.
  return result["any_competent"].get<bool>() ? exit_code::kOk : exit_code::kNoRobustPlan;
}

}  // namespace coapt
