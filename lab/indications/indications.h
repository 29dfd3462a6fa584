// Whether the first plan is one of those that a valve's disease indicates, whether plainer plans would do as well, and whether other seeds
// of the search end with the same one.
#pragma once

#include <atomic>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "search/plans/search_options.h"
#include "search/plans/search_result.h"
#include "search/population/population.h"

namespace coapt {

/// A valve whose disease is known, for it was made so: "competent", or Carpentier's "I", "II", "IIIb".
struct KnownDisease {
  std::string name, type;
  Valve valve;
};

/// Eight presets and four remodelled ones: thresholds were chosen on them.
Expected<std::vector<KnownDisease>> known_presets();

/// The first members of a population, "member-0" and so on: nothing was chosen on them.
Expected<std::vector<KnownDisease>> known_members(const PopulationPrior& prior, std::uint64_t seed,
                                                  int count, int threads);

/// Whether a surgeon would call the plan indicated: no step for a competent valve; else one ring, 3 : 4 unless leaflets are tethered, neochordae or a
/// resection where leaflets prolapse, papillary sutures for tethered leaflets alone, and no warning that another plan may do without.
bool is_indicated(const RankedPlan& plan, const std::string& type);

/// Plans with fewer steps than the first one, indicated like it: every ring alone, and some at random.
struct Challenge {
  int plans = 0, acceptable = 0;
  int beat = 0;   ///< acceptable, with no more warnings than the first
  int ahead = 0;  ///< that the rule puts before the first
  /// Of rings alone the one that the rule puts first; empty: none was possible.
  std::string ring_alone{};
  double ring_probability = std::numeric_limits<double>::quiet_NaN();
  double ring_durability_mm = std::numeric_limits<double>::quiet_NaN();  ///< NaN: leaks as planned
};

struct IndicationOptions {
  SearchOptions search;    ///< of the first seed
  int seeds = 1;           ///< searches, each with the next seed
  int challengers = 0;     ///< at random
  bool challenge = false;  ///< rings alone, and these
};

struct IndicationRow {
  std::string valve{}, type{}, diagnosed{}, first_plan{}, warnings{};
  bool sure = false, indicated = false;
  double leak_mm2 = 0.0;
  int of_class = 0;     ///< reported plans that cannot be told apart from the first
  int times_first = 0;  ///< of the settings of thresholds (plan_order.h) those that put it first
  double acceptable = std::numeric_limits<double>::quiet_NaN();
  double durability_mm = std::numeric_limits<double>::quiet_NaN();
  int closures = 0;
  /// First plans, one a seed, that are of the first class if ranked together.
  std::optional<int> same_class{};
  std::optional<Challenge> challenge{};
};

/// None if it was cancelled. Errors: those of the search.
Expected<IndicationRow> judge_indication(const KnownDisease& known,
                                         const IndicationOptions& options,
                                         const std::atomic<bool>& cancelled);

/// A line a valve; empty where nothing was asked.
std::string indications_csv(const std::vector<IndicationRow>& rows);

}  // namespace coapt
