#include "io/json/result_json.h"

#include <algorithm>

#include "tests/io/json/found.h"
#include "tests/scenes/small_valve.h"

namespace coapt {
namespace {

using nlohmann::json;
using nlohmann::ordered_json;
using enum ErrorCode;

std::vector<std::string> keys(const ordered_json& object) {
  std::vector<std::string> names;
  for (const auto& [name, value] : object.items()) names.push_back(name);
  return names;
}

TEST(ResultJson, ErrorsHaveCodePathAndMessage) {
  const Errors errors = {{BadTopology, "/faces/3", "is lost"}, {InputOutput, "", "gone"}};
  EXPECT_EQ(to_json(errors).dump(),
            R"([{"code":"bad_topology","path":"/faces/3","message":"is lost"},)"
            R"({"code":"input_output","path":"","message":"gone"}])");
  EXPECT_EQ(to_json(Errors{}).dump(), "[]");
}

TEST(ResultJson, EveryErrorCodeHasItsOwnName) {
  std::vector<std::string> names;
  for (int code = 0; code <= static_cast<int>(InputOutput); ++code) {
    names.push_back(to_json(Errors{{static_cast<ErrorCode>(code), "", ""}})[0]["code"]);
  }
  std::sort(names.begin(), names.end());
  EXPECT_EQ(std::adjacent_find(names.begin(), names.end()), names.end());
  EXPECT_NE(names.front(), "");
}

TEST(ResultJson, AClosureHasTheKeysThatScriptsRelyOn) {
  ClosureResult closure;
  closure.method = Method::Thesis;
  closure.membrane = Membrane::Continuum;
  closure.status = ClosureStatus::StepLimit;
  closure.residual = 0.02;
  closure.steps = 40000;
  closure.crossing = true;
  ValveMeasure measure;
  measure.orifice = {12.5, 30.0, 12.0, {{12.5, Vec3(1.0, 2.0, 3.0), Segment::P2}}};
  const ordered_json result = closure_to_json(small_valve(), closure, measure, 1.5);
  EXPECT_EQ(result["method"], "thesis");
  EXPECT_EQ(result["membrane"], "continuum");
  EXPECT_EQ(result["status"], "step_limit");
  EXPECT_EQ(result["crossing"], true);
  EXPECT_EQ(result["orifice_area_mm2"], 12.5);
  EXPECT_EQ(result["orifice_area_raw_mm2"], 30.0);
  EXPECT_EQ(result["residual"], 0.02);
  EXPECT_EQ(result["steps"], 40000);
  EXPECT_EQ(result["seconds"], 1.5);
  EXPECT_EQ(result["triangles"], 32);
  EXPECT_EQ(result["notice"], kResearchNotice);
  EXPECT_EQ(result["version"], version());
  EXPECT_EQ(result["orifices"][0].dump(),
            R"({"area_mm2":12.5,"centroid_mm":[1.0,2.0,3.0],"segment":"P2"})");
  EXPECT_EQ(result["coaptation"]["sections"].size(), 9u);
}

TEST(ResultJson, ATierOfAccuracyHasItsTolerancesAndTheErrorsOfTheMembrane) {
  const AccuracyTier tier{0.1, 0.4, {2.0, 3.0, 1.0}, {4.0, 5.0, 1.0}};
  EXPECT_EQ(to_json(tier, Membrane::Continuum).dump(),
            R"({"residual_tolerance":0.1,"way_tolerance_mm":0.4,"orifice_error_p99_mm2":4.0,)"
            R"("orifice_error_max_mm2":5.0,"scenes":500,)"
            R"("of":"stopping early on this mesh; not of the mesh"})");
}

TEST(ResultJson, ASearchHasTheKeysThatScriptsRelyOn) {
  SearchResult search;
  search.before.orifice.area_mm2 = 40.0;
  search.stop = SearchStop::Cancelled;
  search.closures = 7;
  search.seconds = 2.0;
  RankedPlan ranked;
  ranked.rank = 1;
  ranked.plan.steps = {ChordalExcision{"a"}};
  ranked.description = {"excise a"};
  ranked.orifice_area_mm2 = {1.0, 2.0, 0.5, 3.0};
  ranked.leak_mm2 = {4.0, 5.0, 0.25, 6.0};
  ranked.warnings = {"tension"};
  search.plans = {ranked};
  const ordered_json result = to_json(search);
  EXPECT_EQ(result["before"]["orifice_area_mm2"], 40.0);
  EXPECT_EQ(result["before"]["status"], "converged");
  EXPECT_EQ(result["stop"], "cancelled");
  EXPECT_EQ(result["closures"], 7);
  EXPECT_EQ(result["seconds"], 2.0);
  EXPECT_EQ(result["notice"], kResearchNotice);
  const ordered_json& plan = result["plans"][0];
  EXPECT_EQ(plan["rank"], 1);
  EXPECT_EQ(plan["plan"]["schema"], "coapt.plan/1");
  EXPECT_EQ(plan["orifice_area_mm2"].dump(), R"({"nominal":1.0,"mean":2.0,"sd":0.5,"worst":3.0})");
  EXPECT_EQ(plan["leak_mm2"].dump(), R"({"nominal":4.0,"mean":5.0,"sd":0.25,"worst":6.0})");
  EXPECT_EQ(keys(plan),
            (std::vector<std::string>{"rank", "plan", "description", "orifice_area_mm2", "leak_mm2",
                                      "cost", "status", "crossing", "measure", "ring_sizes_below",
                                      "anterolateral_movement_mm", "posteromedial_movement_mm",
                                      "region_closures", "region_failures", "warnings"}));
}

TEST(ResultJson, ARegionThatIsNotKnownIsNull) {
  constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
  SearchResult search;
  search.plans.emplace_back().orifice_area_mm2 = {1.5, kUnknown, kUnknown, kUnknown};
  EXPECT_EQ(to_json(search)["plans"][0]["orifice_area_mm2"].dump(),
            R"({"nominal":1.5,"mean":null,"sd":null,"worst":null})");
}

TEST(SearchOptionsJson, NoFieldIsRequired) {
  const auto options = search_options_from_json(json::object());
  ASSERT_TRUE(options);
  EXPECT_EQ(options->evaluations, SearchOptions{}.evaluations);
}

TEST(SearchOptionsJson, EveryFieldIsRead) {
  const auto options = search_options_from_json(json::parse(R"({"evaluations": 10,
      "seed": 18446744073709551615, "threads": 2, "plans": 3, "region_points": 5, "seconds": 1.5})"));
  ASSERT_TRUE(options);
  EXPECT_EQ(options->evaluations, 10);
  EXPECT_EQ(options->seed, 18446744073709551615u);
  EXPECT_EQ(options->threads, 2);
  EXPECT_EQ(options->plans, 3);
  EXPECT_EQ(options->region_points, 5);
  EXPECT_EQ(options->seconds, 1.5);
}

TEST(SearchOptionsJson, ProblemsAreListed) {
  EXPECT_EQ(problems_of(search_options_from_json(json::parse(R"({"evaluations": 0, "seed": -1,
      "threads": 1.5, "plans": 51, "region_points": 1090, "seconds": -1, "speed": 3,
      "closure": {"max_steps": 10000000, "samples": 100}})"))),
            (Found{{OutOfRange, "/evaluations"},
                   {OutOfRange, "/seed"},
                   {WrongType, "/threads"},
                   {OutOfRange, "/plans"},
                   {OutOfRange, "/region_points"},
                   {OutOfRange, "/seconds"},
                   {UnknownField, "/closure"},
                   {UnknownField, "/speed"}}));
  EXPECT_EQ(problems_of(search_options_from_json(json::array())), (Found{{WrongType, ""}}));
}

}  // namespace
}  // namespace coapt
