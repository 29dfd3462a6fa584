// Closures of a search's plans kept in a file as they are made, so that a search that is killed, or
// run again with other limits, repeats none.
//
// A row per closure, a transaction per row: what keep() has accepted outlives the process, kill -9
// included (database.h). Rows are never changed; retain() alone removes some. Several processes may
// share a file on a local disk.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "core/valve/types.h"
#include "io/store/subject_uses.h"
#include "search/plans/plan_evaluations.h"

namespace coapt {

/// Every failure is InputOutput, but a file of another kind or schema Unsupported; its message names the file and what SQLite or the system says.
class PlanStore {
 public:
  /// Makes the file if it is missing or empty. What is not a store of this schema is refused, and
  /// not a byte of it changed; so is a file that cannot be written. This call and those below wait
  /// up to `lock_timeout_ms` for other processes, keep() of a new plan twice so long.
  static Expected<PlanStore> open(const std::string& path, int lock_timeout_ms = 5000);

  /// All closures of one subject (subject.h: plan_subject_of()).
  Expected<KnownPlans> read(const std::string& subject) const;

  /// Empty if the closure is kept now, or was before: the first answer stays. All bits of the
  /// numbers are kept, but those that tell one NaN from another. From one thread at a time. Some
  /// 0.03 ms in the mean over plans of 15 closures, 0.1 if every plan is new; up to 100 ms when the
  /// log goes into the file.
  Errors keep(const std::string& subject, const std::string& plan_key, int disturbance,
              const PlanClosure& closure);

  /// The subject was used now: see subject_uses.h, likewise below.
  Errors note_use(const std::string& subject, std::int64_t now_ms);
  Errors retain(const ClosureLimits& limits, const SubjectsInUse& in_use, std::int64_t now_ms);

 private:
  /// One name in the file for each text: the rows refer to its number. Names may go at any time with the last
  /// closure that refers to them, so that no number is remembered between statements.
  struct Statements {
    Statement insert, add_subject, add_plan, begin, commit, rollback;
  };

  PlanStore(std::unique_ptr<StoreConnection> connection, Statements statements);
  Errors keep_with_names(const std::string& subject, const std::string& plan_key);

  std::unique_ptr<StoreConnection> connection_;
  Statements statements_;
};

}  // namespace coapt
