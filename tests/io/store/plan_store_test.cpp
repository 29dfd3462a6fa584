#include "io/store/plan_store.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <limits>
#include <utility>

#include "tests/io/store/plan_scene.h"
#include "tests/io/store/store_scene.h"

namespace coapt {
namespace {

const std::string kPlan = "ring physio 28.000000 2; suture anterolateral trigone 31.500000";

TEST(PlanStore, GivesBackWhatItKeptBitForBit) {
  using Limits = std::numeric_limits<double>;
  const TemporaryFolder folder;
  Expected<PlanStore> store = PlanStore::open(folder.file("a.db"));
  ASSERT_TRUE(store);
  const std::vector<double> values = {0.0,
                                      -0.0,
                                      1.0,
                                      -3.0,
                                      0.1,
                                      4503599627370497.0,
                                      1e300,
                                      Limits::denorm_min(),
                                      -Limits::min() / 2,
                                      Limits::min(),
                                      Limits::max(),
                                      Limits::infinity(),
                                      -Limits::infinity(),
                                      std::nextafter(1.0, 2.0)};
  PlanClosures kept;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto value = [&](std::size_t shift) { return values[(i + shift) % values.size()]; };
    kept[static_cast<int>(i)] = {.status = static_cast<ClosureStatus>(i % 3),
                                 .crossing = i % 2 == 0,
                                 .leak_mm2 = value(0),
                                 .coaptation_mm = value(2),
                                 .distance_max_mm = value(3),
                                 .tension_max_n = value(4)};
  }
  for (const auto& [disturbance, closure] : kept)
    EXPECT_TRUE(store->keep(kSubject, kPlan, disturbance, closure).empty());
  const Expected<KnownPlans> known = store->read(kSubject);
  ASSERT_TRUE(known);
  ASSERT_EQ(known->size(), 1u);
  ASSERT_EQ(known->at(kPlan).size(), values.size());
  for (const auto& [disturbance, closure] : kept)
    expect_same(known->at(kPlan).at(disturbance), closure);
}

TEST(PlanStore, KeepsWhatCannotBeMeasuredAsNaN) {
  const TemporaryFolder folder;
  Expected<PlanStore> store = PlanStore::open(folder.file("a.db"));
  ASSERT_TRUE(store);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(store->keep(kSubject, kPlan, 0, {.leak_mm2 = nan, .coaptation_mm = 2.0}).empty());
  EXPECT_TRUE(store->keep(kSubject, kPlan, 1, {.leak_mm2 = 1.0, .tension_max_n = nan}).empty());
  const Expected<KnownPlans> known = store->read(kSubject);
  ASSERT_TRUE(known);
  EXPECT_TRUE(std::isnan(known->at(kPlan).at(0).leak_mm2));
  EXPECT_EQ(known->at(kPlan).at(0).coaptation_mm, 2.0);
  EXPECT_EQ(known->at(kPlan).at(1).leak_mm2, 1.0);
  EXPECT_TRUE(std::isnan(known->at(kPlan).at(1).tension_max_n));
}

TEST(PlanStore, TellsPlansApartByEveryByteAndKnowsThePlanWithoutSteps) {
  using namespace std::string_literals;
  const TemporaryFolder folder;
  Expected<PlanStore> store = PlanStore::open(folder.file("a.db"));
  ASSERT_TRUE(store);
  const std::vector<std::string> plans = {"",
                                          " ",
                                          "a",
                                          "A",
                                          "a ",
                                          "a\0b"s,
                                          "a\0c"s,
                                          "1",
                                          "1.0",
                                          "01",
                                          "it's",
                                          "\"; --",
                                          "\xff",
                                          "\xfe",
                                          "K\xc3\xb6nig",
                                          "NULL",
                                          std::string(100'000, 'x')};
  for (std::size_t i = 0; i < plans.size(); ++i) {
    const double area_mm2 = static_cast<double>(i);
    EXPECT_TRUE(store->keep(kSubject, plans[i], -1, {.leak_mm2 = area_mm2}).empty());
  }
  const Expected<KnownPlans> known = store->read(kSubject);
  ASSERT_TRUE(known);
  ASSERT_EQ(known->size(), plans.size());
  for (std::size_t i = 0; i < plans.size(); ++i)
    EXPECT_EQ(known->at(plans[i]).at(-1).leak_mm2, static_cast<double>(i)) << plans[i];
}

TEST(PlanStore, TheFirstAnswerStays) {
  const TemporaryFolder folder;
  Expected<PlanStore> store = PlanStore::open(folder.file("a.db"));
  ASSERT_TRUE(store);
  EXPECT_TRUE(store->keep(kSubject, kPlan, 3, numbered_closure(1)).empty());
  EXPECT_TRUE(store->keep(kSubject, kPlan, 3, numbered_closure(2)).empty());
  const Expected<KnownPlans> known = store->read(kSubject);
  ASSERT_TRUE(known);
  ASSERT_EQ(closures_in(*known), 1);
  expect_same(known->at(kPlan).at(3), numbered_closure(1));
}

TEST(PlanStore, TwoSubjectsWithOnePlanDoNotSeeEachOther) {
  const TemporaryFolder folder;
  Expected<PlanStore> store = PlanStore::open(folder.file("a.db"));
  ASSERT_TRUE(store);
  EXPECT_TRUE(store->keep("a", kPlan, 0, numbered_closure(1)).empty());
  EXPECT_TRUE(store->keep("b", kPlan, 0, numbered_closure(2)).empty());
  EXPECT_TRUE(store->keep("b", kPlan, 1, numbered_closure(3)).empty());
  const Expected<KnownPlans> a = store->read("a"), b = store->read("b"), c = store->read("c");
  ASSERT_TRUE(a && b && c);
  EXPECT_EQ(closures_in(*a), 1);
  expect_same(a->at(kPlan).at(0), numbered_closure(1));
  EXPECT_EQ(closures_in(*b), 2);
  expect_same(b->at(kPlan).at(0), numbered_closure(2));
  EXPECT_TRUE(c->empty());
}

TEST(PlanStore, RefusesAStatusThatIsNone) {
  const TemporaryFolder folder;
  Expected<PlanStore> store = PlanStore::open(folder.file("a.db"));
  ASSERT_TRUE(store);
  const Errors errors = store->keep(kSubject, kPlan, 0, {.status = static_cast<ClosureStatus>(3)});
  ASSERT_EQ(errors.size(), 1u);
  EXPECT_EQ(errors[0].code, ErrorCode::InputOutput);
  EXPECT_TRUE(store->read(kSubject)->empty());
}

TEST(PlanStore, KeepsAllWhenMovedClosedAndOpenedAgain) {
  const TemporaryFolder folder;
  const std::string path = folder.file("100% #1?.db");
  for (int round = 0; round < 3; ++round) {
    Expected<PlanStore> opened = PlanStore::open(path);
    ASSERT_TRUE(opened);
    PlanStore store = *std::move(opened);
    for (const int i : {round, 100 + round}) EXPECT_TRUE(keep_numbered(store, kSubject, i).empty());
    const Expected<KnownPlans> known = store.read(kSubject);
    ASSERT_TRUE(known);
    ASSERT_EQ(closures_in(*known), 2 * (round + 1));
    for (int i = 0; i <= round; ++i)
      expect_same(known->at(numbered_plan(i)).at(numbered_disturbance(i)), numbered_closure(i));
  }
  EXPECT_FALSE(std::filesystem::exists(path + "-wal"));
}

TEST(PlanStore, TwoStoresShareAFileAndItsPlans) {
  const TemporaryFolder folder;
  Expected<PlanStore> a = PlanStore::open(folder.file("a.db"));
  Expected<PlanStore> b = PlanStore::open(folder.file("a.db"));
  ASSERT_TRUE(a && b);
  EXPECT_TRUE(a->keep(kSubject, kPlan, 0, numbered_closure(1)).empty());
  EXPECT_TRUE(b->keep(kSubject, "another", 0, numbered_closure(2)).empty());
  EXPECT_TRUE(b->keep(kSubject, kPlan, 0, numbered_closure(3)).empty());
  EXPECT_TRUE(a->keep(kSubject, "another", 1, numbered_closure(4)).empty());
  const Expected<KnownPlans> known = b->read(kSubject);
  ASSERT_TRUE(known);
  EXPECT_EQ(closures_in(*known), 3);
  expect_same(known->at(kPlan).at(0), numbered_closure(1));
  expect_same(known->at("another").at(0), numbered_closure(2));
  expect_same(known->at("another").at(1), numbered_closure(4));
}

}  // namespace
}  // namespace coapt
