// Work on populations of valves.
//
// Kind "members": part 0 {"prior": part, "seed": S, "members": N}, the prior a coapt.population_prior/1. An item is a member; its answer a
// 64-bit length and its JSON. Kind "records": part 0 {"population": part, "members": N, "nodes": M}, the population a coapt.population/1. An item
// is one of its first N members; its answer a record of what repairs do to it (population_records.h).
#pragma once

#include <string_view>
#include <vector>

#include "farm/work/work.h"
#include "search/population/population_records.h"

namespace coapt {

WorkRequest members_request(const PopulationPrior& prior, std::uint64_t seed, int members);
Expected<Work> open_members_work(const WorkRequest& request);
/// Errors: bytes that are no members.
Expected<std::vector<PopulationMember>> member_answers(std::string_view bytes);

/// Errors: closure options other than the default.
Expected<WorkRequest> records_request(const Population& population, int members,
                                      const PopulationRecordOptions& options);
Expected<Work> open_records_work(const WorkRequest& request);

}  // namespace coapt
