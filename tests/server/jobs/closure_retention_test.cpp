#include "server/jobs/closure_retention.h"

#include "io/json/search_options_json.h"
#include "io/json/subject.h"
#include "io/store/closure_store.h"
#include "io/store/plan_store.h"
#include "tests/io/store/plan_scene.h"
#include "tests/server/endpoints/service_scene.h"

namespace coapt {
namespace {

class ClosureRetentionTest : public ServiceTest {
 protected:
  void keep(const std::string& subject, int closures) {
    Expected<PlanStore> plans = PlanStore::open(plans_);
    Expected<ClosureStore> studies = ClosureStore::open(studies_);
    for (int i = 0; i < closures; ++i) {
      EXPECT_TRUE(keep_numbered(*plans, subject, i).empty());
      EXPECT_TRUE(studies->keep(subject, numbered_key(i), numbered_sample(i)).empty());
    }
  }
  int of_plans(const std::string& subject) {
    return closures_in(*PlanStore::open(plans_)->read(subject));
  }
  int of_studies(const std::string& subject) {
    return static_cast<int>(ClosureStore::open(studies_)->read(subject)->size());
  }
  ClosureRetention retention(const Retention& limits) {
    return {store(), limits, plans_, studies_};
  }

  const std::string searched_ = plan_subject_of(small_valve(), SearchOptions{}.closure);
  const std::string studied_ = subject_of(small_valve(), ClosureOptions{});

 private:
  const TemporaryFolder folder_{memory_folder()};
  const std::string plans_ = folder_.file("plans"), studies_ = folder_.file("studies");
};

TEST_F(ClosureRetentionTest, ClosuresOfJobsThatHaveNotEndedStay) {
  for (const std::string& subject : {searched_, studied_, std::string("other")}) keep(subject, 10);
  queued_job("a", "plans");
  EXPECT_TRUE(retention({.closures = 1})(0).empty());
  EXPECT_EQ(of_plans(searched_), 10);
  EXPECT_EQ(of_plans("other"), 0);
  EXPECT_EQ(of_studies(studied_), 0);

  finish_next({});
  keep(studied_, 10);
  queued_job("b", "study");
  EXPECT_TRUE(retention({.closures = 1})(0).empty());
  EXPECT_EQ(of_plans(searched_), 0);
  EXPECT_EQ(of_studies(studied_), 10);
}

TEST_F(ClosureRetentionTest, WhatAJobHasUsedGoesLast) {
  for (const std::string& subject : {searched_, std::string("other")}) keep(subject, 10);
  queued_job("a", "plans");
  finish_next({});
  EXPECT_TRUE(retention({.closures = 15})(**store().job("a"), 0).empty());
  EXPECT_EQ(of_plans(searched_), 10);
  EXPECT_EQ(of_plans("other"), 0);
}

TEST_F(ClosureRetentionTest, OldOnesGoWithTheirDays) {
  keep(searched_, 10);
  queued_job("a", "plans");
  finish_next({});
  constexpr std::int64_t kDay_ms = 24 * 3600 * 1000;
  EXPECT_TRUE(retention({.days = 1.0})(**store().job("a"), 0).empty());
  EXPECT_TRUE(retention({.days = 1.0})(kDay_ms).empty());
  EXPECT_EQ(of_plans(searched_), 10);
  EXPECT_TRUE(retention({.days = 1.0})(kDay_ms + 1).empty());
  EXPECT_EQ(of_plans(searched_), 0);
}

}  // namespace
}  // namespace coapt
