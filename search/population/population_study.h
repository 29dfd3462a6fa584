// All that a study of a population found.
#pragma once

#include <optional>
#include <vector>

#include "search/population/population_findings.h"
#include "search/population/population_tree.h"

namespace coapt {

struct PopulationStudy {
  std::vector<GroupFindings> groups;     ///< all members first
  std::optional<PopulationTree> tree{};  ///< none of so few members that a part of them is empty
  std::vector<SearchedMember> searched{};
  int members = 0, not_made = 0;
  int nodes = 0, closures = 0, failures = 0;  ///< of candidates
};

/// Without searches.
PopulationStudy study_records(const Population& population,
                              const std::vector<PopulationRecord>& records, int nodes);

/// Costs and mean leaks of the tree's choice and of the best candidate, less those of the search.
struct SearchRegret {
  MeanInterval tree_cost{}, tree_leak_mm2{}, best_cost{}, best_leak_mm2{};
};
SearchRegret search_regret(const std::vector<SearchedMember>& searched);

}  // namespace coapt
