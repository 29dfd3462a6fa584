// A board over a store that is made anew for each test.
#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <string>
#include <thread>

#include "server/jobs/job_runner.h"
#include "tests/io/store/store_scene.h"

namespace coapt {

class BoardTest : public testing::Test {
 protected:
  static constexpr int kQueue = 3;
  BoardTest() { open(); }

  /// As a server does that starts: with the jobs that an earlier one left, which was killed or `crashed`.
  void open(bool crashed = false) {
    board_.reset();
    store_.reset();
    Expected<JobStore> opened = JobStore::open(folder_.file("jobs.db"));
    ASSERT_TRUE(opened) << opened.errors()[0].message;
    store_ = std::make_unique<JobStore>(*std::move(opened));
    board_ = std::make_unique<JobBoard>(*store_, kQueue);
    ASSERT_TRUE(board_->resume(crashed).empty());
  }
  JobStore& store() { return *store_; }
  JobBoard& board() { return *board_; }

  JobBoard::Submission submit(const std::string& id, const std::string& key = "",
                              const std::string& request = "{}") {
    const auto submitted = board().submit({id, "work", "valve", request, key}, "{}");
    EXPECT_TRUE(submitted);
    return submitted ? *submitted : JobBoard::Submission{};
  }
  JobView view(const std::string& id) {
    const auto found = board().find(id);
    EXPECT_TRUE(found && *found) << id;
    return found && *found ? **found : JobView{};
  }
  JobState state(const std::string& id) { return view(id).job.state; }

  /// The kinds and contents of a job's events.
  std::vector<std::string> events(const std::string& id) {
    std::vector<std::string> told;
    const auto all = store().events(id, 0, 10'000);
    if (all)
      for (const JobEvent& event : *all) told.push_back(event.kind + ' ' + event.content);
    return told;
  }

 private:
  TemporaryFolder folder_;
  std::unique_ptr<JobStore> store_;
  std::unique_ptr<JobBoard> board_;
};

/// Within a minute, which is against hanging and no measure, looking every 5 ms.
inline bool comes_true(const std::function<bool()>& condition) {
  for (int i = 0; i < 12'000; ++i) {
    if (condition()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return false;
}

}  // namespace coapt
