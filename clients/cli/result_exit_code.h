#pragma once

#include <string>

#include "core/closure/closure_result.h"
#include "io/json/json_fwd.h"

namespace coapt {

/// Of coapt.closure/2 or coapt.opening/2.
int exit_code_of_closure(const Json& closure);

/// Of coapt.plans/2: kOk if the best-ranked plan closes robustly.
int exit_code_of_plans(const Json& result);

/// Says on standard error, where it is so, that what was written of a closure is not to be trusted.
void note_doubt(const std::string& what, const ClosureResult& closure);

}  // namespace coapt
