// Closures as files that other programs open, and as a picture.
#pragma once

#include "io/exchange/formats.h"
#include "server/compute.h"
#include "server/json_body.h"
#include "server/route.h"

namespace coapt {

/// POST /v1/exports {"valve", "plan" (optional), "format", "open" (optional), "frame" (optional)}
struct PostExports {
  ValveSource valves;
  Compute& compute;
  Answer operator()(const Request& request) const;
};

/// POST /v1/pictures {"valve", "plan" (optional)}: what `coapt close --render` draws.
struct PostPictures {
  ValveSource valves;
  Compute& compute;
  Answer operator()(const Request& request) const;
};

/// The file, with a name that browsers save it under.
Answer valve_file_answer(const ClosedValve& exported, const FileFormat& format,
                         const ExportOptions& options = {});

}  // namespace coapt
