// A coordinator that waits: progress of a run until it ends, then its bytes.
#pragma once

#include <atomic>
#include <ostream>

#include "farm/database/farm_database.h"

namespace coapt {

struct Waiting {
  bool json_progress = false;  ///< a JSON object a second on standard error
  bool quiet = false;
};

/// Returns an exit code: kOk if the run is done, kHoles, kInterrupted, or kFailure. Trouble with the database is waited out.
int wait_for_run(FarmDatabase& database, std::int64_t run, const Waiting& waiting,
                 const std::atomic<bool>& interrupted);

/// The answers of a run one after another, in order of the items. With `frames` those that are there, each after a line
/// "FIRST ITEMS BYTES". Returns an exit code.
int write_answers(FarmDatabase& database, std::int64_t run, bool frames, std::ostream& out,
                  const std::atomic<bool>& interrupted);

}  // namespace coapt
