#include "io/picture/search_csv.h"

#include <gtest/gtest.h>

#include "tests/scenes/small_valve.h"

namespace coapt {
namespace {

TEST(SearchCsv, APlanIsARowInTheOrderOfTryingAndWhatIsNotKnownIsEmpty) {
  TriedPlan ring;
  ring.plan.steps = {Annuloplasty{OwnRing{2}}};
  ring.planned.leak_mm2 = 2.5;
  ring.planned.coaptation_mm = 7.0;
  ring.planned.tension_max_n = 0.5;
  ring.cost_as_planned = 4.5;
  ring.cost = 5.5;
  ring.nodes = 17;
  ring.failures = 1;
  ring.leak_mm2.mean = 3.0;
  ring.leak_mm2.sd = 0.25;
  ring.rank = 2;
  TriedPlan nothing;
  nothing.nodes = 1;
  nothing.leak_mm2.mean = nothing.leak_mm2.sd = std::nan("");
  nothing.planned.status = ClosureStatus::StepLimit;
  nothing.planned.crossing = true;
  SearchResult result;
  result.tried = {ring, nothing};
  EXPECT_EQ(
      tried_plans_csv(small_valve(), result),
      "number,rank,description,cost_mm2,nodes,failed_nodes,mean_leak_mm2,sd_leak_mm2,"
      "cost_as_planned_mm2,leak_mm2,coaptation_mm,tension_max_n,status,"
      "crossing,plan\n"
      "1,2,\"annuloplasty: ring in the annulus's own shape, undersized by 2 sizes (transverse 36.0 "
      "to 32.0 mm)\",5.5,17,1,3,0.25,4.5,2.5,7,0.5,converged,false,"
      "\"{\"\"schema\"\":\"\"coapt.plan/1\"\",\"\"steps\"\":[{\"\"step\"\":\"\"annuloplasty\"\","
      "\"\"shape\"\":\"\"own\"\",\"\"sizes_below\"\":2}]}\"\n"
      "2,,,0,1,0,,,0,0,0,0,step_limit,true,"
      "\"{\"\"schema\"\":\"\"coapt.plan/1\"\",\"\"steps\"\":[]}\"\n");
}

}  // namespace
}  // namespace coapt
