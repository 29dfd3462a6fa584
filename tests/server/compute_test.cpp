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
  // Two may wait behind the one that runs: the second begins within 2 x 10 s.
  Compute compute(2, std::chrono::seconds(20), std::chrono::seconds(10));
  std::optional<Compute::Turn> running(std::in_place, compute, TurnCost::Long);
  std::atomic<int> served = 0;
  std::vector<std::thread> waiting;
  for (int i = 0; i < 2; ++i)
    waiting.emplace_back([&] {
      if (Compute::Turn(compute, TurnCost::Long)) ++served;
    });
  std::this_thread::sleep_for(milliseconds(200));
  const auto asked = std::chrono::steady_clock::now();
  EXPECT_FALSE(Compute::Turn(compute, TurnCost::Long));
  EXPECT_LT(std::chrono::steady_clock::now() - asked, std::chrono::seconds(5));
  running.reset();
  for (std::thread& thread : waiting) thread.join();
  EXPECT_EQ(served, 2);
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
