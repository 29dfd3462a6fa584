#include "server/jobs/job_runner.h"

#include <atomic>
#include <stdexcept>

#include "tests/server/jobs/board_scene.h"

namespace coapt {
namespace {

/// Runs what `work` says until the test is over.
class Running {
 public:
  Running(JobBoard& board, JobWork work, int threads = 1)
      : board_(board), runner_(board, {{"work", std::move(work)}}, threads) {}
  ~Running() { board_.stop(); }

 private:
  JobBoard& board_;
  JobRunner runner_;
};

std::optional<JobEnd> succeed(RunningJob& job) {
  JobEnd end = ended(job, JobState::Succeeded);
  end.result = "{\"answer\": 42}";
  end.files = {{"a.txt", "text/plain", "a"}};
  return end;
}

class Runner : public BoardTest {
 protected:
  bool ends(const std::string& id) {
    return comes_true([&] { return has_ended(state(id)); });
  }
};

TEST_F(Runner, KeepsTheEndOfAJobWithItsResultAndFiles) {
  const Running running(board(), succeed);
  submit("a");
  ASSERT_TRUE(ends("a"));
  EXPECT_EQ(state("a"), JobState::Succeeded);
  EXPECT_EQ(**store().result("a"), "{\"answer\": 42}");
  EXPECT_EQ((*store().file("a", "a.txt"))->content, "a");
  EXPECT_EQ(events("a").back(), R"(state {"state": "SUCCEEDED"})");
}

TEST_F(Runner, TellsOfEachJobWhoseEndIsKept) {
  std::atomic<int> told = 0;
  JobRunner runner(board(), {{"work", succeed}}, 1, [&](const Job& job) {
    EXPECT_EQ(state(job.id), JobState::Succeeded);
    ++told;
  });
  submit("a");
  submit("b");
  EXPECT_TRUE(comes_true([&] { return told == 2; }));
  board().stop();
}

TEST_F(Runner, AJobThatThrowsHasFailedAndSaysWhy) {
  const Running running(board(), [](RunningJob&) -> std::optional<JobEnd> {
    throw std::runtime_error("the valve fell off");
  });
  submit("a");
  ASSERT_TRUE(ends("a"));
  EXPECT_EQ(state("a"), JobState::Failed);
  EXPECT_NE(view("a").job.summary.find("the valve fell off"), std::string::npos);
}

TEST_F(Runner, AKindOfJobThatNobodyKnowsFails) {
  const Running running(board(), succeed);
  ASSERT_TRUE(board().submit({"b", "dance", "valve", "{}", ""}, "{}"));
  ASSERT_TRUE(ends("b"));
  EXPECT_EQ(state("b"), JobState::Failed);
}

TEST_F(Runner, TellsProgressWhileAJobRuns) {
  const Running running(board(), [&](RunningJob& job) -> std::optional<JobEnd> {
    int stalled = 0;
    board().start(job, 0, stalled);
    for (int i = 1; !job.cancelled; ++i) {
      job.note({"working", i, 100, 1.0 / i});
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return ended(job, JobState::Cancelled);
  });
  submit("a");
  ASSERT_TRUE(comes_true([&] { return events("a").size() >= 5; }));
  EXPECT_EQ(events("a")[1], R"(state {"state": "RUNNING"})");
  EXPECT_TRUE(events("a")[2].starts_with("progress {\"stage\":\"working\",\"closures\":"));
  EXPECT_TRUE(*board().cancel("a"));
  ASSERT_TRUE(ends("a"));
  EXPECT_EQ(state("a"), JobState::Cancelled);
}

TEST_F(Runner, AJobWithoutAnEndWaitsForTheNextServer) {
  {
    const Running running(board(), [&](RunningJob& job) -> std::optional<JobEnd> {
      int stalled = 0;
      board().start(job, 0, stalled);
      while (!job.cancelled) std::this_thread::sleep_for(std::chrono::milliseconds(1));
      throw std::runtime_error("the server stops");
    });
    submit("a");
    ASSERT_TRUE(comes_true([&] { return state("a") == JobState::Running; }));
  }
  EXPECT_EQ(state("a"), JobState::Queued);
  open();
  const Running running(board(), succeed);
  EXPECT_TRUE(ends("a"));
}

TEST_F(Runner, ManyClientsAndRunnersLoseNoJob) {
  constexpr int kClients = 6, kEach = 20;
  const Running running(board(), succeed, 3);
  std::vector<std::thread> clients;
  for (int c = 0; c < kClients; ++c)
    clients.emplace_back([&, c] {
      for (int i = 0; i < kEach; ++i) {
        const std::string id = std::to_string(c) + '-' + std::to_string(i);
        while (submit(id).taken == JobBoard::Taken::QueueFull)
          std::this_thread::sleep_for(std::chrono::milliseconds(1));
        if (i % 4 == 1) {
          EXPECT_TRUE(*board().cancel(id));
        }
        if (i % 4 == 2) view(id);
        if (i % 4 == 3) board().wait_until_ended(id, std::chrono::milliseconds(50));
      }
    });
  for (std::thread& client : clients) client.join();
  ASSERT_TRUE(comes_true([&] { return store().unfinished()->empty(); }));
  EXPECT_EQ(*store().count(JobState::Succeeded) + *store().count(JobState::Cancelled),
            kClients * kEach);
  EXPECT_TRUE(comes_true([&] { return board().load().running == 0; })) << "after it was stored";
}

}  // namespace
}  // namespace coapt
