// A job that makes a valve of files, and fits it to a closed surface.
#pragma once

#include "server/jobs/import_reading.h"
#include "server/jobs/job_runner.h"

namespace coapt {

inline constexpr const char* kImportPicture = "import.png";

/// Its valve is the imported one, made of the same files before the job was taken. Result: coapt.import/2 with the id of
/// the valve made, and "fit" (coapt.fit/1) if one was asked for. Files: import.png, valve.json, and fit.png. A fit is kept
/// round by round: a job that was killed goes on from the last one, to the same valve. Out of time it ends as it is then,
/// "finished": false.
struct ImportJob {
  JobBoard& board;
  JobStore& store;
  ImportReader reader;

  std::optional<JobEnd> operator()(RunningJob& job) const;
};

}  // namespace coapt
