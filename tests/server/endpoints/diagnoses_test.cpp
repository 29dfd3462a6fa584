#include "core/closed/closed_valve.h"
#include "core/opened/opened_valve.h"
#include "core/repair/apply_plan.h"
#include "io/json/diagnosis_json.h"
#include "tests/server/endpoints/service_scene.h"

namespace coapt {
namespace {

class DiagnosesTest : public ServiceTest {};

TEST_F(DiagnosesTest, SayWhyTheValveLeaks) {
  const Answer answer = post("/v1/diagnoses", {{"valve", small_document()}});
  ASSERT_EQ(answer.status, 200) << json_of(answer);
  const Valve valve = small_valve();
  const ClosedValve closed = close_and_measure(valve);
  const auto diagnosis =
      diagnose(valve, closed.closure, closed.measure, open_valve(valve)->measure.opening_area_mm2);
  EXPECT_EQ(json_of(answer), diagnosis_document(*diagnosis, valve));
}

TEST_F(DiagnosesTest, AreOfTheValveAsAPlanLeavesIt) {
  const Json ring = {{"schema", "coapt.plan/1"},
                     {"steps", {{{"step", "annuloplasty"}, {"shape", "own"}, {"sizes_below", 6}}}}};
  const Json before = json_of(post("/v1/diagnoses", {{"valve", small_document()}}));
  const Json after = json_of(post("/v1/diagnoses", {{"valve", small_document()}, {"plan", ring}}));
  EXPECT_LT(after["annulus"]["ap_mm"], before["annulus"]["ap_mm"]);
}

TEST_F(DiagnosesTest, BadRequestsNameWhatIsWrong) {
  EXPECT_EQ(post("/v1/diagnoses", {{"valve", small_document()}, {"plans", 1}}).status, 422);
  EXPECT_EQ(post("/v1/diagnoses", Json::object()).status, 422);
}

}  // namespace
}  // namespace coapt
