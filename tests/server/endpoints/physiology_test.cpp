
#include "core/repair/apply_plan.h"
#include "core/valve/pressure_unit.h"
#include "io/json/physiology_json.h"
#include "tests/server/endpoints/service_scene.h"

namespace coapt {
namespace {

class PhysiologyTest : public ServiceTest {
 protected:
  Answer study(const Json& more = Json::object()) {
    Json request = {{"valve", small_document()}};
    request.update(more);
    return post("/v1/physiology", request);
  }
};

Json row_of(const Json& physiology, const std::string& quantity) {
  for (const Json& row : physiology["rows"])
    if (row["quantity"] == quantity) return row;
  return {};
}

TEST_F(PhysiologyTest, IsThatOfTheValve) {
  const Answer answer = study();
  ASSERT_EQ(answer.status, 200) << json_of(answer);
  EXPECT_EQ(json_of(answer), to_json(study_physiology(small_valve()), small_valve()));
  EXPECT_EQ(json_of(answer)["rows"].size(), physiology_quantities().size());
}

TEST_F(PhysiologyTest, RangesAreOfTheKindAndSpeciesAskedForAndTheValveMayBeNamed) {
  const Json told =
      json_of(post("/v1/physiology",
                   {{"valve", stored_valve()}, {"kind", "functional"}, {"species", "porcine"}}));
  EXPECT_EQ(told["kind"], "functional");
  EXPECT_EQ(told["kind_judged"], false);
  EXPECT_EQ(told["species"], "porcine");
  EXPECT_EQ(told["species_judged"], false);
  for (const Json& row : told["rows"]) {
    const PhysiologyRange* range =
        find_range(row["quantity"], ValveKind::Functional, Species::Porcine);
    EXPECT_EQ(row["low"], range != nullptr ? Json(range->low) : Json()) << row;
  }
}

TEST_F(PhysiologyTest, APlanAndMaterialAreApplied) {
  const Json ring = {{"schema", "coapt.plan/1"},
                     {"steps", {{{"step", "annuloplasty"}, {"shape", "own"}, {"sizes_below", 6}}}}};
  const Json repaired = json_of(study({{"plan", ring}, {"material", {{"pressure_mmhg", 90}}}}));
  Valve same = small_valve();
  same.pressure_kpa = 90.0 / kMmhgPerKpa;
  same = *apply_plan(same, *plan_from_json(ring));
  const Physiology expected = study_physiology(same, {.trials = {PhysiologyTrial::Opening}});
  EXPECT_EQ(row_of(repaired, "opening")["value"],
            row_of(to_json(expected, same), "opening")["value"]);
  EXPECT_EQ(row_of(repaired, "leak")["value"], row_of(repaired, "leak_90")["value"]);
}

TEST_F(PhysiologyTest, EveryProblemPointsIntoTheRequest) {
  EXPECT_EQ(refusal(study({{"kind", "sick"}, {"species", 7}, {"frames", 1}})),
            (Refused{422, {"/kind", "/species", "/frames"}}));
  EXPECT_EQ(refusal(study({{"valve", "nobody"}})), (Refused{422, {"/valve"}}));
  EXPECT_EQ(refusal(post("/v1/physiology", Json::object())), (Refused{422, {"/valve"}}));
  EXPECT_EQ(ask("POST", "/v1/physiology", "{").status, 400);
}

TEST_F(PhysiologyTest, TheLimitsAreThoseOfClosures) {
  {
    const Compute::Turn other(compute());
    EXPECT_EQ(study().status, 503);
  }
  limits_.vertex_steps = 1000.0;
  const Answer long_one = study();
  EXPECT_EQ(long_one.status, 422);
  EXPECT_NE(content_bytes(long_one).find("more than 1000 steps times vertices"), std::string::npos);
  limits_.vertex_steps = 1e9;
  limits_.request_seconds = 1e-9;
  EXPECT_EQ(study().status, 503);
  limits_.vertices = 10;
  EXPECT_EQ(refusal(study()), (Refused{422, {"/valve/vertices_mm"}}));
}

}  // namespace
}  // namespace coapt
