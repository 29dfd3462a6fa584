#pragma once

#include <nlohmann/json_fwd.hpp>

namespace coapt {

/// Of coapt.closure/1 or coapt.opening/1.
int exit_code_of_closure(const nlohmann::ordered_json& closure);

/// Of coapt.plans/1: kOk if the best-ranked plan closes robustly.
int exit_code_of_plans(const nlohmann::ordered_json& result);

}  // namespace coapt
