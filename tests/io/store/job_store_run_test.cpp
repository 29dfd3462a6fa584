// What happens to a job in its store: from its start to its end, and its removal.
#include <gtest/gtest.h>

#include "io/store/job_store.h"
#include "io/store/kept_plans.h"
#include "io/store/stored_valves.h"
#include "tests/io/store/job_scene.h"

namespace coapt {
namespace {

TEST_F(JobStoreRun, CountsAttemptsThatWereKilledWithoutHavingKeptAnything) {
  submit(store(), 1);
  const auto stalled = [this](std::int64_t kept, std::int64_t now_ms) {
    const Expected<int> started = store().start(numbered_id(1), kept, now_ms);
    EXPECT_EQ(*started, job(1).stalled);
    EXPECT_EQ(job(1).state, JobState::Running);
    EXPECT_EQ(job(1).kept, kept);
    EXPECT_EQ(job(1).started_ms, 10);
    return job(1).stalled;
  };
  EXPECT_EQ(stalled(0, 10), 0);
  EXPECT_EQ(stalled(0, 20), 1);
  EXPECT_EQ(stalled(0, 30), 2);
  EXPECT_EQ(stalled(40, 40), 0);
  EXPECT_EQ(stalled(40, 50), 1);
  EXPECT_TRUE(store().suspend(numbered_id(1), 2.5, "{}").empty());
  EXPECT_EQ(job(1).state, JobState::Queued);
  EXPECT_EQ(job(1).stalled, 0);
  EXPECT_EQ(job(1).seconds, 2.5);
  EXPECT_EQ(stalled(40, 60), 0);
  EXPECT_EQ(stalled(40, 70), 1);
}

TEST_F(JobStoreRun, SuspendsOnlyWhatRuns) {
  submit(store(), 1);
  EXPECT_TRUE(store().suspend(numbered_id(1), 2.5, "{}").empty());
  EXPECT_EQ(job(1).seconds, 0.0);
  EXPECT_TRUE(store().start(numbered_id(1), 0, 10));
  EXPECT_TRUE(store().suspend(numbered_id(1), 2.5, "{}").empty());
  EXPECT_TRUE(store().start(numbered_id(1), 0, 10));
  EXPECT_TRUE(store().suspend(numbered_id(1), 3.5, "").empty());
  EXPECT_EQ(job(1).seconds, 3.5);
  EXPECT_EQ(job(1).progress, "{}");
}

TEST_F(JobStoreRun, KeepsAnEndWholeAndOnce) {
  for (int i = 0; i < 3; ++i) {
    submit(store(), i);
    EXPECT_TRUE(store().request_cancel(numbered_id(i)).empty());
    EXPECT_TRUE(job(i).cancel_requested);
    EXPECT_TRUE(store().finish(numbered_id(i), numbered_end(i), 77).empty());
    EXPECT_TRUE(store().finish(numbered_id(i), numbered_end(i + 1), 78).empty());
    EXPECT_TRUE(store().suspend(numbered_id(i), 5e3, "late").empty());
    expect_bad_reference(store().start(numbered_id(i), 3, 79).errors());
  }
  open_again();
  for (int i = 0; i < 3; ++i) {
    expect_ended(store(), i);
    EXPECT_EQ(job(i).finished_ms, 77);
  }
}

TEST_F(JobStoreRun, ACancelAfterTheEndChangesNothing) {
  submit(store(), 1);
  EXPECT_TRUE(store().finish(numbered_id(1), numbered_end(1), 77).empty());
  EXPECT_TRUE(store().request_cancel(numbered_id(1)).empty());
  EXPECT_FALSE(job(1).cancel_requested);
}

TEST_F(JobStoreRun, AnEndWithTwoFilesOfOneNameIsRefusedWhole) {
  submit(store(), 1);
  JobEnd end = numbered_end(1);
  end.files.push_back(end.files[0]);
  EXPECT_FALSE(store().finish(numbered_id(1), end, 77).empty());
  EXPECT_EQ(job(1).state, JobState::Queued);
  EXPECT_FALSE(*store().result(numbered_id(1)));
  EXPECT_TRUE(store().files(numbered_id(1))->empty());
}

TEST_F(JobStoreRun, WithoutResultOrFilesThereAreNone) {
  submit(store(), 1);
  EXPECT_FALSE(*store().result(numbered_id(1)));
  EXPECT_TRUE(store().finish(numbered_id(1), {.state = JobState::Failed}, 77).empty());
  EXPECT_FALSE(*store().result(numbered_id(1)));
  EXPECT_TRUE(store().files(numbered_id(1))->empty());
  EXPECT_FALSE(*store().file(numbered_id(1), "report.html"));
}

TEST_F(JobStoreRun, NumbersTheEventsOfEachJobFromOne) {
  for (const int i : {1, 2}) submit(store(), i);
  for (int event = 1; event <= 30; ++event) {
    EXPECT_EQ(*store().add_event(numbered_id(1), "progress", numbered_event(event), event / 2.0),
              event + 1);  // after that it is QUEUED
  }
  EXPECT_EQ(*store().add_event(numbered_id(2), "note", all_bytes(), 99.0), 2);
  const auto some = store().events(numbered_id(1), 13, 5);
  ASSERT_EQ(some->size(), 5u);
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_EQ((*some)[i].number, 14 + static_cast<int>(i));
    EXPECT_EQ((*some)[i].kind, "progress");
    EXPECT_EQ((*some)[i].content, numbered_event(13 + static_cast<int>(i)));
  }
  EXPECT_EQ(store().events(numbered_id(1), 0, 3'000)->size(), 31u);
  EXPECT_TRUE(store().events(numbered_id(1), 31, 5)->empty());
  EXPECT_TRUE(store().events("another", 0, 5)->empty());
  EXPECT_EQ(store().events(numbered_id(2), 1, 5)->at(0).content, all_bytes());
  EXPECT_EQ(job(1).progress, numbered_event(30));
  EXPECT_EQ(job(1).seconds, 15.0);
  EXPECT_EQ(job(2).progress, "");
  EXPECT_EQ(job(2).seconds, 0.0);
}

TEST_F(JobStoreRun, TellsEveryChangeOfStateWithTheChangeItself) {
  submit(store(), 1);
  EXPECT_TRUE(store().start(numbered_id(1), 0, 10));
  EXPECT_TRUE(store().suspend(numbered_id(1), 1.0, "").empty());
  EXPECT_TRUE(store().start(numbered_id(1), 0, 10));
  EXPECT_TRUE(store().finish(numbered_id(1), {.state = JobState::Failed}, 77).empty());
  EXPECT_TRUE(store().finish(numbered_id(1), {.state = JobState::Failed}, 78).empty());
  std::string told;
  for (const JobEvent& event : events_of(store(), numbered_id(1), "state")) told += event.content;
  EXPECT_EQ(told,
            R"({"state": "QUEUED"}{"state": "RUNNING"}{"state": "QUEUED"}{"state": "RUNNING"})"
            R"({"state": "FAILED"})");
}

TEST_F(JobStoreRun, AnIdempotencyKeyFindsItsJob) {
  for (int i = 0; i < 3; ++i) submit(store(), i);
  EXPECT_EQ((**store().job_of_key("key-2")).id, numbered_id(2));
  EXPECT_FALSE(*store().job_of_key("key-3"));
  EXPECT_FALSE(*store().job_of_key(""));
}

TEST_F(JobStoreRun, ProgressThatComesAfterTheEndLeavesTheJobAsItIs) {
  submit(store(), 1);
  EXPECT_TRUE(store().finish(numbered_id(1), numbered_end(1), 77).empty());
  EXPECT_EQ(*store().add_event(numbered_id(1), "progress", "late", 99.0), 3);
  expect_ended(store(), 1);
}

TEST_F(JobStoreRun, AJobGoesWithAllThatBelongsToItAndItsNumberIsNotGivenAgain) {
  for (const int i : {1, 2}) submit(store(), i);
  EXPECT_TRUE(store().add_event(numbered_id(2), "state", "{}", 0.0));
  const auto early = store().remove(numbered_id(2));
  ASSERT_FALSE(early);
  expect_bad_reference(early.errors());
  EXPECT_TRUE(store().finish(numbered_id(2), numbered_end(2), 77).empty());
  EXPECT_TRUE(*store().remove(numbered_id(2)));
  EXPECT_FALSE(*store().remove(numbered_id(2)));
  EXPECT_FALSE(*store().job(numbered_id(2)));
  EXPECT_FALSE(*store().result(numbered_id(2)));
  EXPECT_FALSE(*store().file(numbered_id(2), "report.html"));
  EXPECT_FALSE(*store().material(numbered_id(2)));

  submit(store(), 2);  // its idempotency key is free, too
  EXPECT_EQ(job(2).number, 3);
  EXPECT_EQ(store().events(numbered_id(2), 0, 5)->size(), 1u);
  EXPECT_TRUE(store().files(numbered_id(2))->empty());
}

TEST_F(JobStoreRun, TheNewestEndedJobsStay) {
  for (const int i : {1, 2, 3, 4, 5}) submit(store(), i);
  for (const int i : {1, 3, 4, 5})
    EXPECT_TRUE(store().finish(numbered_id(i), numbered_end(i), 1'000).empty());
  EXPECT_TRUE(store().retain({.jobs = 2}, 1'000).empty());
  for (const int i : {1, 3}) EXPECT_FALSE(*store().job(numbered_id(i))) << i;
  for (const int i : {2, 4, 5}) EXPECT_TRUE(*store().job(numbered_id(i))) << i;
}

TEST_F(JobStoreRun, EndedJobsStayAsLongAsAsked) {
  constexpr std::int64_t kDay_ms = 24 * 3600 * 1000;
  for (const int i : {1, 2, 3}) submit(store(), i);
  for (const int i : {1, 2})
    EXPECT_TRUE(store().finish(numbered_id(i), numbered_end(i), i * kDay_ms).empty());
  EXPECT_TRUE(store().retain({}, 9 * kDay_ms).empty());
  EXPECT_TRUE(*store().job(numbered_id(1)));
  EXPECT_TRUE(store().retain({.days = 7.5}, 9 * kDay_ms).empty());
  EXPECT_FALSE(*store().job(numbered_id(1)));
  for (const int i : {2, 3}) EXPECT_TRUE(*store().job(numbered_id(i))) << i;
}

TEST_F(JobStoreRun, ValvesThatNothingRefersToGoTheOldestFirst) {
  submit(store(), 1);  // valve-0
  for (const char* id : {"a", "b", "c", "d"}) EXPECT_TRUE(*add_valve(store(), id, "{}"));
  EXPECT_TRUE(*keep_plan(store(), {"kept", "a plan", "a", "{}"}, 9));
  EXPECT_TRUE(store().retain({.valves = 2}, 1).empty());
  EXPECT_FALSE(*stored_valve(store(), "b"));
  for (const char* id : {"valve-0", "a", "c", "d"}) EXPECT_TRUE(*stored_valve(store(), id)) << id;
}

TEST_F(JobStoreRun, WhatIsAskedOfAJobThatIsNotThereIsABadReference) {
  expect_bad_reference(store().start("none", 0, 1).errors());
  expect_bad_reference(store().suspend("none", 0.0, ""));
  expect_bad_reference(store().request_cancel("none"));
  expect_bad_reference(store().finish("none", numbered_end(0), 1));
  expect_bad_reference(store().add_event("none", "state", "{}", 0.0).errors());
  EXPECT_TRUE(*store().job("none") == std::nullopt);
}

TEST_F(JobStoreTest, KeepsWhatAJobWorksFromUntilItHasEnded) {
  NewJob job = numbered_job(1);
  job.input = all_bytes(100'000);
  ASSERT_TRUE(store().submit(job, "{}", 5));
  submit(store(), 2);
  EXPECT_FALSE(*store().state(job.id));
  EXPECT_TRUE(store().keep_state(job.id, "round 1").empty());
  EXPECT_TRUE(store().keep_state(job.id, all_bytes()).empty());
  open_again();
  EXPECT_EQ(**store().input(job.id), all_bytes(100'000));
  EXPECT_EQ(**store().state(job.id), all_bytes());
  EXPECT_FALSE(*store().input(numbered_id(2)));
  ASSERT_TRUE(store().finish(job.id, {.state = JobState::Succeeded}, 6).empty());
  EXPECT_FALSE(*store().input(job.id));
  EXPECT_FALSE(*store().state(job.id));
  EXPECT_TRUE(store().keep_state(job.id, "late").empty());
  EXPECT_FALSE(*store().state(job.id));
}

}  // namespace
}  // namespace coapt
