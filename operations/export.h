// Closed valves as files that are answered.
#pragma once

#include "io/exchange/formats.h"
#include "operations/operation.h"

namespace coapt {

/// "converged", "step_limit", "diverged", or "crossing" whatever else it is.
std::string closure_name(const ClosureResult& closure);

/// Errors: write_valve_file()'s.
Expected<AnswerFile> exported_file(const ClosedValve& exported, const FileFormat& format,
                                   const ExportOptions& options = {});

}  // namespace coapt
