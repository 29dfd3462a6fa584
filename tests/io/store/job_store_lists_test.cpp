#include <sqlite3.h>

#include "tests/io/store/job_scene.h"

namespace coapt {
namespace {

class JobStoreLists : public JobStoreTest {
 protected:
  void keep(int i, const std::string& valve = "v") {
    const std::string number = std::to_string(i);
    const auto kept = store().keep_plan({"k" + number, "Plan " + number, valve, "{}"}, 100);
    ASSERT_TRUE(kept && *kept);
  }
  std::vector<std::string> kept_names(int size, std::int64_t before,
                                      const std::string& valve = "") {
    std::vector<std::string> names;
    const KeptPlanPage page = *store().kept_plans(size, before, valve);
    for (const KeptPlan& plan : page.plans) names.push_back(plan.name);
    return names;
  }
};

constexpr const char* kDocument =
    R"({"name": "Mrs \"A\"", "vertices_mm": [[0,0,0],[1,0,0],[0,1,0]], "faces": [[0,1,2]]})";

TEST_F(JobStoreLists, ValvesAreListedNewestFirstWithNameAndSize) {
  EXPECT_TRUE(store().valves(10, 0)->valves.empty());
  ASSERT_TRUE(store().add_valve("a", kDocument));
  submit(store(), 0);
  const ValvePage first = *store().valves(1, 0);
  ASSERT_EQ(first.valves.size(), 1u);
  EXPECT_EQ(first.valves[0].id, numbered_job(0).valve);
  EXPECT_EQ(first.valves[0].name, "");
  const ValvePage rest = *store().valves(1, first.next_before);
  ASSERT_EQ(rest.valves.size(), 1u);
  EXPECT_EQ(rest.next_before, 0);
  EXPECT_EQ(rest.valves[0].id, "a");
  EXPECT_EQ(rest.valves[0].name, "Mrs \"A\"");
  EXPECT_EQ(rest.valves[0].vertices, 3);
  EXPECT_EQ(rest.valves[0].triangles, 1);
  EXPECT_TRUE(*store().remove_valve("a"));
  EXPECT_EQ(store().valves(10, 0)->valves.size(), 1u);
}

TEST_F(JobStoreLists, WhatIsNoValveIsListedWithoutNameAndSize) {
  for (const char* document : {"", "[1", "7", "{\"name\": 5}", "\x01\x02"})
    ASSERT_TRUE(store().add_valve(std::string("of ") + document, document)) << document;
  EXPECT_EQ(store().valves(10, 0)->valves.size(), 5u);
}

TEST_F(JobStoreLists, AFileOfAnEarlierVersionGetsItsListsWhenItIsOpened) {
  ASSERT_TRUE(store().add_valve("a", kDocument));
  submit(store(), 0);
  for (const char* sql : {"DROP TABLE valve_summaries", "DROP TABLE kept_plans"}) {
    sqlite3* file = nullptr;
    ASSERT_EQ(sqlite3_open(path_.c_str(), &file), SQLITE_OK);
    EXPECT_EQ(sqlite3_exec(file, sql, nullptr, nullptr, nullptr), SQLITE_OK);
    sqlite3_close(file);
  }
  open_again();
  const ValvePage page = *store().valves(10, 0);
  ASSERT_EQ(page.valves.size(), 2u);
  EXPECT_EQ(page.valves[1].vertices, 3);
  keep(1);
}

TEST_F(JobStoreLists, AKeptPlanComesBackByteForByteAfterOpeningAgain) {
  const KeptPlan plan = {"i" + all_bytes(), "n" + all_bytes(), "v" + all_bytes(), all_bytes(9'000)};
  ASSERT_TRUE(*store().keep_plan(plan, 1));
  open_again();
  const KeptPlan found = **store().kept_plan(plan.id);
  EXPECT_EQ(found.id, plan.id);
  EXPECT_EQ(found.name, plan.name);
  EXPECT_EQ(found.valve, plan.valve);
  EXPECT_EQ(found.plan, plan.plan);
  EXPECT_FALSE(*store().kept_plan("another"));
}

TEST_F(JobStoreLists, KeptPlansAreListedNewestFirstAllOrThoseOfAValve) {
  for (int i = 1; i <= 5; ++i) keep(i, i % 2 == 0 ? "even" : "odd");
  const KeptPlanPage page = *store().kept_plans(2, 0, "");
  EXPECT_EQ(kept_names(2, 0), (std::vector<std::string>{"Plan 5", "Plan 4"}));
  EXPECT_EQ(kept_names(9, page.next_before),
            (std::vector<std::string>{"Plan 3", "Plan 2", "Plan 1"}));
  EXPECT_EQ(kept_names(9, 0, "even"), (std::vector<std::string>{"Plan 4", "Plan 2"}));
  EXPECT_EQ(store().kept_plans(5, 0, "")->next_before, 0);
}

TEST_F(JobStoreLists, AKeptPlanIsRenamedAndRemovedOnce) {
  keep(1);
  EXPECT_TRUE(*store().rename_kept_plan("k1", "Better"));
  EXPECT_EQ((*store().kept_plan("k1"))->name, "Better");
  EXPECT_TRUE(*store().remove_kept_plan("k1"));
  EXPECT_FALSE(*store().remove_kept_plan("k1"));
  EXPECT_FALSE(*store().rename_kept_plan("k1", "Better"));
}

TEST_F(JobStoreLists, NoMorePlansAreKeptThanAreAllowed) {
  EXPECT_TRUE(*store().keep_plan({"a", "", "", ""}, 1));
  EXPECT_FALSE(*store().keep_plan({"b", "", "", ""}, 1));
  EXPECT_TRUE(*store().remove_kept_plan("a"));
  EXPECT_TRUE(*store().keep_plan({"b", "", "", ""}, 1));
}

TEST_F(JobStoreLists, AValveStaysAsLongAsAKeptPlanRefersToIt) {
  ASSERT_TRUE(store().add_valve("v", kDocument));
  keep(1);
  expect_bad_reference(store().remove_valve("v").errors());
  EXPECT_TRUE(*store().remove_kept_plan("k1"));
  EXPECT_TRUE(*store().remove_valve("v"));
}

}  // namespace
}  // namespace coapt
