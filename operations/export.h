// Closed valves as files that are answered.
#pragma once

#include "io/exchange/formats.h"
#include "operations/operation.h"

namespace coapt {

/// Errors: write_valve_file()'s.
Expected<AnswerFile> exported_file(const ClosedValve& exported, const FileFormat& format,
                                   const ExportOptions& options = {});

/// That writing the file takes of a core, roughly: of a label map of a valve that is there.
double writing_seconds(const FileFormat& format, const Points& vertices_mm,
                       const ExportOptions& options = {});

}  // namespace coapt
