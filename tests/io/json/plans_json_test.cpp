#include "io/json/plans_json.h"

#include <limits>

#include "io/json/result_json.h"
#include "io/json/search_options_json.h"
#include "io/json/version.h"
#include "tests/io/json/found.h"
#include "tests/io/plans_scene.h"

namespace coapt {
namespace {

std::vector<std::string> keys(const Json& object) {
  std::vector<std::string> names;
  for (const auto& [name, value] : object.items()) names.push_back(name);
  return names;
}

/// As a script reads it: numbers that are not finite have become null.
Json written(const Json& document) { return Json::parse(document.dump()); }

const Json& scene() {
  static const Json document = written(to_json(search_result(), search_request()));
  return document;
}

TEST(PlansJson, HasTheKeysThatScriptsRelyOn) {
  EXPECT_EQ(keys(scene()), (std::vector<std::string>{"schema",
                                                     "version",
                                                     "revision",
                                                     "notice",
                                                     "before",
                                                     "diagnosis",
                                                     "any_competent",
                                                     "verdict",
                                                     "plans",
                                                     "fine_mesh",
                                                     "model_draws",
                                                     "information",
                                                     "best_cost_history",
                                                     "progress",
                                                     "random_progress",
                                                     "pareto_front",
                                                     "ladder",
                                                     "branches",
                                                     "cut",
                                                     "plans_possible",
                                                     "plans_tried",
                                                     "stop",
                                                     "closures",
                                                     "evaluations",
                                                     "closures_known",
                                                     "closures_not_converged",
                                                     "closures_crossed",
                                                     "seconds",
                                                     "not_modelled",
                                                     "weights",
                                                     "reproduce"}));
  EXPECT_EQ(scene()["schema"], "coapt.plans/2");
  EXPECT_EQ(scene()["notice"], kResearchNotice);
  EXPECT_EQ(scene()["before"]["status"], "converged");
  EXPECT_EQ(scene()["before"]["crossing"], false);
  EXPECT_EQ(scene()["before"]["leak_mm2"], 52.0);
  EXPECT_EQ(scene()["best_cost_history"].dump(), "[231.0,96.0,41.0,17.5,9.9,7.4,6.3]");
  EXPECT_EQ(scene()["stop"], "evaluation_limit");
  EXPECT_EQ(scene()["closures"], 6120);
  EXPECT_EQ(scene()["evaluations"], 2000);
  EXPECT_EQ(scene()["seconds"], 84.25);
}

TEST(PlansJson, APlanHasTheKeysThatScriptsRelyOn) {
  const std::vector<std::string> expected = {"rank",
                                             "plan",
                                             "description",
                                             "row",
                                             "leak",
                                             "estimates",
                                             "leak_mm2",
                                             "ranked_cost",
                                             "cost",
                                             "cost_terms",
                                             "status",
                                             "crossing",
                                             "measure",
                                             "steps",
                                             "ring_sizes_below",
                                             "anterolateral_movement_mm",
                                             "posteromedial_movement_mm",
                                             "region_closures",
                                             "region_failures",
                                             "margin_to_leak",
                                             "pareto",
                                             "beaten_by",
                                             "times_first",
                                             "probability_outranks_next",
                                             "acceptable_probability",
                                             "tier",
                                             "class",
                                             "simplest_of_class",
                                             "tie_with_next",
                                             "subset",
                                             "closes_robustly",
                                             "fine",
                                             "under_draws",
                                             "cold_starts",
                                             "leak_map",
                                             "sobol",
                                             "independent_leak_mm2",
                                             "remodelling",
                                             "tolerance",
                                             "gates",
                                             "warnings",
                                             "opening_area_mm2",
                                             "projected_area_mm2",
                                             "gradient_mmhg",
                                             "gradient_exercise_mmhg",
                                             "durability_mm",
                                             "outlasting",
                                             "durability_price"};
  EXPECT_EQ(keys(scene()["plans"][0]), expected);
}

TEST(PlansJson, APlanStatesWhatIsKnownOfItsLeakApartByCause) {
  SearchResult result = search_result();
  result.plans[0].estimates.leak_mm2 = {0.25, Interval{0.0, 0.5}, Interval{0.0, 7.5}, std::nullopt};
  result.before_estimates.leak_mm2 = {52.0, Interval{48.0, 55.0}, Interval{16.0, 78.0},
                                      std::nullopt};
  const Json json = written(to_json(result));
  const Json& leak = json["plans"][0]["leak"];
  EXPECT_EQ(leak["area_mm2"], json["plans"][0]["measure"]["leak_mm2"]);
  EXPECT_EQ(leak["numerical"].dump(), "[0.0,0.5]");
  EXPECT_EQ(leak["tissue"].dump(), "[0.0,7.5]");
  EXPECT_TRUE(leak["execution"].is_null());
  EXPECT_EQ(json["before"]["leak"]["numerical"].dump(), "[48.0,55.0]");
  EXPECT_EQ(json["before"]["leak"]["tissue"].dump(), "[16.0,78.0]");
}

TEST(PlansJson, APlanStatesWhatIsKnownOfTheFiguresOfRules) {
  SearchResult result = search_result();
  result.plans[0].estimates.opening_mm2 = {320.0, Interval{300.0, 340.0}, std::nullopt,
                                           std::nullopt};
  result.plans[0].estimates.tension_max_n = {1.5, Interval{1.25, 1.75}, Interval{1.0, 2.0},
                                             Interval{1.0, 3.0}};
  const Json json = written(to_json(result));
  const Json& estimates = json["plans"][0]["estimates"];
  EXPECT_EQ(keys(estimates),
            (std::vector<std::string>{"coaptation_a2_p2_mm", "tension_max_n", "leaflet_ratio",
                                      "strain_circumferential_max", "strain_radial_max",
                                      "opening_area_mm2", "gradient_mmhg", "durability_mm"}));
  EXPECT_EQ(estimates["opening_area_mm2"].dump(),
            R"({"value":320.0,"numerical":[300.0,340.0],"tissue":null,"execution":null})");
  EXPECT_EQ(estimates["tension_max_n"].dump(),
            R"({"value":1.5,"numerical":[1.25,1.75],"tissue":[1.0,2.0],"execution":[1.0,3.0]})");
  EXPECT_TRUE(estimates["durability_mm"]["value"].is_null());
  EXPECT_EQ(keys(json["before"]["estimates"]), keys(estimates));
}

TEST(PlansJson, APlanHasOneCostByWhichItIsRanked) {
  SearchResult result = search_result();
  RankedPlan& plan = result.plans[0];
  plan.cost = 3.25, plan.fine_cost_change = 1.5, plan.durability_price = 0.5;
  const Json json = written(to_json(result))["plans"][0];
  EXPECT_EQ(json["ranked_cost"], 5.25);
  EXPECT_EQ(json["cost"], 3.25);
  EXPECT_EQ(json["fine"]["cost"], 4.75);
}

TEST(PlansJson, APlanStatesItsOpeningAndHowLongItLasts) {
  SearchResult result = search_result();
  result.plans[0].opening =
      PlanOpening{ClosureStatus::Converged, false, {320.0, 300.0, 700.0, 1.9, 3.7}};
  result.plans[0].durability = Durability{4.25, 0.375};
  result.plans[1].opening = PlanOpening{ClosureStatus::StepLimit, false, {}};
  const Json plans = written(to_json(result))["plans"];
  EXPECT_EQ(plans[0]["opening_area_mm2"], 320.0);
  EXPECT_EQ(plans[0]["projected_area_mm2"], 300.0);
  EXPECT_EQ(plans[0]["gradient_mmhg"], 1.9);
  EXPECT_EQ(plans[0]["durability_mm"], 4.25);
  EXPECT_EQ(plans[0]["outlasting"], 0.375);
  EXPECT_TRUE(plans[1]["opening_area_mm2"].is_null());
  EXPECT_TRUE(plans[1]["durability_mm"].is_null());
}

TEST(PlansJson, APlanStatesItsClosureOnTheFinerMesh) {
  EXPECT_EQ(scene()["fine_mesh"].dump(),
            R"({"levels":1,"triangles":2592,"leak_before_mm2":47.25,"closures":4})");
  const Json& plans = scene()["plans"];
  EXPECT_EQ(plans[0]["closes_robustly"], true);
  EXPECT_EQ(plans[2]["closes_robustly"], false);
  EXPECT_EQ(plans[0]["fine"].dump(),
            R"({"triangles":2592,"status":"converged","crossing":false,)"
            R"("leak_mm2":0.4,"leak_mm2_error":null,"cost":7.92,"own_mesh_rank":2})");
  EXPECT_TRUE(plans[1]["fine"].is_null());
  SearchResult result = search_result();
  result.fine_mesh = {};
  EXPECT_EQ(written(to_json(result))["fine_mesh"].dump(),
            R"({"levels":0,"triangles":null,"leak_before_mm2":null,"closures":0})");
}

TEST(PlansJson, TheFirstPlanStatesItsLeakOverTheErrorOfEachStep) {
  SearchResult result = search_result();
  result.plans[0].tier = PlanTier::Warned;
  result.plans[0].tolerance = {{1,
                                StepError::SutureLength,
                                {-1.0, 0.0, 1.0},
                                {std::numeric_limits<double>::quiet_NaN(), 0.25, 2.5},
                                0.75,
                                true}};
  const Json plans = written(to_json(result))["plans"];
  EXPECT_EQ(plans[0]["tier"], "warned");
  EXPECT_EQ(plans[0]["tolerance"].dump(),
            R"([{"step":1,"error":"suture_length","error_mm":[-1.0,0.0,1.0],)"
            R"("leak_mm2":[null,0.25,2.5],"margin_mm":0.75,"leaks_beyond":true}])");
  EXPECT_EQ(plans[1]["tolerance"].dump(), "[]");
}

TEST(PlansJson, APlanStatesHowManyOfASampleEndElsewhereFromAColdStart) {
  SearchResult result = search_result();
  result.plans[0].starts = StartCheck{8, 1, 0.25};
  const Json plans = written(to_json(result))["plans"];
  EXPECT_EQ(plans[0]["cold_starts"].dump(),
            R"({"closures":8,"elsewhere":1,"leak_difference_max_mm2":0.25})");
  EXPECT_TRUE(plans[1]["cold_starts"].is_null());
}

TEST(PlansJson, APlanStatesItsLeakUnderDrawsOfTheModel) {
  EXPECT_EQ(scene()["model_draws"].dump(),
            R"({"draws":8,"before":{"failures":0,"leak_mm2":{"mean":50.0,"sd":12.5,"worst":71.0}},)"
            R"("closures":32,"chordae_drawn":false,"fit_drawn":false})");
  const Json& plans = scene()["plans"];
  EXPECT_EQ(plans[0]["under_draws"].dump(),
            R"({"failures":1,"leak_mm2":{"mean":0.9,"sd":1.2,"worst":3.5}})");
  EXPECT_TRUE(plans[1]["under_draws"].is_null());
  SearchResult result = search_result();
  result.model_draws = result.model_closures = 0;
  result.before_under_draws.reset();
  EXPECT_EQ(written(to_json(result))["model_draws"].dump(),
            R"({"draws":0,"before":null,"closures":0,"chordae_drawn":false,"fit_drawn":false})");
}

TEST(PlansJson, APlanStatesItsEffortItsRegionAndItsGates) {
  const Json& plan = scene()["plans"][0];
  EXPECT_EQ(plan["rank"], 1);
  EXPECT_EQ(plan["plan"]["schema"], "coapt.plan/1");
  EXPECT_EQ(plan["steps"].size(), 3u);
  EXPECT_EQ(plan["steps"], plan["plan"]["steps"]);
  EXPECT_EQ(plan["ring_sizes_below"], 2.1);
  EXPECT_EQ(plan["anterolateral_movement_mm"], 4.6);
  EXPECT_EQ(plan["posteromedial_movement_mm"], 11.5);
  EXPECT_EQ(plan["region_closures"], 1089);
  EXPECT_EQ(plan["region_failures"], 0);
  EXPECT_EQ(plan["leak_mm2"].dump(),
            R"({"nominal":0.3,"mean":0.42,"sd":0.51,"worst":5.6,"p95":1.4,"below_5":0.992,)"
            R"("below_10":1.0,"below_20":1.0})");
  EXPECT_EQ(plan["margin_to_leak"].dump(),
            R"({"suture_length_mm":0.75,"angle_deg":4.0,"share":0.71,"why_unknown":null})");
  EXPECT_EQ(plan["subset"].dump(), R"({"nodes":17,"cost":6.1})");
  EXPECT_EQ(plan["sobol"]["first"].dump(),
            R"({"suture_length":0.52,"outwards":0.24,"posterior":0.06})");
  EXPECT_EQ(plan["sobol"]["total"]["outwards"], 0.38);
  EXPECT_EQ(plan["independent_leak_mm2"]["mean"], 0.36);
  EXPECT_EQ(
      plan["gates"][3].dump(),
      R"({"rule":"papillary_movement","severity":"warn",)"
      R"("finding":"posteromedial muscle moved by 11 mm; more than 10 mm is unusual, more than 15 mm rejected",)"
      R"("source":"thesis 4.2.3"})");
  EXPECT_EQ(plan["warnings"].size(), 3u);
}

TEST(PlansJson, ALeakMapHasItsAxes) {
  const Json& maps = scene()["plans"][0]["leak_map"];
  ASSERT_EQ(maps.size(), 3u);
  EXPECT_EQ(maps[2]["muscle"], "posteromedial");
  EXPECT_EQ(maps[0]["suture_length_mm"].dump(), "[-1.0,-0.75,-0.5,-0.25,0.0,0.25,0.5,0.75,1.0]");
  EXPECT_EQ(maps[0]["outwards_deg"].dump(), "[-5.0,-4.0,-3.0,-2.0,-1.0,0.0,1.0,2.0,3.0,4.0,5.0]");
  EXPECT_EQ(maps[0]["leak_mm2"].size(), maps[0]["suture_length_mm"].size());
  EXPECT_EQ(maps[0]["leak_mm2"][0].size(), maps[0]["outwards_deg"].size());
  EXPECT_EQ(scene()["plans"][1]["leak_map"].size(), 1u);
}

TEST(PlansJson, RemodellingIsByDirectionAndMillimetre) {
  const Json& curves = scene()["plans"][0]["remodelling"];
  ASSERT_EQ(curves.size(), 4u);
  EXPECT_EQ(curves[0]["direction"], "apical");
  EXPECT_EQ(curves[0]["leak_mm2"].dump(), "[0.2,0.2,0.2,0.2,0.2,2.2,4.2]");
  EXPECT_TRUE(curves[3]["leak_mm2"][6].is_null());
}

TEST(PlansJson, ATieIsSaidAndTheLastPlanHasNoneToOutrank) {
  const Json& plans = scene()["plans"];
  EXPECT_EQ(plans[0]["probability_outranks_next"], 0.5);
  EXPECT_EQ(plans[0]["acceptable_probability"], 0.98);
  EXPECT_EQ(plans[0]["class"], 1);
  EXPECT_EQ(plans[1]["class"], 1);
  EXPECT_EQ(plans[0]["simplest_of_class"], true);
  EXPECT_EQ(plans[1]["simplest_of_class"], false);
  EXPECT_EQ(plans[0]["tie_with_next"], true);
  EXPECT_EQ(plans[1]["tie_with_next"], false);
  EXPECT_TRUE(plans[2]["probability_outranks_next"].is_null());
  EXPECT_EQ(plans[2]["tie_with_next"], false);
}

TEST(PlansJson, WhatIsNotKnownIsNull) {
  const Json& plan = scene()["plans"][2];
  EXPECT_EQ(plan["status"], "step_limit");
  EXPECT_EQ(plan["leak_mm2"].dump(),
            R"({"nominal":31.0,"mean":null,"sd":null,"worst":null,"p95":null,"below_5":null,)"
            R"("below_10":null,"below_20":null})");
  EXPECT_TRUE(plan["margin_to_leak"]["angle_deg"].is_null());
  EXPECT_TRUE(plan["margin_to_leak"]["why_unknown"].is_string());
  EXPECT_TRUE(plan["sobol"]["total"]["posterior"].is_null());
  EXPECT_EQ(plan["leak_map"].dump(), "[]");
  EXPECT_TRUE(scene()["ladder"][3]["spearman"].is_null());

  SearchResult far;
  far.plans.emplace_back().cost = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(written(to_json(far))["plans"][0]["cost"].is_null());
}

TEST(PlansJson, OnlyAnOwnPlanHasAName) {
  EXPECT_FALSE(scene()["plans"][0].contains("name"));
  EXPECT_EQ(scene()["plans"][2]["name"], "own/suture.json");
}

TEST(PlansJson, SaysHowTheSearchWent) {
  EXPECT_EQ(scene()["any_competent"], true);
  EXPECT_EQ(scene()["progress"][6].dump(), R"({"closures":980,"cost":6.3})");
  EXPECT_EQ(scene()["random_progress"][0].dump(), R"({"closures":1,"cost":240.0})");
  EXPECT_EQ(scene()["ladder"][0].dump(),
            R"({"from":0,"to":1,"plans":60,"spearman":0.58,"skipped":true})");
  EXPECT_EQ(scene()["cut"][1].dump(),
            R"({"what":"neochordae","why":"no marginal chorda is ruptured"})");
  EXPECT_EQ(scene()["plans_possible"], 45'678'901);
  EXPECT_EQ(scene()["closures_known"], 310);
  EXPECT_EQ(scene()["not_modelled"].size(), not_modelled().size());
}

TEST(PlansJson, WhatReproducesItIsAskedForInTheSameWords) {
  const Json& reproduce = scene()["reproduce"];
  EXPECT_EQ(keys(reproduce), (std::vector<std::string>{"valve_hash", "version", "revision", "seed",
                                                       "command", "search"}));
  EXPECT_EQ(reproduce["valve_hash"], search_request().valve_hash);
  EXPECT_EQ(reproduce["version"], version());
  EXPECT_EQ(reproduce["seed"], 18446744073709551615u);
  EXPECT_EQ(reproduce["command"], search_request().command);
  const auto again = search_options_from_json(Json::parse(reproduce["search"].dump()));
  ASSERT_TRUE(again);
  EXPECT_EQ(to_json(*again), reproduce["search"]);
  EXPECT_EQ(scene()["weights"], reproduce["search"]["weights"]);
  EXPECT_FALSE(to_json(search_result()).contains("reproduce"));
}

TEST(PlansJson, EveryStopHasItsOwnName) {
  std::vector<std::string> names;
  SearchResult result;
  for (int stop = 0; stop <= static_cast<int>(SearchStop::Cancelled); ++stop) {
    result.stop = static_cast<SearchStop>(stop);
    names.push_back(to_json(result)["stop"]);
  }
  EXPECT_EQ(names, (std::vector<std::string>{"evaluation_limit", "exhausted", "no_improvement",
                                             "target_reached", "time_limit", "cancelled"}));
}

}  // namespace
}  // namespace coapt
