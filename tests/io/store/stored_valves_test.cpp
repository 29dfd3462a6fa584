#include "io/store/stored_valves.h"

#include <sqlite3.h>

#include "io/store/kept_plans.h"
#include "tests/io/store/job_scene.h"

namespace coapt {
namespace {

using StoredValves = JobStoreTest;

constexpr const char* kDocument =
    R"({"name": "Mrs \"A\"", "vertices_mm": [[0,0,0],[1,0,0],[0,1,0]], "faces": [[0,1,2]]})";

TEST_F(StoredValves, ValvesAreListedNewestFirstWithNameAndSize) {
  EXPECT_TRUE(stored_valves(store(), 10, 0)->valves.empty());
  ASSERT_TRUE(add_valve(store(), "a", kDocument));
  submit(store(), 0);
  const ValvePage first = *stored_valves(store(), 1, 0);
  ASSERT_EQ(first.valves.size(), 1u);
  EXPECT_EQ(first.valves[0].id, numbered_job(0).valve);
  EXPECT_EQ(first.valves[0].name, "");
  const ValvePage rest = *stored_valves(store(), 1, first.next_before);
  ASSERT_EQ(rest.valves.size(), 1u);
  EXPECT_EQ(rest.next_before, 0);
  EXPECT_EQ(rest.valves[0].id, "a");
  EXPECT_EQ(rest.valves[0].name, "Mrs \"A\"");
  EXPECT_EQ(rest.valves[0].vertices, 3);
  EXPECT_EQ(rest.valves[0].triangles, 1);
  EXPECT_TRUE(*remove_valve(store(), "a"));
  EXPECT_EQ(stored_valves(store(), 10, 0)->valves.size(), 1u);
}

TEST_F(StoredValves, WhatIsNoValveIsListedWithoutNameAndSize) {
  for (const char* document : {"", "[1", "7", "{\"name\": 5}", "\x01\x02"})
    ASSERT_TRUE(add_valve(store(), std::string("of ") + document, document)) << document;
  EXPECT_EQ(stored_valves(store(), 10, 0)->valves.size(), 5u);
}

TEST_F(StoredValves, AFileOfAnEarlierVersionGetsItsListsWhenItIsOpened) {
  ASSERT_TRUE(add_valve(store(), "a", kDocument));
  submit(store(), 0);
  for (const char* sql : {"DROP TABLE valve_summaries", "DROP TABLE kept_plans"}) {
    sqlite3* file = nullptr;
    ASSERT_EQ(sqlite3_open(path_.c_str(), &file), SQLITE_OK);
    EXPECT_EQ(sqlite3_exec(file, sql, nullptr, nullptr, nullptr), SQLITE_OK);
    sqlite3_close(file);
  }
  open_again();
  const ValvePage page = *stored_valves(store(), 10, 0);
  ASSERT_EQ(page.valves.size(), 2u);
  EXPECT_EQ(page.valves[1].vertices, 3);
  EXPECT_TRUE(*keep_plan(store(), {"k1", "Plan 1", "v", "{}"}, 1));
}

}  // namespace
}  // namespace coapt
