#include "io/store/kept_plans.h"

#include "io/store/stored_valves.h"
#include "tests/io/store/job_scene.h"

namespace coapt {
namespace {

class KeptPlans : public JobStoreTest {
 protected:
  void keep(int i, const std::string& valve = "v") {
    const std::string number = std::to_string(i);
    const auto kept = keep_plan(store(), {"k" + number, "Plan " + number, valve, "{}"}, 100);
    ASSERT_TRUE(kept && *kept);
  }
  std::vector<std::string> kept_names(int size, std::int64_t before,
                                      const std::string& valve = "") {
    std::vector<std::string> names;
    const KeptPlanPage page = *kept_plans(store(), size, before, valve);
    for (const KeptPlan& plan : page.plans) names.push_back(plan.name);
    return names;
  }
};

TEST_F(KeptPlans, AKeptPlanComesBackByteForByteAfterOpeningAgain) {
  const KeptPlan plan = {"i" + all_bytes(), "n" + all_bytes(), "v" + all_bytes(), all_bytes(9'000)};
  ASSERT_TRUE(*keep_plan(store(), plan, 1));
  open_again();
  const KeptPlan found = **kept_plan(store(), plan.id);
  EXPECT_EQ(found.id, plan.id);
  EXPECT_EQ(found.name, plan.name);
  EXPECT_EQ(found.valve, plan.valve);
  EXPECT_EQ(found.plan, plan.plan);
  EXPECT_FALSE(*kept_plan(store(), "another"));
}

TEST_F(KeptPlans, KeptPlansAreListedNewestFirstAllOrThoseOfAValve) {
  for (int i = 1; i <= 5; ++i) keep(i, i % 2 == 0 ? "even" : "odd");
  const KeptPlanPage page = *kept_plans(store(), 2, 0, "");
  EXPECT_EQ(kept_names(2, 0), (std::vector<std::string>{"Plan 5", "Plan 4"}));
  EXPECT_EQ(kept_names(9, page.next_before),
            (std::vector<std::string>{"Plan 3", "Plan 2", "Plan 1"}));
  EXPECT_EQ(kept_names(9, 0, "even"), (std::vector<std::string>{"Plan 4", "Plan 2"}));
  EXPECT_EQ(kept_plans(store(), 5, 0, "")->next_before, 0);
}

TEST_F(KeptPlans, AKeptPlanIsRenamedAndRemovedOnce) {
  keep(1);
  EXPECT_TRUE(*rename_kept_plan(store(), "k1", "Better"));
  EXPECT_EQ((*kept_plan(store(), "k1"))->name, "Better");
  EXPECT_TRUE(*remove_kept_plan(store(), "k1"));
  EXPECT_FALSE(*remove_kept_plan(store(), "k1"));
  EXPECT_FALSE(*rename_kept_plan(store(), "k1", "Better"));
}

TEST_F(KeptPlans, NoMorePlansAreKeptThanAreAllowed) {
  EXPECT_TRUE(*keep_plan(store(), {"a", "", "", ""}, 1));
  EXPECT_FALSE(*keep_plan(store(), {"b", "", "", ""}, 1));
  EXPECT_TRUE(*remove_kept_plan(store(), "a"));
  EXPECT_TRUE(*keep_plan(store(), {"b", "", "", ""}, 1));
}

TEST_F(KeptPlans, AValveStaysAsLongAsAKeptPlanRefersToIt) {
  ASSERT_TRUE(add_valve(store(), "v", "{}"));
  keep(1);
  expect_bad_reference(remove_valve(store(), "v").errors());
  EXPECT_TRUE(*remove_kept_plan(store(), "k1"));
  EXPECT_TRUE(*remove_valve(store(), "v"));
}

}  // namespace
}  // namespace coapt
