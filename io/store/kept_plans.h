// Plans that people keep in a service's database.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "io/store/job_store.h"

namespace coapt {

/// A repair plan that somebody wants to find again.
struct KeptPlan {
  std::string id;     ///< unguessable, the caller's
  std::string name;   ///< for people to read
  std::string valve;  ///< id of a stored valve, or a preset's name
  std::string plan;   ///< JSON
};

struct KeptPlanPage {
  std::vector<KeptPlan> plans;   ///< newest first
  std::int64_t next_before = 0;  ///< 0: there are no more
};

/// False, and nothing is kept, if there are `most` already.
Expected<bool> keep_plan(JobStore& store, const KeptPlan& plan, int most);
Expected<std::optional<KeptPlan>> kept_plan(const JobStore& store, const std::string& id);
/// @param size from 1 @param before only those kept before that place; 0: all @param valve empty: of all valves
Expected<KeptPlanPage> kept_plans(const JobStore& store, int size, std::int64_t before,
                                  const std::string& valve);
/// False if there is none; likewise below.
Expected<bool> rename_kept_plan(JobStore& store, const std::string& id, const std::string& name);
Expected<bool> remove_kept_plan(JobStore& store, const std::string& id);

}  // namespace coapt
