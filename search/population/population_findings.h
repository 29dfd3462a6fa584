// What the records of a population say: which repair wins, whether the trigone is the better anchor, how much undersizing is
// enough, and which of it all decides.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "search/population/bootstrap.h"
#include "search/population/population_records.h"
#include "search/studies/sobol_indices.h"

namespace coapt {

/// Repairs whose costs differ by less are as good as each other: the price of one step of surgery.
inline constexpr double kRepairTie_mm2 = 1.0;
/// Leaks that differ by less are the same: closures of one valve that are started otherwise differ by up to 0.24 mm2.
inline constexpr double kLeakTie_mm2 = 0.25;

struct FamilyWins {
  RepairFamily family = RepairFamily::OwnRing;
  int offered = 0;  ///< members with a closed candidate of the family
  int wins = 0;     ///< members of which its best candidate is the cheapest of all
  int as_good = 0;  ///< or costs less than kRepairTie_mm2 more
};

struct CandidateMeans {
  int candidate = 0;
  int closed = 0, refused = 0;  ///< members; refused: impossible or rejected by practice
  int wins = 0;
  int competent = 0;  ///< mean leak at most 5 mm2
  double cost = 0.0;  ///< mean, capped (kWorstRepair)
  MeanInterval leak_mm2{};
};

struct AnchorComparison {
  bool both_muscles = false, ring = false;
  double movement_mm = 0.0;
  int members = 0, trigone_better = 0, same = 0;
  MeanInterval difference_mm2{};  ///< of the mean leak, trigone less saddle peak
};

struct Undersizing {
  int sizes_below = 0;
  int closed = 0, competent = 0;  ///< competent: mean leak at most 5 mm2
  MeanInterval leak_mm2{};        ///< mean over the nodes
};

struct DecidedBy {
  std::string quantity;
  int members = 0;
  std::vector<std::string> factors;  ///< in words
  SobolIndices indices;              ///< over the factors' shares in their priors
};

struct GroupFindings {
  std::optional<Aetiology> aetiology;  ///< none: all members
  int members = 0;
  std::vector<FamilyWins> families;
  std::vector<CandidateMeans> candidates;
  std::vector<AnchorComparison> anchors;
  std::vector<Undersizing> undersizing;
  std::vector<DecidedBy> decided_by;  ///< of one aetiology
};

/// What a repair that cannot be done, or that fails, costs in means and trees: more than any leak of these valves, which costs six times
/// its area.
inline constexpr double kWorstRepair = 1000.0;
double capped_cost(const CandidateRecord& record);

bool is_closed(const CandidateRecord& record);

/// All members first, then each aetiology that has some. Records that were not made are left out.
std::vector<GroupFindings> population_findings(const Population& population,
                                               const std::vector<PopulationRecord>& records);

}  // namespace coapt
