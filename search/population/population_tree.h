// A tree that a surgeon can read, from the records of a population: grown on half of its members, pruned on a quarter, judged on
// the last quarter, which nothing else has seen.
#pragma once

#include <string>
#include <vector>

#include "search/plans/search_options.h"
#include "search/population/bootstrap.h"
#include "search/population/decision_tree.h"
#include "search/population/population_records.h"

namespace coapt {

/// What following a rule costs more than the best candidate of each member.
struct Regret {
  MeanInterval cost{};
  MeanInterval
      leak_mm2{};  ///< mean leak over the nodes; of what cannot be done, that of the unrepaired valve
};

struct TreeLeaf {
  int node = 0;
  int members = 0;      ///< of those that it is judged on
  MeanInterval cost{};  ///< of its choice
  MeanInterval leak_mm2{};
  MeanInterval regret{};  ///< in cost
};

struct PopulationTree {
  DecisionTree tree;
  int grown_on = 0, pruned_on = 0, judged_on = 0;
  int single = 0;  ///< the best candidate for all, of those that the tree was grown on
  Regret of_tree{}, of_single{};
  Regret of_aetiology{};         ///< of the rule that takes the best candidate of each aetiology
  std::vector<TreeLeaf> leaves;  ///< from left to right
};

/// Members with an even index are grown on; of the odd ones every second is pruned on. @pre each part has a record that was made.
PopulationTree population_tree(const std::vector<PopulationRecord>& records);
/// Whether each part has.
bool can_grow_tree(const std::vector<PopulationRecord>& records);

/// The candidate that the tree chooses for a member.
int choice_of(const DecisionTree& tree, const PopulationRecord& record);

/// "tenting height below 9.5 mm", or of the other branch "tenting height 9.5 mm or more". @pre the node is no leaf.
std::string question_of(const DecisionTree& tree, int node, bool above);

/// The tree as nested sentences, a line each: what is asked, and what is done.
std::vector<std::string> tree_in_words(const DecisionTree& tree);

/// The tree's choice beside what the full search finds.
struct SearchedMember {
  int index = 0;
  std::string plan;  ///< of the search, in words
  CandidateRecord searched{}, chosen{},
      best{};        ///< the search's plan, the tree's choice, the best candidate
  int closures = 0;  ///< of the search
};

/// Indices of members that the tree is judged on, evenly spread, `count` at most.
std::vector<int> members_to_search(const std::vector<PopulationRecord>& records, int count);
/// Searches with edge-to-edge repair allowed, but no resection (making its plan space takes a minute a valve), `evaluations` closures; then the
/// plan is closed as the candidates were.
/// Error: the member's valve cannot be made, or leaves nothing to search.
Expected<SearchedMember> search_member(const PopulationMember& member,
                                       const PopulationRecord& record, const DecisionTree& tree,
                                       int evaluations, const PopulationRecordOptions& options);

}  // namespace coapt
