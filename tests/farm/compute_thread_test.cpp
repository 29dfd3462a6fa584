#include "farm/database/compute_thread.h"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <thread>

#include "farm/database/connection.h"

namespace coapt {
namespace {

using std::chrono::milliseconds;

std::shared_ptr<const WorkRequest> request_of(const std::string& kind) {
  return std::make_shared<WorkRequest>(WorkRequest{kind, {}});
}

/// Answers "FIRST+COUNT"; kind "bad" is refused, item 13 cannot be computed, kind "long" ends by its stop alone.
Expected<Work> open_words(const WorkRequest& request) {
  if (request.kind == "bad") return Error{ErrorCode::Unsupported, "/kind", "is bad"};
  Work work;
  work.compute = [request, stop = work.stop](std::int64_t first, int count, int) {
    while (request.kind == "long" && !*stop) std::this_thread::sleep_for(milliseconds(1));
    if (*stop) throw WorkStopped();
    if (first == 13) throw std::runtime_error("thirteen");
    return std::to_string(first) + '+' + std::to_string(count);
  };
  return work;
}

std::vector<ComputedTask> await(ComputeThread& thread, std::size_t count) {
  std::vector<ComputedTask> all;
  while (all.size() < count)
    for (ComputedTask& task : thread.take(milliseconds(100))) all.push_back(std::move(task));
  return all;
}

TEST(ComputeThread, AnswersComeInTheOrderOfTheJobs) {
  ComputeThread thread(open_words, 1);
  for (int i = 0; i < 5; ++i) thread.give({{1, 10 * i}, 10, "1", request_of("words")});
  const std::vector<ComputedTask> tasks = await(thread, 5);
  for (int i = 0; i < 5; ++i)
    EXPECT_EQ(tasks[static_cast<std::size_t>(i)].bytes, std::to_string(10 * i) + "+10");
}

TEST(ComputeThread, WhatCannotBeOpenedOrComputedSaysWhy) {
  ComputeThread thread(open_words, 1);
  thread.give({{1, 0}, 1, "1", request_of("bad")});
  thread.give({{2, 13}, 1, "2", request_of("words")});
  const std::vector<ComputedTask> tasks = await(thread, 2);
  EXPECT_EQ(tasks[0].error, "the request: /kind: is bad");
  EXPECT_EQ(tasks[1].error, "computing: thirteen");
}

TEST(ComputeThread, AWorkIsOpenedOnceForItsTasksWhateverTheNumberOfTheRun) {
  std::atomic<int> opened = 0;
  ComputeThread thread(
      [&](const WorkRequest& request) {
        ++opened;
        return open_words(request);
      },
      1);
  for (int i = 0; i < 6; ++i) thread.give({{1, i}, 1, std::to_string(i % 3), request_of("words")});
  await(thread, 6);
  EXPECT_EQ(opened, 3);
}

TEST(ComputeThread, JobsThatHaveNotBegunAreTakenBackAndTheOneInProgressStops) {
  std::atomic<bool> begun = false;
  ComputeThread thread(
      [&](const WorkRequest& request) {
        begun = true;
        return open_words(request);
      },
      1);
  thread.give({{1, 0}, 1, "1", request_of("long")});
  while (!begun) std::this_thread::yield();
  for (int i = 1; i < 4; ++i) thread.give({{1, i}, 1, "1", request_of("long")});
  EXPECT_EQ(thread.take_back().size(), 3u);
  thread.stop();
  const std::vector<ComputedTask> tasks = await(thread, 1);
  EXPECT_TRUE(tasks[0].stopped);
  EXPECT_EQ(tasks[0].error, "");
}

TEST(Connection, AnAddressThatIsNoneIsRefusedWithoutRepeatingIt) {
  const Expected<Connection> connection =
      Connection::open("postgresql://anna:secret@/farm?hue=red");
  ASSERT_FALSE(connection);
  EXPECT_EQ(connection.errors()[0].code, ErrorCode::OutOfRange);
  EXPECT_EQ(connection.errors()[0].message.find("secret"), std::string::npos);
}

TEST(Connection, ADatabaseThatDoesNotAnswerIsNamedWithoutThePassword) {
  const Expected<Connection> connection =
      Connection::open("postgresql://anna:secret@/farm?host=/nonexistent");
  ASSERT_FALSE(connection);
  EXPECT_EQ(connection.errors()[0].code, ErrorCode::Busy);
  EXPECT_TRUE(
      connection.errors()[0].message.starts_with("database farm at /nonexistent, user anna: "));
  EXPECT_EQ(connection.errors()[0].message.find("secret"), std::string::npos);
}

TEST(Connection, ArraysAreThoseOfSql) {
  EXPECT_EQ(sql_array(std::vector<std::int64_t>{3, -1}), "{3,-1}");
  EXPECT_EQ(sql_array(std::vector<std::string>{}), "{}");
  EXPECT_EQ(sql_array(std::vector<std::string>{"ab", "c"}), "{ab,c}");
}

}  // namespace
}  // namespace coapt
