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
  OpeningSurface surface;
  surface.points_mm = Points::Zero(2, 3);
  surface.points_mm.row(1) << 4.0, 5.0, 6.0;
  surface.outline = {1};
  measure.leak = {
      12.5,
      12.0,
      13.0,
      {{12.5, Vec3(1.0, 2.0, 3.0), Vec3::UnitZ(), {Segment::P2, Segment::A2}, 1.5, surface}}};
  const Json result = closure_to_json(small_valve(), closure, measure, 1.5);
  EXPECT_EQ(result["method"], "thesis");
  EXPECT_EQ(result["membrane"], "continuum");
  EXPECT_EQ(result["status"], "step_limit");
  EXPECT_EQ(result["crossing"], true);
  EXPECT_EQ(result["leak_mm2"], 12.5);
  EXPECT_EQ(result["residual"], 0.02);
  EXPECT_EQ(result["steps"], 40000);
  EXPECT_EQ(result["seconds"], 1.5);
  EXPECT_EQ(result["triangles"], 32);
  EXPECT_TRUE(result["coaptation_area_index"].is_number());
  EXPECT_EQ(result["notice"], kResearchNotice);
  EXPECT_EQ(result["version"], version());
  EXPECT_EQ(
      result["leak"].dump(),
      R"({"area_mm2":12.5,"error_mm2":null,)"
      R"("numerical":null,"tissue":null,"execution":null,"between_mm2":[12.0,13.0],"openings":[)"
      R"({"area_mm2":12.5,"centroid_mm":[1.0,2.0,3.0],"normal":[0.0,0.0,1.0],)"
      R"("segments":["P2","A2"],"width_mm":1.5,"outline_mm":[[4.0,5.0,6.0]]}]})");
  EXPECT_EQ(result["estimates"]["tension_max_n"].dump(),
            R"({"value":0.0,"numerical":null,"tissue":null,"execution":null})")
      << "of a closure that is not to be trusted";
  EXPECT_EQ(result["coaptation"]["sections"].size(), 9u);
}

TEST(ResultJson, ALeakHasItsErrorAndWhatIsNotKnownIsNull) {
  ValveMeasure measure;
  measure.leak = {4.0, 3.5, 4.5, {}};
  measure.leak_error_mm2 = 2.5;
  EXPECT_EQ(to_json(measure)["leak_mm2_error"], to_json(measure)["leak"]["error_mm2"])
      << "for one release more";
  EXPECT_EQ(
      to_json(measure)["leak"].dump(),
      R"({"area_mm2":4.0,"error_mm2":2.5,"numerical":[1.5,6.5],"tissue":null,"execution":null,)"
      R"("between_mm2":[3.5,4.5],"openings":[]})");
  EXPECT_EQ(to_json(ValveMeasure{})["leak"].dump(),
            R"({"area_mm2":null,"error_mm2":null,)"
            R"("numerical":null,"tissue":null,"execution":null,"between_mm2":null,"openings":[]})");
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
