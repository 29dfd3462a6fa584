// Closures of a search's plans kept in a file as they are made, so that a search that is killed, or
// run again with other limits, repeats none.
//
// A row per closure, a transaction per row: what keep() has accepted outlives the process, kill -9
// included (database.h). Rows are never changed or removed. Several processes may share a file on a
// local disk.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <unordered_map>

#include "core/valve/types.h"
#include "io/store/database.h"
#include "search/plans/plan_evaluations.h"

namespace coapt {

/// Every failure is InputOutput, but a file of another kind or schema Unsupported; its message names the file and what SQLite or the system says.
class PlanStore {
 public:
  /// Makes the file if it is missing or empty. What is not a store of this schema is refused, and
  /// not a byte of it changed; so is a file that cannot be written. This call and those below wait
  /// up to `lock_timeout_ms` for other processes, keep() so long for each of subject, plan and row
  /// that is new.
  static Expected<PlanStore> open(const std::string& path, int lock_timeout_ms = 5000);

  /// All closures of one subject (subject.h: plan_subject_of()).
  Expected<KnownPlans> read(const std::string& subject) const;

  /// Empty if the closure is kept now, or was before: the first answer stays. All bits of the
  /// numbers are kept, but those that tell one NaN from another. From one thread at a time. Some
  /// 0.03 ms in the mean over plans of 15 closures, 0.1 if every plan is new; up to 100 ms when the
  /// log goes into the file.
  Errors keep(const std::string& subject, const std::string& plan_key, int disturbance,
              const PlanClosure& closure);

 private:
  /// Texts that stand once in the file, with a number of their own that the rows name them by.
  struct Names {
    Statement select, insert;
    std::unordered_map<std::string, std::int64_t> numbers;  ///< asked for so far

    /// Adds what is not there yet. None if the database refuses.
    std::optional<std::int64_t> number_of(const std::string& name);
    std::optional<std::int64_t> find(const std::string& name) const;
  };

  PlanStore(StoreDatabase database, Names subjects, Names plans, Statement insert);

  StoreDatabase database_;
  Names subjects_, plans_;
  Statement insert_;
};

}  // namespace coapt
