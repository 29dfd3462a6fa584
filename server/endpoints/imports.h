// Valves out of the files of segmentation tools.
#pragma once

#include "server/endpoints/submissions.h"
#include "server/jobs/import_reading.h"
#include "server/turns.h"

namespace coapt {

/// POST /v1/valves:import {"leaflets": [FILE, ...], "annulus": FILE, "chordae": FILE} or {"slicerheart": [FILE, ...]},
/// both with "name", "provenance", "triangles", "branches", "branch_at", "slack", "reference" (optional). FILE is {"name",
/// "text" or "base64"}. What `coapt valve import` makes of them is stored, and answered as by POST /v1/valves, with "decisions".
struct ImportValve {
  JobStore& store;
  ImportReader reader;
  Compute& compute;
  Answer operator()(const Request& request) const;
};

/// POST /v1/imports, the same body, with "fit" (optional): 202 and a job of kind "import". The valve is made before the
/// answer, so that what is wrong with the files is refused here; the job draws and fits (ImportJob).
struct PostImports {
  Submitting submitting;
  ImportReader reader;
  Compute& compute;
  Answer operator()(const Request& request) const;
};

/// POST /v1/imports:preview {"files": [FILE, ...]}: what each holds, to be shown. Nothing is stored.
struct PreviewImport {
  ImportReader reader;
  Compute& compute;
  Answer operator()(const Request& request) const;
};

}  // namespace coapt
