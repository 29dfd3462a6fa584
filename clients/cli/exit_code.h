// Exit codes of coapt; docs/engineer/clients.md and `coapt --help` list them.
#pragma once

#include <nlohmann/json_fwd.hpp>

namespace coapt {

namespace exit_code {
inline constexpr int kOk = 0;
inline constexpr int kFailure = 1;       ///< coapt failed: an output could not be written
inline constexpr int kBadInput = 2;      ///< the command line or an input file is wrong
inline constexpr int kNotClosed = 3;     ///< the closure did not converge, or leaflets cross
inline constexpr int kNoRobustPlan = 4;  ///< the best plan is not known to close the valve robustly
inline constexpr int kInterrupted = 130;  ///< Ctrl-C; the best so far was printed
}  // namespace exit_code

/// Of coapt.closure/1 or coapt.opening/1.
int exit_code_of_closure(const nlohmann::ordered_json& closure);

/// Of coapt.plans/1: kOk if the best-ranked plan closes robustly.
int exit_code_of_plans(const nlohmann::ordered_json& result);

}  // namespace coapt
