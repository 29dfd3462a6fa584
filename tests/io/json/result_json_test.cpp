#include "io/json/result_json.h"

#include <algorithm>

#include "io/json/version.h"
#include "tests/io/json/found.h"
#include "tests/scenes/small_valve.h"

namespace coapt {
namespace {

using enum ErrorCode;

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
  closure.closed_mm = small_valve().rest_mm;
  closure.method = Method::Thesis;
  closure.membrane = Membrane::Continuum;
  closure.status = ClosureStatus::StepLimit;
  closure.residual = 0.02;
  closure.steps = 40000;
  closure.crossing = true;
  ValveMeasure measure;
  measure.orifice = {12.5, 30.0, 12.0, {{12.5, Vec3(1.0, 2.0, 3.0), Segment::P2}}};
  const Json result = closure_to_json(small_valve(), closure, measure, 1.5);
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
  EXPECT_TRUE(result["coaptation_area_index"].is_number());
  EXPECT_EQ(result["notice"], kResearchNotice);
  EXPECT_EQ(result["version"], version());
  EXPECT_EQ(result["orifices"][0].dump(),
            R"({"area_mm2":12.5,"centroid_mm":[1.0,2.0,3.0],"segment":"P2"})");
  EXPECT_EQ(result["coaptation"]["sections"].size(), 9u);
}

TEST(ResultJson, AnAreaHasItsErrorBesideIt) {
  ValveMeasure measure;
  measure.error = {2.5, 3.5, 4.5};
  const auto json = to_json(measure);
  EXPECT_EQ(json["orifice_area_mm2_error"], 2.5);
  EXPECT_EQ(json["coaptation"]["gap_area_mm2_error"], 3.5);
  EXPECT_EQ(json["leak_mm2_error"], 4.5);
  EXPECT_EQ(to_json(ValveMeasure{})["leak_mm2_error"].dump(), "null") << "it is not known";
}

TEST(ResultJson, AnAccuracyIsWhatWasAskedAndHowItWasKept) {
  AccurateClosure closure;
  closure.refinements = 1;
  closure.tier.residual_tolerance = 0.1;
  closure.tier.way_tolerance_mm = 0.4;
  EXPECT_EQ(to_json(closure, 0.5).dump(),
            R"({"error_mm2":0.5,"refinements":1,"residual_tolerance":0.1,"way_tolerance_mm":0.4})");
}

}  // namespace
}  // namespace coapt
