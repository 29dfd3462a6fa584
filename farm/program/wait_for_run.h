// A coordinator that waits: progress of a run until it ends, then its bytes, which are looked at before they are believed.
#pragma once

#include <atomic>
#include <ostream>

#include "farm/database/farm_database.h"

namespace coapt {

struct Waiting {
  bool json_progress = false;  ///< a JSON object a second on standard error
  bool quiet = false;
};

/// A run, and what its answers are held to.
struct AskedRun {
  std::int64_t run = 0;
  std::string work;  ///< work_id(): an answer that names another is none
  /// Looks at each answer and computes `sampled` tasks again, drawn when all are there. Null: of another revision, whose answers
  /// cannot be told from wrong ones here.
  const Work* check = nullptr;
  int sampled = 0;
};

/// Waits until the run is done, then looks at the answers; what is not right is open again, and waited for again, some times. If
/// two logins differ and no third is there, it is the third. Returns an exit code: kOk, or kHoles if some tasks have no answer,
/// say that what is there may be written; else kInterrupted or kFailure. Trouble with the database is waited out.
int wait_and_check(FarmDatabase& database, const AskedRun& asked, const Waiting& waiting,
                   const std::atomic<bool>& interrupted);

/// Looks at the answers that are there. Returns an exit code: kFailure if some are not right, which are open again.
int check_answers(FarmDatabase& database, const AskedRun& asked, bool json_errors,
                  const std::atomic<bool>& interrupted);

/// The answers of a run one after another, in order of the items. With `frames` those that are there, each after a line
/// "FIRST ITEMS BYTES". Returns an exit code.
int write_answers(FarmDatabase& database, const AskedRun& asked, bool frames, std::ostream& out,
                  const std::atomic<bool>& interrupted);

}  // namespace coapt
