#include "server/compute.h"

#include <gtest/gtest.h>

#include <atomic>
#include <future>
#include <optional>
#include <string>
#include <vector>

namespace coapt {
namespace {

using std::chrono::milliseconds;

TEST(Compute, LongTurnsLeaveOneForShortOnes) {
  Compute compute(2, milliseconds(50), milliseconds(1));
  const Compute::Turn first(compute, TurnCost::Long);
  ASSERT_TRUE(first);
  EXPECT_FALSE(Compute::Turn(compute, TurnCost::Long)) << "the other turn is for short ones";
  EXPECT_TRUE(Compute::Turn(compute));
  const Compute::Turn second(compute);
  EXPECT_TRUE(second);
  EXPECT_FALSE(Compute::Turn(compute)) << "there are only two";
}

TEST(Compute, OneCoreServesLongOnesToo) {
  Compute compute(1, milliseconds(50), milliseconds(1));
  EXPECT_TRUE(Compute::Turn(compute, TurnCost::Long));
  EXPECT_TRUE(Compute::Turn(compute));
}

TEST(Compute, WhatCannotBeginInTimeIsToldAtOnce) {
  // Two may wait behind the one that runs: the second begins within 2 x 1 h. Who waited would do so for as long.
  Compute compute(2, std::chrono::hours(2), std::chrono::hours(1));
  std::optional<Compute::Turn> running(std::in_place, compute, TurnCost::Long);
  std::atomic<int> served = 0, refused = 0;
  std::vector<std::thread> asking;
  for (int i = 0; i < 3; ++i)
    asking.emplace_back([&] {
      ++(Compute::Turn(compute, TurnCost::Long) ? served : refused);
      refused.notify_one();
    });
  refused.wait(0);
  running.reset();
  for (std::thread& thread : asking) thread.join();
  EXPECT_EQ(served, 2);
  EXPECT_EQ(refused, 1);
}

TEST(Compute, ShortOnesGoFirstUntilALongOneHasWaitedLongEnough) {
  for (const auto& [pause, expected] :
       {std::pair{milliseconds(0), "short long "}, std::pair{milliseconds(600), "long short "}}) {
    Compute compute(1, std::chrono::seconds(2), std::chrono::seconds(1));  // overdue after 0.5 s
    std::optional<Compute::Turn> running(std::in_place, compute);
    std::string order;
    std::thread heavy([&] {
      const Compute::Turn turn(compute, TurnCost::Long);
      order += "long ";
    });
    std::this_thread::sleep_for(milliseconds(100));
    std::thread light([&] {
      const Compute::Turn turn(compute);
      order += "short ";
    });
    std::this_thread::sleep_for(milliseconds(100) + pause);
    running.reset();
    heavy.join();
    light.join();
    EXPECT_EQ(order, expected);
  }
}

}  // namespace
}  // namespace coapt
