#include "io/json/search_options_json.h"

#include "io/json/json_reader.h"
#include "io/json/plan_json.h"

namespace coapt {
namespace {

using nlohmann::ordered_json;

constexpr std::size_t kMostForbidden = 100;  // there are fewer to forbid
constexpr Range kPrice = {0.0, 1e6};         // CostWeights

JsonField number(std::string_view name, double& target, Range range, const char* unit = "") {
  const auto read = [=](const JsonPlace& place) { return read_number_in(place, range, unit); };
  return {name, into(target, read), false};
}

JsonField integer(std::string_view name, int& target, int min, int max) {
  const auto read = [=](const JsonPlace& place) { return read_integer_in(place, min, max); };
  return {name, into(target, read), false};
}

JsonField boolean(std::string_view name, bool& target) {
  return {name, into(target, read_boolean), false};
}

std::vector<std::string> read_words(const JsonPlace& place) {
  if (place.value.is_array() && place.value.size() > kMostForbidden) {
    add_problem(place, ErrorCode::OutOfRange,
                "has " + std::to_string(place.value.size()) + " words, must have at most " +
                    std::to_string(kMostForbidden));
    return {};
  }
  return read_list(place, read_string);
}

SearchRules read_rules(const JsonPlace& place) {
  SearchRules rules;
  read_fields(place, {{"fixed", into(rules.fixed, read_plan_within), false},
                      {"forbidden", into(rules.forbidden, read_words), false},
                      integer("most_neochordae", rules.most_neochordae, 0, 4),
                      boolean("chordal_length_change", rules.chordal_length_change),
                      boolean("chordal_excision", rules.chordal_excision),
                      boolean("chordal_transfer", rules.chordal_transfer),
                      number("suture_lattice_mm", rules.suture_lattice_mm, {0.1, 5.0}, " mm"),
                      number("neochorda_lattice_mm", rules.neochorda_lattice_mm, {0.5, 5.0}, " mm"),
                      number("most_movement_mm", rules.most_movement_mm, {2.0, 15.0}, " mm")});
  return rules;
}

CostWeights read_weights(const JsonPlace& place) {
  CostWeights weights;
  read_fields(
      place,
      {number("leak", weights.leak, kPrice), number("sd_share", weights.sd_share, kPrice),
       number("incompetence", weights.incompetence, kPrice),
       number("margin", weights.margin, kPrice), number("coaptation", weights.coaptation, kPrice),
       number("gap", weights.gap, kPrice), number("movement", weights.movement, kPrice),
       number("movement_above_10", weights.movement_above_10, kPrice),
       number("undersizing", weights.undersizing, kPrice),
       number("undersizing_above_4", weights.undersizing_above_4, kPrice),
       number("step", weights.step, kPrice), number("tension", weights.tension, kPrice),
       number("untrusted", weights.untrusted, kPrice)});
  return weights;
}

ordered_json rules_json(const SearchRules& rules) {
  // Names all fields, so that this does not compile when there is one more; so below.
  const auto& [fixed, forbidden, most_neochordae, length_change, excision, transfer, suture,
               neochorda, movement] = rules;
  return {{"fixed", to_json(fixed)},
          {"forbidden", forbidden},
          {"most_neochordae", most_neochordae},
          {"chordal_length_change", length_change},
          {"chordal_excision", excision},
          {"chordal_transfer", transfer},
          {"suture_lattice_mm", suture},
          {"neochorda_lattice_mm", neochorda},
          {"most_movement_mm", movement}};
}

}  // namespace

Expected<SearchOptions> search_options_from_json(const nlohmann::json& json) {
  ProblemList problems;
  SearchOptions options;
  read_fields({json, problems}, {integer("evaluations", options.evaluations, 1, 1'000'000),
                                 {"seed", into(options.seed, read_unsigned), false},
                                 integer("threads", options.threads, 0, 1024),
                                 integer("plans", options.plans, 1, 50),
                                 integer("region_points", options.region_points, 1, 1089),
                                 boolean("evidence", options.evidence),
                                 number("seconds", options.seconds, {0.0, 1e6}, " s"),
                                 integer("no_improvement", options.no_improvement, 0, 1'000'000),
                                 number("target_mm2", options.target_mm2, {-1.0, 1e6}, " mm2"),
                                 {"rules", into(options.rules, read_rules), false},
                                 {"weights", into(options.weights, read_weights), false}});
  if (!problems.empty()) return std::move(problems).take();
  return options;
}

ordered_json to_json(const SearchOptions& options) {
  const auto& [evaluations, seed, threads, plans, region_points, evidence, seconds, no_improvement,
               target_mm2, rules, weights, closure] = options;
  static_cast<void>(closure);
  return {{"evaluations", evaluations},
          {"seed", seed},
          {"threads", threads},
          {"plans", plans},
          {"region_points", region_points},
          {"evidence", evidence},
          {"seconds", seconds},
          {"no_improvement", no_improvement},
          {"target_mm2", target_mm2},
          {"rules", rules_json(rules)},
          {"weights", to_json(weights)}};
}

ordered_json to_json(const CostWeights& weights) {
  const auto& [leak, sd_share, incompetence, margin, coaptation, gap, movement, movement_above_10,
               undersizing, undersizing_above_4, step, tension, untrusted] = weights;
  return {{"leak", leak},
          {"sd_share", sd_share},
          {"incompetence", incompetence},
          {"margin", margin},
          {"coaptation", coaptation},
          {"gap", gap},
          {"movement", movement},
          {"movement_above_10", movement_above_10},
          {"undersizing", undersizing},
          {"undersizing_above_4", undersizing_above_4},
          {"step", step},
          {"tension", tension},
          {"untrusted", untrusted}};
}

}  // namespace coapt
