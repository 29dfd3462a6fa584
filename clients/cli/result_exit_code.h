#pragma once

#include "io/json/json_fwd.h"

namespace coapt {

/// Of coapt.closure/2 or coapt.opening/2.
int exit_code_of_closure(const Json& closure);

/// Of coapt.plans/2: kOk if the best-ranked plan closes robustly.
int exit_code_of_plans(const Json& result);

}  // namespace coapt
