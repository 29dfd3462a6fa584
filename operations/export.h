// Closed valves as files that are answered.
#pragma once

#include "io/exchange/formats.h"
#include "operations/operation.h"

namespace coapt {

/// Errors: write_valve_file()'s.
Expected<AnswerFile> exported_file(const ClosedValve& exported, const FileFormat& format,
                                   const ExportOptions& options = {});

}  // namespace coapt
