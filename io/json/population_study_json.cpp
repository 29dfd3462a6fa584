#include "io/json/population_study_json.h"

#include <array>
#include <utility>

#include "io/json/result_json.h"
#include "io/json/version.h"
#include "search/training/binomial.h"

namespace coapt {
namespace {

Json interval_json(const MeanInterval& interval) {
  return {{"mean", interval.mean},
          {"interval95", {interval.low, interval.high}},
          {"members", interval.count}};
}

Json share_json(int count, int of) {
  if (of == 0) return {{"count", count}, {"of", of}, {"share", nullptr}, {"interval95", nullptr}};
  const std::array<double, 2> interval = share_interval(count, of);
  return {{"count", count},
          {"of", of},
          {"share", static_cast<double>(count) / of},
          {"interval95", interval}};
}

const char* name_of(int candidate) {
  return candidate_repairs()[static_cast<std::size_t>(candidate)].name.c_str();
}

Json family_json(const FamilyWins& family, int members) {
  return {{"family", to_string(family.family)},
          {"offered", family.offered},
          {"wins", share_json(family.wins, members)},
          {"as_good", share_json(family.as_good, members)}};
}

Json candidate_json(const CandidateMeans& means) {
  return {{"repair", name_of(means.candidate)},
          {"closed", means.closed},
          {"refused", means.refused},
          {"wins", means.wins},
          {"competent", share_json(means.competent, means.closed)},
          {"cost", means.cost},
          {"leak_mm2", interval_json(means.leak_mm2)}};
}

Json anchor_json(const AnchorComparison& anchor) {
  return {{"muscles", anchor.both_muscles ? "both" : "posteromedial"},
          {"ring", anchor.ring},
          {"movement_mm", anchor.movement_mm},
          {"trigone_better", share_json(anchor.trigone_better, anchor.members)},
          {"same", share_json(anchor.same, anchor.members)},
          {"trigone_less_saddle_peak_mm2", interval_json(anchor.difference_mm2)}};
}

Json decided_json(const DecidedBy& decided) {
  Json factors = Json::array();
  for (std::size_t i = 0; i < decided.indices.total.size(); ++i)
    factors.push_back({{"factor", decided.factors[i]},
                       {"first", decided.indices.first[i]},
                       {"total", decided.indices.total[i]},
                       {"effect", decided.indices.effect[i]}});
  return {{"quantity", decided.quantity},
          {"members", decided.members},
          {"predicted_share", decided.indices.predicted_share},
          {"factors", std::move(factors)}};
}

template <class T, class ToJson>
Json list_json(const std::vector<T>& list, const ToJson& json) {
  Json all = Json::array();
  for (const T& entry : list) all.push_back(json(entry));
  return all;
}

Json group_json(const GroupFindings& group) {
  return {{"aetiology", group.aetiology ? to_string(*group.aetiology) : "all"},
          {"members", group.members},
          {"families",
           list_json(group.families,
                     [&](const FamilyWins& family) { return family_json(family, group.members); })},
          {"candidates", list_json(group.candidates, candidate_json)},
          {"anchors", list_json(group.anchors, anchor_json)},
          {"undersizing", list_json(group.undersizing,
                                    [](const Undersizing& sizes) -> Json {
                                      return {
                                          {"sizes_below", sizes.sizes_below},
                                          {"competent", share_json(sizes.competent, sizes.closed)},
                                          {"leak_mm2", interval_json(sizes.leak_mm2)}};
                                    })},
          {"decided_by", list_json(group.decided_by, decided_json)}};
}

Json record_json(const CandidateRecord& record) {
  return {{"cost", record.cost},
          {"planned_mm2", record.planned_mm2},
          {"mean_mm2", record.mean_mm2},
          {"sd_mm2", record.sd_mm2}};
}

Json regret_json(const Regret& regret) {
  return {{"cost", interval_json(regret.cost)}, {"leak_mm2", interval_json(regret.leak_mm2)}};
}

}  // namespace

Json to_json(const PopulationTree& tree) {
  Json nodes = Json::array();
  for (const TreeNode& node : tree.tree.nodes) {
    Json json = {{"choice", name_of(node.choice)}, {"members", node.members}};
    if (node.feature >= 0) {
      json["feature"] = echo_features()[static_cast<std::size_t>(node.feature)].name;
      json["threshold"] = node.threshold;
      json["below"] = node.below;
      json["above"] = node.above;
    }
    nodes.push_back(std::move(json));
  }
  return {{"words", tree_in_words(tree.tree)},
          {"nodes", std::move(nodes)},
          {"leaves", leaves(tree.tree)},
          {"grown_on", tree.grown_on},
          {"pruned_on", tree.pruned_on},
          {"judged_on", tree.judged_on},
          {"regret", regret_json(tree.of_tree)},
          {"single", name_of(tree.single)},
          {"single_regret", regret_json(tree.of_single)},
          {"aetiology_regret", regret_json(tree.of_aetiology)},
          {"judged_leaves", list_json(tree.leaves, [](const TreeLeaf& leaf) -> Json {
             return {{"node", leaf.node},
                     {"members", leaf.members},
                     {"cost", interval_json(leaf.cost)},
                     {"leak_mm2", interval_json(leaf.leak_mm2)},
                     {"regret", interval_json(leaf.regret)}};
           })}};
}

Json to_json(const PopulationStudy& study) {
  const SearchRegret regret = search_regret(study.searched);
  return result_document(
      "coapt.population_study/1",
      {{"members", study.members},
       {"not_made", study.not_made},
       {"nodes", study.nodes},
       {"closures", study.closures},
       {"failures", study.failures},
       {"groups", list_json(study.groups, group_json)},
       {"tree", study.tree ? to_json(*study.tree) : Json(nullptr)},
       {"searched",
        {{"members", list_json(study.searched,
                               [](const SearchedMember& member) -> Json {
                                 return {{"index", member.index},
                                         {"plan", member.plan},
                                         {"closures", member.closures},
                                         {"search", record_json(member.searched)},
                                         {"tree", record_json(member.chosen)},
                                         {"best_candidate", record_json(member.best)}};
                               })},
         {"tree_less_search_cost", interval_json(regret.tree_cost)},
         {"tree_less_search_mm2", interval_json(regret.tree_leak_mm2)},
         {"best_less_search_cost", interval_json(regret.best_cost)},
         {"best_less_search_mm2", interval_json(regret.best_leak_mm2)}}}});
}

}  // namespace coapt
