// Whether a search, too, ends at the trigone: for posteromedial tethering, on valves of one anatomy and six displacements.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/repair/approximation.h"
#include "core/valve/remodel.h"
#include "search/plans/plan_search.h"
#include "tests/scenes/small_preset.h"

namespace coapt {
namespace {

bool has_trigone(const RankedPlan& plan) {
  const PapillaryApproximation* const suture = suture_of(plan.plan, Side::Posteromedial);
  return suture != nullptr && suture->anchor == Anchor::IpsilateralTrigone;
}

TEST(OptimalAnchorIsTheTrigone, OrCannotBeToldFromTheFirstPlansInASearch) {
  for (const Vec3& displaced_mm :
       {Vec3(6.0, 5.0, 6.0), Vec3(4.0, 4.0, 4.0), Vec3(8.0, 4.0, 6.0), Vec3(5.0, 6.0, 8.0),
        Vec3(6.0, 3.0, 8.0), Vec3(10.0, 2.0, 6.0)}) {
    Remodelling change;
    change.ap_dilation_percent = 15.0;
    change.posteromedial_mm = displaced_mm;
    SearchOptions options;
    options.evaluations = 40;
    options.plans = 3;
    options.openings = false;
    options.region_points = 9;
    options.fine_levels = options.model_draws = 0;
    const auto result =
        search_plans(*remodel(shared_preset("human-normal", 250), change), options, {});
    ASSERT_TRUE(result);
    ASSERT_FALSE(result->plans.empty());
    EXPECT_TRUE(is_acceptable(*result)) << displaced_mm.transpose();
    EXPECT_TRUE(std::any_of(result->plans.begin(), result->plans.end(), [](const RankedPlan& plan) {
      return plan.of_class == 1 && has_trigone(plan);
    })) << displaced_mm.transpose();
    for (const OtherAnchor& other : result->plans.front().other_anchors)
      EXPECT_LT(std::abs(other.more_mm2), 0.1) << displaced_mm.transpose();
  }
}

}  // namespace
}  // namespace coapt
