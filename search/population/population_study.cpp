#include "search/population/population_study.h"

#include <cmath>

namespace coapt {
namespace {

void add_difference(double value, double searched, std::vector<double>& to) {
  if (std::isfinite(value - searched)) to.push_back(value - searched);
}

}  // namespace

PopulationStudy study_records(const Population& population,
                              const std::vector<PopulationRecord>& records, int nodes) {
  PopulationStudy study;
  study.groups = population_findings(population, records);
  if (can_grow_tree(records)) study.tree = population_tree(records);
  study.nodes = nodes;
  for (const PopulationRecord& record : records) {
    ++(record.made != 0 ? study.members : study.not_made);
    for (const CandidateRecord& candidate : record.candidates) {
      if (!is_closed(candidate)) continue;
      study.closures += nodes;
      study.failures += candidate.failures;
    }
  }
  return study;
}

SearchRegret search_regret(const std::vector<SearchedMember>& searched) {
  std::vector<double> tree_cost, tree_leak, best_cost, best_leak;
  for (const SearchedMember& member : searched) {
    const double cost = capped_cost(member.searched);
    add_difference(capped_cost(member.chosen), cost, tree_cost);
    add_difference(member.chosen.mean_mm2, member.searched.mean_mm2, tree_leak);
    add_difference(capped_cost(member.best), cost, best_cost);
    add_difference(member.best.mean_mm2, member.searched.mean_mm2, best_leak);
  }
  return {mean_interval(tree_cost), mean_interval(tree_leak), mean_interval(best_cost),
          mean_interval(best_leak)};
}

}  // namespace coapt
