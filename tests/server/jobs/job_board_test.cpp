#include "server/jobs/job_board.h"

#include <latch>

#include "tests/server/jobs/board_scene.h"

namespace coapt {
namespace {

using Taken = JobBoard::Taken;

TEST_F(BoardTest, JobsAreTakenInTheOrderOfSubmission) {
  submit("a");
  submit("b");
  EXPECT_EQ(view("a").queue_position, 0);
  EXPECT_EQ(view("b").queue_position, 1);
  EXPECT_EQ(board().take()->job.id, "a");
  EXPECT_EQ(view("a").queue_position, std::nullopt);
  EXPECT_EQ(view("b").queue_position, 0);
  EXPECT_EQ(board().take()->job.id, "b");
  EXPECT_EQ(board().load().running, 2);
}

TEST_F(BoardTest, AFullQueueTakesNoMoreUntilAJobIsTaken) {
  for (const char* id : {"a", "b", "c"}) EXPECT_EQ(submit(id).taken, Taken::New);
  EXPECT_EQ(submit("d").taken, Taken::QueueFull);
  EXPECT_FALSE(store().job("d")->has_value());
  board().take();
  EXPECT_EQ(submit("d").taken, Taken::New);
}

TEST_F(BoardTest, AnIdempotencyKeyGivesTheSameJobAlsoWhenTheQueueIsFullAndRefusesAnotherRequest) {
  submit("a", "key");
  submit("b");
  submit("c");
  const JobBoard::Submission again = submit("d", "key");
  EXPECT_EQ(again.taken, Taken::Known);
  EXPECT_EQ(again.job.id, "a");
  EXPECT_EQ(submit("e", "key", "{\"other\": 1}").taken, Taken::OtherRequest);
}

TEST_F(BoardTest, OfManyThreadsWithOneKeyOneMakesTheJob) {
  constexpr int kThreads = 8;
  std::vector<JobBoard::Submission> answers(kThreads);
  std::latch together(kThreads);
  std::vector<std::thread> threads;
  for (int i = 0; i < kThreads; ++i)
    threads.emplace_back([&, i] {
      together.arrive_and_wait();
      answers[static_cast<std::size_t>(i)] = submit("job-" + std::to_string(i), "key");
    });
  for (std::thread& thread : threads) thread.join();
  int made = 0;
  for (const JobBoard::Submission& answer : answers) {
    made += answer.taken == Taken::New;
    EXPECT_EQ(answer.job.id, answers[0].job.id);
  }
  EXPECT_EQ(made, 1);
}

TEST_F(BoardTest, AWaitingJobIsCancelledAtOnceAndNeverTaken) {
  submit("a");
  submit("b");
  EXPECT_TRUE(*board().cancel("a"));
  EXPECT_EQ(state("a"), JobState::Cancelled);
  EXPECT_EQ(board().take()->job.id, "b");
  EXPECT_EQ(events("a"), (std::vector<std::string>{R"(state {"state": "QUEUED"})",
                                                   R"(state {"state": "CANCELLED"})"}));
}

TEST_F(BoardTest, ARunningJobIsToldThatItIsCancelled) {
  submit("a");
  const auto job = board().take();
  EXPECT_FALSE(job->cancelled);
  EXPECT_TRUE(*board().cancel("a"));
  EXPECT_TRUE(job->cancelled);
  EXPECT_TRUE(job->cancel_asked);
  EXPECT_TRUE(view("a").job.cancel_requested);
}

TEST_F(BoardTest, AnEndedJobStaysAsItIsAndAnUnknownOneIsNotCancelled) {
  submit("a");
  const auto job = board().take();
  EXPECT_TRUE(board().finish(job, ended(*job, JobState::Succeeded)));
  EXPECT_TRUE(*board().cancel("a"));
  EXPECT_EQ(state("a"), JobState::Succeeded);
  EXPECT_FALSE(*board().cancel("nobody"));
  EXPECT_FALSE(*board().find("nobody"));
}

TEST_F(BoardTest, WhatAStoppedServerLeavesTheNextOneTakesInOrder) {
  submit("a");
  submit("b");
  const auto job = board().take();
  int stalled = -1;
  EXPECT_TRUE(board().start(*job, 7, stalled));
  EXPECT_EQ(stalled, 0);
  EXPECT_EQ(state("a"), JobState::Running);
  board().stop();
  EXPECT_TRUE(job->cancelled);
  EXPECT_FALSE(job->cancel_asked);
  EXPECT_FALSE(board().finish(job, std::nullopt));
  EXPECT_EQ(state("a"), JobState::Queued);
  EXPECT_EQ(board().take(), nullptr);
  EXPECT_EQ(submit("c").taken, Taken::Stopping);
  open();
  EXPECT_EQ(board().take()->job.id, "a");
  EXPECT_EQ(board().take()->job.id, "b");
}

TEST_F(BoardTest, AJobThatKillsTheServerAgainAndAgainIsCounted) {
  submit("a");
  for (int attempt = 0; attempt < 3; ++attempt) {
    int stalled = -1;
    ASSERT_TRUE(board().start(*board().take(), 5, stalled));
    EXPECT_EQ(stalled, attempt);
    open();  // as after kill -9
  }
  int stalled = -1;
  ASSERT_TRUE(board().start(*board().take(), 6, stalled));  // something new was kept
  EXPECT_EQ(stalled, 0);
}

TEST_F(BoardTest, AKillFromOutsideIsBlamedOnNoneOfSeveralJobsAndAFaultOfTheServerOnAll) {
  submit("a");
  submit("b");
  const auto start_both = [this](int expected) {
    for (int i = 0; i < 2; ++i) {
      int stalled = -1;
      ASSERT_TRUE(board().start(*board().take(), 0, stalled));
      EXPECT_EQ(stalled, expected);
    }
  };
  start_both(0);
  open();
  start_both(0);
  open(/*crashed=*/true);
  start_both(1);
  open();
  start_both(0);
}

TEST_F(BoardTest, AViewOfARunningJobHasItsNewestProgressAndWhatItWaitsFor) {
  submit("a");
  EXPECT_TRUE(view("a").progress.is_null());
  const auto job = board().take();
  job->note({"searching", 12, 34, 5.5});
  job->wait_for("the disk");
  const JobView seen = view("a");
  EXPECT_EQ(seen.progress["stage"], "searching");
  EXPECT_EQ(seen.progress["closures"], 12);
  EXPECT_EQ(seen.progress["closures_planned"], 34);
  EXPECT_EQ(seen.progress["best_leak_mm2"], 5.5);
  EXPECT_EQ(seen.waiting_for, "the disk");
}

TEST_F(BoardTest, WhatCannotBeWrittenIsTriedAgainUntilItCanOrTheServerStops) {
  submit("a");
  const auto job = board().take();
  int tries = 0;
  EXPECT_TRUE(board().persist(*job, [&]() -> Errors {
    if (++tries < 2) return {Error{ErrorCode::NoSpace, "", "the disk is full"}};
    EXPECT_EQ(job->waiting_for(), "the disk is full");
    return {};
  }));
  EXPECT_EQ(tries, 2);
  EXPECT_EQ(job->waiting_for(), "");
  board().stop();
  EXPECT_FALSE(board().persist(*job, [] { return Errors{Error{ErrorCode::Busy, "", ""}}; }));
}

TEST_F(BoardTest, WhatWillNeverBeWrittenIsNotTriedAgain) {
  submit("a");
  const auto job = board().take();
  const auto refuse = [] { return Errors{Error{ErrorCode::Unsupported, "", "no store"}}; };
  EXPECT_THROW(board().persist(*job, refuse), std::runtime_error);
}

TEST_F(BoardTest, TimeThatAJobStandsStillIsNotOfItsRunning) {
  submit("a");
  const auto job = board().take();
  job->wait_for("the disk");
  std::this_thread::sleep_for(std::chrono::milliseconds(200));
  EXPECT_GE(job->waited_s(), 0.2);
  const double before = job->seconds();
  job->wait_for("");
  EXPECT_GE(job->waited_s(), 0.2);
  EXPECT_LT(before, job->waited_s() + job->seconds());
}

TEST_F(BoardTest, AJobThatWasStartedAndWaitsToGoOnIsCancelledWithItsBestWhenItRunsAgain) {
  submit("a");
  int stalled = 0;
  ASSERT_TRUE(board().start(*board().take(), 5, stalled));
  open();  // as after kill -9
  EXPECT_EQ(state("a"), JobState::Queued);
  EXPECT_TRUE(*board().cancel("a"));
  EXPECT_EQ(state("a"), JobState::Queued);
  EXPECT_TRUE(board().take()->job.cancel_requested);
}

TEST_F(BoardTest, WaitingForTheEndOfAJobTakesNoLongerThanAsked) {
  submit("a");
  EXPECT_FALSE(board().wait_until_ended("a", std::chrono::milliseconds(20)));
  const auto job = board().take();
  std::thread runner([&] { board().finish(job, ended(*job, JobState::Failed)); });
  EXPECT_TRUE(board().wait_until_ended("a", std::chrono::seconds(20)));
  runner.join();
  EXPECT_TRUE(board().wait_until_ended("a", std::chrono::seconds(20)));
}

}  // namespace
}  // namespace coapt
