// The options of a closure as JSON that loses no bit: all that decides its end.
#pragma once

#include "core/closure/closure_options.h"
#include "io/json/json_reader.h"

namespace coapt {

/// Refused (Unsupported) is what cannot be said or would be lost: states on the way, a budget of steps, numbers that are none.
/// ClosureBudget::cancelled is of this process and left out.
Expected<Json> closure_options_json(const ClosureOptions& options);

ClosureOptions read_closure_options(const JsonPlace& place);

}  // namespace coapt
