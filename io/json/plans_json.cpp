#include "io/json/plans_json.h"

#include "io/json/diagnosis_json.h"
#include "io/json/model_study_json.h"
#include "io/json/plan_json.h"
#include "io/json/result_json.h"
#include "io/json/search_options_json.h"
#include "io/json/version.h"
#include "search/plans/disturbance.h"
#include "search/plans/plan_row.h"
#include "search/plans/verdict.h"

namespace coapt {
namespace {

constexpr double kRegionLengthStep_mm = 0.25, kRegionAngleStep_deg = 1.0;  // region_of_interest()

const char* name_of(SearchStop stop) {
  switch (stop) {
    case SearchStop::EvaluationLimit:
      return "evaluation_limit";
    case SearchStop::Exhausted:
      return "exhausted";
    case SearchStop::NoImprovement:
      return "no_improvement";
    case SearchStop::TargetReached:
      return "target_reached";
    case SearchStop::TimeLimit:
      return "time_limit";
    case SearchStop::Cancelled:
      return "cancelled";
  }
  return "";
}

template <class T, class Write>
Json list_of(const std::vector<T>& entries, Write write) {
  Json list = Json::array();
  for (const T& entry : entries) list.push_back(write(entry));
  return list;
}

Json statistics_json(const LeakStatistics& s) {
  return {{"nominal", s.nominal},   {"mean", s.mean},        {"sd", s.sd},
          {"worst", s.worst},       {"p95", s.p95},          {"below_5", s.below_5},
          {"below_10", s.below_10}, {"below_20", s.below_20}};
}

Json margin_json(const RegionReport& region) {
  const LeakMargin& margin = region.margin_to_leak;
  const std::string why = why_margin_unknown(region);
  return {{"suture_length_mm", margin.suture_length_mm},
          {"angle_deg", margin.angle_deg},
          {"share", margin.share},
          {"why_unknown", why.empty() ? Json() : Json(why)}};
}

Json gate_json(const Gate& gate) {
  return {{"rule", gate.rule},
          {"severity", to_string(gate.severity)},
          {"finding", gate.finding},
          {"source", gate.source}};
}

/// `count` values around 0.
std::vector<double> axis(int count, double step) {
  std::vector<double> values;
  for (int i = 0; i < count; ++i) values.push_back(step * (i - count / 2));
  return values;
}

Json map_json(const LeakMap& map) {
  return {{"muscle", map.muscle},
          {"suture_length_mm", axis(kRegionLengths, kRegionLengthStep_mm)},
          {"outwards_deg", axis(kRegionAngles, kRegionAngleStep_deg)},
          {"leak_mm2", map.leak_mm2}};
}

Json remodelling_json(const RemodellingCurve& curve) {
  return {{"direction", curve.direction}, {"leak_mm2", curve.leak_mm2}};
}

Json indices_json(const RegionIndices& indices) {
  const auto by_axis = [](const std::array<double, 3>& shares) {
    return Json{{"suture_length", shares[0]}, {"outwards", shares[1]}, {"posterior", shares[2]}};
  };
  return {{"first", by_axis(indices.first)}, {"total", by_axis(indices.total)}};
}

/// Null if it was not closed on a refined mesh.
Json fine_json(const RankedPlan& ranked, const FineMesh& mesh) {
  if (!ranked.fine) return nullptr;
  return {{"triangles", mesh.triangles},
          {"status", to_string(ranked.fine->status)},
          {"crossing", ranked.fine->crossing},
          {"leak_mm2", ranked.fine->leak_mm2},
          {"leak_mm2_error", ranked.fine_leak_error_mm2},
          {"cost", ranked.cost + ranked.fine_cost_change},
          {"own_mesh_rank", ranked.own_mesh_rank > 0 ? Json(ranked.own_mesh_rank) : Json()}};
}

Json fine_mesh_json(const FineMesh& mesh) {
  return {{"levels", mesh.levels},
          {"triangles", mesh.triangles > 0 ? Json(mesh.triangles) : Json()},
          {"leak_before_mm2", mesh.before ? Json(mesh.before->leak_mm2) : Json()},
          {"closures", mesh.closures}};
}

/// Null without draws.
Json spread_json(const std::optional<ModelSpread>& spread) {
  if (!spread) return nullptr;
  return {{"failures", spread->failures},
          {"leak_mm2",
           {{"mean", spread->mean_mm2}, {"sd", spread->sd_mm2}, {"worst", spread->worst_mm2}}}};
}

Json model_json(const SearchResult& result) {
  Json json = {{"draws", result.model_draws},
               {"before", spread_json(result.before_under_draws)},
               {"closures", result.model_closures},
               {"chordae_drawn", result.draws_chordae},
               {"fit_drawn", result.draws_fit}};
  if (result.observed.empty()) return json;
  json["observed"] = observed_names(result.observed);
  json["effective"] = result.effective_draws;
  json["contradicts_model"] = result.observed_contradicts;
  return json;
}

/// Nulls where it was not opened, or did not come to rest.
Json opening_json(const std::optional<PlanOpening>& opening) {
  const bool known = opening && trusted(*opening);
  const auto number = [&](double OpeningMeasure::*value) {
    return known ? Json(opening->measure.*value) : Json();
  };
  return {{"opening_area_mm2", number(&OpeningMeasure::opening_area_mm2)},
          {"projected_area_mm2", number(&OpeningMeasure::projected_area_mm2)},
          {"gradient_mmhg", number(&OpeningMeasure::gradient_mmhg)},
          {"gradient_exercise_mmhg", number(&OpeningMeasure::gradient_exercise_mmhg)}};
}

Json terms_json(const CostTerms& terms) {
  Json json;
  for (int term = 0; term < kTerms; ++term) json[cost_term_rows()[term].name] = terms.amounts[term];
  return json;
}

/// Nulls without the evidence.
Json durability_json(const RankedPlan& ranked) {
  const auto number = [&](double Durability::*value) {
    return ranked.durability ? Json(*ranked.durability.*value) : Json();
  };
  return {{"durability_mm", number(&Durability::expected_mm)},
          {"outlasting", number(&Durability::outlasting)},
          {"durability_price", ranked.durability_price}};
}

/// All but the leak, which has a member of its own.
Json estimates_json(const PlanEstimates& estimates) {
  return {{"coaptation_a2_p2_mm", estimate_json(estimates.coaptation_mm)},
          {"tension_max_n", estimate_json(estimates.tension_max_n)},
          {"leaflet_ratio", estimate_json(estimates.leaflet_ratio)},
          {"strain_circumferential_max", estimate_json(estimates.strain_circumferential)},
          {"strain_radial_max", estimate_json(estimates.strain_radial)},
          {"opening_area_mm2", estimate_json(estimates.opening_mm2)},
          {"gradient_mmhg", estimate_json(estimates.gradient_mmhg)},
          {"durability_mm", estimate_json(estimates.durability_mm)}};
}

Json leak_json(const RankedPlan& ranked) {
  Json json = {{"area_mm2", ranked.measure.leak.area_mm2}};
  json.update(to_json(ranked.estimates.leak_mm2));
  return json;
}

Json beaten_json(const RankedPlan& ranked) {
  if (ranked.beaten_by == 0) return {};
  return {{"rank", ranked.beaten_by}, {"in", ranked.beaten_in}};
}

Json tolerance_json(const ToleranceCurve& curve) {
  return {{"step", curve.step},           {"error", to_string(curve.error)},
          {"error_mm", curve.error_mm},   {"leak_mm2", curve.leak_mm2},
          {"margin_mm", curve.margin_mm}, {"leaks_beyond", curve.leaks_beyond}};
}

Json row_json(const PlanRow& row) {
  return {{"leak", row.leak},
          {"reserve", row.reserve},
          {"opening", row.opening},
          {"effort", row.effort}};
}

Json ranked_json(const RankedPlan& ranked, const FineMesh& mesh) {
  const RegionReport& region = ranked.region;
  const Json plan = to_json(ranked.plan);
  Json json = {{"rank", ranked.rank}};
  if (!ranked.name.empty()) json["name"] = ranked.name;
  json.update({{"plan", plan},
               {"description", ranked.description},
               {"row", row_json(row_of(ranked))},
               {"leak", leak_json(ranked)},
               {"estimates", estimates_json(ranked.estimates)},
               {"leak_mm2", statistics_json(region.leak_mm2)},
               {"ranked_cost", ranked.cost + ranked.durability_price + ranked.fine_cost_change},
               {"cost", ranked.cost},
               {"cost_terms", terms_json(ranked.terms)},
               {"status", to_string(ranked.status)},
               {"crossing", ranked.crossing},
               {"measure", to_json(ranked.measure)},
               {"steps", plan["steps"]},
               {"ring_sizes_below", ranked.effort.sizes_below},
               {"anterolateral_movement_mm", ranked.effort.anterolateral_movement_mm},
               {"posteromedial_movement_mm", ranked.effort.posteromedial_movement_mm},
               {"region_closures", region.closures},
               {"region_failures", region.failures},
               {"margin_to_leak", margin_json(region)},
               {"pareto", ranked.pareto},
               {"beaten_by", beaten_json(ranked)},
               {"times_first", ranked.times_first},
               {"probability_outranks_next", ranked.probability_outranks_next},
               {"acceptable_probability", ranked.acceptable_probability},
               {"tier", to_string(ranked.tier)},
               {"class", ranked.of_class},
               {"simplest_of_class", ranked.simplest_of_class},
               {"tie_with_next", ranked.ties_with_next},
               {"subset", {{"nodes", ranked.subset_nodes}, {"cost", ranked.subset_cost}}},
               {"closes_robustly", ranked.is_acceptable},
               {"fine", fine_json(ranked, mesh)},
               {"under_draws", spread_json(ranked.model)},
               {"cold_starts", ranked.starts ? to_json(*ranked.starts) : Json()},
               {"leak_map", list_of(region.maps, map_json)},
               {"sobol", indices_json(region.indices)},
               {"independent_leak_mm2", statistics_json(region.independent_leak_mm2)},
               {"remodelling", list_of(region.remodelling, remodelling_json)},
               {"tolerance", list_of(ranked.tolerance, tolerance_json)},
               {"gates", list_of(ranked.gates, gate_json)},
               {"warnings", ranked.warnings}});
  json.update(opening_json(ranked.opening));
  json.update(durability_json(ranked));
  return json;
}

Json progress_json(const Progress& progress) {
  return {{"closures", progress.closures}, {"cost", progress.cost}};
}

Json pareto_json(const ParetoPlan& plan) {
  const Json document = to_json(plan.plan);
  return {{"plan", document},
          {"description", plan.description},
          {"mean_mm2", plan.mean_mm2},
          {"sd_mm2", plan.sd_mm2},
          {"steps", document["steps"]},
          {"ring_sizes_below", plan.sizes_below},
          {"opening_mm2", plan.opening_mm2},
          {"durability_mm", plan.durability_mm},
          {"cost", plan.cost},
          {"nodes", plan.nodes}};
}

Json ladder_json(const LadderStep& step) {
  return {{"from", step.from},
          {"to", step.to},
          {"plans", step.plans},
          {"spearman", step.spearman},
          {"skipped", step.skipped}};
}

Json before_json(const SearchResult& result) {
  const Evaluation& before = result.before;
  Json json = {{"status", to_string(before.status)}, {"crossing", before.crossing}};
  json.update(to_json(before.measure));
  json["leak"].update(to_json(result.before_estimates.leak_mm2));
  json["estimates"] = estimates_json(result.before_estimates);
  json.update(opening_json(result.opening_before));
  return json;
}

}  // namespace

Json to_json(const StartCheck& starts) {
  return {{"closures", starts.closures},
          {"elsewhere", starts.elsewhere},
          {"leak_difference_max_mm2", starts.leak_difference_max_mm2}};
}

Json to_json(const SearchResult& result) {
  return result_document(
      "coapt.plans/2",
      {{"before", before_json(result)},
       {"diagnosis", to_json(result.diagnosis, result.before_estimates.leak_mm2)},
       {"any_competent", result.any_acceptable},
       {"verdict", verdict_of(result.plans)},
       {"plans",
        list_of(result.plans,
                [&](const RankedPlan& plan) { return ranked_json(plan, result.fine_mesh); })},
       {"fine_mesh", fine_mesh_json(result.fine_mesh)},
       {"model_draws", model_json(result)},
       {"information", to_json(result.information)},
       {"best_cost_history", list_of(result.progress, [](const Progress& p) { return p.cost; })},
       {"progress", list_of(result.progress, progress_json)},
       {"random_progress", list_of(result.random_progress, progress_json)},
       {"pareto_front", list_of(result.pareto_front, pareto_json)},
       {"ladder", list_of(result.ladder, ladder_json)},
       {"branches", result.branches},
       {"cut", list_of(result.cut,
                       [](const CutBranches& cut) {
                         return Json{{"what", cut.what}, {"why", cut.why}};
                       })},
       {"plans_possible", result.plans_possible},
       {"plans_tried", result.plans_tried},
       {"stop", name_of(result.stop)},
       {"closures", result.closures},
       {"evaluations", result.evaluations},
       {"closures_known", result.closures_known},
       {"closures_not_converged", result.closures_not_converged},
       {"closures_crossed", result.closures_crossed},
       {"seconds", result.seconds},
       {"not_modelled", not_modelled()}});
}

Json to_json(const SearchResult& result, const SearchRequest& request) {
  Json json = to_json(result);
  json["weights"] = to_json(request.options.weights);
  json["reproduce"] = {{"valve_hash", request.valve_hash}, {"version", version()},
                       {"revision", revision_json()},      {"seed", request.options.seed},
                       {"command", request.command},       {"search", to_json(request.options)}};
  return json;
}

}  // namespace coapt
