// What repairs do to the valves of a population: one record of fixed size a valve, so that ranges of a population can be worked
// out anywhere and put together by their bytes.
//
// Each valve is closed as it is and after each candidate repair that it is offered, as planned and under the first nodes of the
// region of interest, the same for all. A repair's own closure starts from the valve's, its disturbed ones from its own. Costs
// are the search's (plans/objective.h), without openings.
#pragma once

#include <array>
#include <atomic>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "search/plans/search_options.h"
#include "search/population/candidates.h"

namespace coapt {

/// What an echo shows of the valve before repair, by features().
inline constexpr int kFeatures = 14;
struct EchoFeature {
  const char* name;
  const char* words;  ///< for people, with its unit
  int decimals;
};
const std::array<EchoFeature, kFeatures>& echo_features();

enum class CandidateState : int {
  NotOffered,
  Impossible,  ///< the valve does not allow it
  Rejected,    ///< by a rule of practice (plans/gates.h); not closed
  Closed
};

/// Single precision: a record is what is kept, not what is computed with. Leaks are NaN unless trusted closures gave them.
struct CandidateRecord {
  int state = 0;     ///< CandidateState
  int failures = 0;  ///< closures, of the nodes, that are not to be trusted
  float cost = 0.0f;
  float planned_mm2 = 0.0f;              ///< leak as planned
  float mean_mm2 = 0.0f, sd_mm2 = 0.0f;  ///< of the leak over the nodes
};

struct PopulationRecord {
  int index = 0;
  int aetiology = 0;
  int made = 0;  ///< 0: the valve could not be made or closed; then all else is empty
  float leak_mm2 = 0.0f;
  std::array<float, kFeatures> features{};
  std::array<CandidateRecord, kCandidates> candidates{};
};

struct PopulationRecordOptions {
  int nodes = 5;    ///< of the region, the plan as planned among them
  int threads = 0;  ///< 0: all cores; does not change the records
  ClosureOptions closure{};
  /// Members done, from any thread. May be empty.
  std::function<void()> progress{};
  const std::atomic<bool>* cancelled = nullptr;  ///< may be null
};

/// Of one member, on the calling thread.
PopulationRecord population_record(const PopulationMember& member,
                                   const PopulationRecordOptions& options);

/// Cost and leaks of any plan on a member's valve, as those of the candidates are worked out.
CandidateRecord record_of_plan(const Valve& valve, const RepairPlan& plan,
                               const PopulationRecordOptions& options);

/// The records of members [first, first + count), packed one after the other as this machine keeps them; empty if cancelled.
/// A function of these arguments alone: what a farm hands out. @pre the members are there.
std::string population_records(const Population& population, const PopulationRecordOptions& options,
                               int first, int count);
/// The records in such bytes. Unsupported: a length that is no multiple of a record's.
Expected<std::vector<PopulationRecord>> unpack_records(std::string_view bytes);

}  // namespace coapt
