#include "search/population/population_tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>

#include "search/plans/plan_search.h"
#include "search/population/population_findings.h"

namespace coapt {
namespace {

enum class Part { Grow, Prune, Judge };

Part part_of(int index) {
  if (index % 2 == 0) return Part::Grow;
  return index % 4 == 1 ? Part::Prune : Part::Judge;
}

std::vector<const PopulationRecord*> records_of(const std::vector<PopulationRecord>& records,
                                                Part part) {
  std::vector<const PopulationRecord*> some;
  for (const PopulationRecord& record : records)
    if (record.made != 0 && part_of(record.index) == part) some.push_back(&record);
  return some;
}

Eigen::RowVectorXd features_row(const PopulationRecord& record) {
  Eigen::RowVectorXd row(kFeatures);
  for (int f = 0; f < kFeatures; ++f) {
    const double value = record.features[static_cast<std::size_t>(f)];
    row[f] = std::isfinite(value) ? value : 0.0;
  }
  return row;
}

TreeData tree_data(const std::vector<const PopulationRecord*>& records) {
  TreeData data;
  data.features.resize(std::ssize(records), kFeatures);
  data.costs.resize(std::ssize(records), kCandidates);
  for (std::size_t r = 0; r < records.size(); ++r) {
    const auto row = static_cast<Eigen::Index>(r);
    data.features.row(row) = features_row(*records[r]);
    for (int c = 0; c < kCandidates; ++c)
      data.costs(row, c) = capped_cost(records[r]->candidates[static_cast<std::size_t>(c)]);
  }
  return data;
}

int cheapest_candidate(const PopulationRecord& record) {
  int best = 0;
  for (int c = 1; c < kCandidates; ++c)
    if (capped_cost(record.candidates[static_cast<std::size_t>(c)]) <
        capped_cost(record.candidates[static_cast<std::size_t>(best)]))
      best = c;
  return best;
}

double leak_after(const PopulationRecord& record, int candidate) {
  const CandidateRecord& done = record.candidates[static_cast<std::size_t>(candidate)];
  return is_closed(done) && std::isfinite(done.mean_mm2) ? done.mean_mm2 : record.leak_mm2;
}

double cost_after(const PopulationRecord& record, int candidate) {
  return capped_cost(record.candidates[static_cast<std::size_t>(candidate)]);
}

template <class Choice>
Regret regret_of(const std::vector<const PopulationRecord*>& records, const Choice& choice) {
  std::vector<double> costs, leaks;
  for (const PopulationRecord* record : records) {
    const int chosen = choice(*record), best = cheapest_candidate(*record);
    costs.push_back(cost_after(*record, chosen) - cost_after(*record, best));
    leaks.push_back(leak_after(*record, chosen) - leak_after(*record, best));
  }
  return {mean_interval(costs), mean_interval(leaks)};
}

/// `otherwise`: of an aetiology that has no members.
std::array<int, kAetiologies.size()> best_by_aetiology(
    const std::vector<const PopulationRecord*>& records, int otherwise) {
  std::array<int, kAetiologies.size()> best{};
  for (std::size_t a = 0; a < best.size(); ++a) {
    std::vector<const PopulationRecord*> some;
    for (const PopulationRecord* record : records)
      if (record->aetiology == static_cast<int>(a)) some.push_back(record);
    best[a] = some.empty() ? otherwise : best_single_choice(tree_data(some));
  }
  return best;
}

TreeLeaf judge_leaf(const std::vector<const PopulationRecord*>& records, const DecisionTree& tree,
                    int node) {
  TreeLeaf leaf;
  leaf.node = node;
  std::vector<double> costs, leaks, regrets;
  const int chosen = tree.nodes[static_cast<std::size_t>(node)].choice;
  for (const PopulationRecord* record : records) {
    if (leaf_of(tree, features_row(*record)) != node) continue;
    costs.push_back(cost_after(*record, chosen));
    leaks.push_back(leak_after(*record, chosen));
    regrets.push_back(costs.back() - cost_after(*record, cheapest_candidate(*record)));
  }
  leaf.members = static_cast<int>(costs.size());
  leaf.cost = mean_interval(costs);
  leaf.leak_mm2 = mean_interval(leaks);
  leaf.regret = mean_interval(regrets);
  return leaf;
}

void add_leaves(const std::vector<const PopulationRecord*>& records, const DecisionTree& tree,
                int node, std::vector<TreeLeaf>& leaves) {
  const TreeNode& at = tree.nodes[static_cast<std::size_t>(node)];
  if (at.feature < 0) {
    leaves.push_back(judge_leaf(records, tree, node));
    return;
  }
  add_leaves(records, tree, at.below, leaves);
  add_leaves(records, tree, at.above, leaves);
}

bool is_yes_or_no(int feature) {
  const std::string name = echo_features()[static_cast<std::size_t>(feature)].name;
  return name == "prolapse" || name == "flail";
}

void add_words(const DecisionTree& tree, int node, int depth, std::vector<std::string>& lines) {
  const TreeNode& at = tree.nodes[static_cast<std::size_t>(node)];
  const std::string indent(static_cast<std::size_t>(2 * depth), ' ');
  if (at.feature < 0) {
    lines.push_back(indent + candidate_repairs()[static_cast<std::size_t>(at.choice)].name);
    return;
  }
  lines.push_back(indent + "If " + question_of(tree, node, false) + ":");
  add_words(tree, at.below, depth + 1, lines);
  lines.push_back(indent + "If " + question_of(tree, node, true) + ":");
  add_words(tree, at.above, depth + 1, lines);
}

}  // namespace

std::string question_of(const DecisionTree& tree, int node, bool above) {
  const TreeNode& at = tree.nodes[static_cast<std::size_t>(node)];
  const EchoFeature& feature = echo_features()[static_cast<std::size_t>(at.feature)];
  if (is_yes_or_no(at.feature)) return std::string(feature.words) + (above ? "" : ": no");
  const std::string words = feature.words;
  const std::size_t comma = words.rfind(", ");
  const std::string unit = comma == std::string::npos ? "" : " " + words.substr(comma + 2);
  char number[32];
  std::snprintf(number, sizeof number, "%.*f", feature.decimals, at.threshold);
  return words.substr(0, comma) + (above ? " " : " below ") + number + unit +
         (above ? " or more" : "");
}

bool can_grow_tree(const std::vector<PopulationRecord>& records) {
  return !records_of(records, Part::Grow).empty() && !records_of(records, Part::Prune).empty() &&
         !records_of(records, Part::Judge).empty();
}

PopulationTree population_tree(const std::vector<PopulationRecord>& records) {
  const auto grow = records_of(records, Part::Grow), prune = records_of(records, Part::Prune),
             judge = records_of(records, Part::Judge);
  TreeOptions options;
  for (const EchoFeature& feature : echo_features())
    options.rounding.push_back(is_yes_or_no(static_cast<int>(options.rounding.size()))
                                   ? 0.0
                                   : std::pow(10.0, -feature.decimals));
  const TreeData grown = tree_data(grow);
  PopulationTree made;
  made.tree = pruned(grow_tree(grown, options), tree_data(prune));
  made.grown_on = static_cast<int>(grow.size());
  made.pruned_on = static_cast<int>(prune.size());
  made.judged_on = static_cast<int>(judge.size());
  made.single = best_single_choice(grown);
  made.of_tree = regret_of(
      judge, [&](const PopulationRecord& record) { return choice_of(made.tree, record); });
  made.of_single = regret_of(judge, [&](const PopulationRecord&) { return made.single; });
  const std::array<int, kAetiologies.size()> by_aetiology = best_by_aetiology(grow, made.single);
  made.of_aetiology = regret_of(judge, [&](const PopulationRecord& record) {
    return by_aetiology[static_cast<std::size_t>(record.aetiology)];
  });
  add_leaves(judge, made.tree, 0, made.leaves);
  return made;
}

int choice_of(const DecisionTree& tree, const PopulationRecord& record) {
  return tree.nodes[static_cast<std::size_t>(leaf_of(tree, features_row(record)))].choice;
}

std::vector<std::string> tree_in_words(const DecisionTree& tree) {
  std::vector<std::string> lines;
  add_words(tree, 0, 0, lines);
  return lines;
}

std::vector<int> members_to_search(const std::vector<PopulationRecord>& records, int count) {
  const auto judge = records_of(records, Part::Judge);
  const int some = std::min(count, static_cast<int>(judge.size()));
  std::vector<int> indices;
  for (int i = 0; i < some; ++i)
    indices.push_back(
        judge[static_cast<std::size_t>(i) * judge.size() / static_cast<std::size_t>(some)]->index);
  return indices;
}

Expected<SearchedMember> search_member(const PopulationMember& member,
                                       const PopulationRecord& record, const DecisionTree& tree,
                                       int evaluations, const PopulationRecordOptions& options) {
  const Expected<Valve> valve = make_valve(member);
  if (!valve) return valve.errors();
  SearchOptions search;
  search.evaluations = evaluations;
  search.threads = options.threads;
  search.plans = 1;
  search.region_points = std::max(17, options.nodes);
  search.evidence = search.openings = false;
  search.fine_levels = search.model_draws = 0;
  search.rules.edge_to_edge = true;
  search.closure = options.closure;
  SearchContext context;
  context.cancelled = options.cancelled;
  const Expected<SearchResult> result = search_plans(*valve, search, context);
  if (!result) return result.errors();
  if (result->plans.empty())
    return Error{ErrorCode::ImpossibleStep, "", "the search found no plan"};
  const RankedPlan& plan = result->plans.front();
  SearchedMember found;
  found.index = member.index;
  for (const std::string& step : plan.description)
    found.plan += (found.plan.empty() ? "" : "; ") + step;
  found.searched = record_of_plan(*valve, plan.plan, options);
  found.chosen = record.candidates[static_cast<std::size_t>(choice_of(tree, record))];
  found.best = record.candidates[static_cast<std::size_t>(cheapest_candidate(record))];
  found.closures = result->closures;
  return found;
}

}  // namespace coapt
