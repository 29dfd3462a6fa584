#include "server/compute.h"

#include <gtest/gtest.h>

#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace coapt {
namespace {

using std::chrono::hours;
using std::chrono::milliseconds;
using std::chrono::seconds;

const TurnAsk kLong{2.0 * Compute::kLong_s}, kShort{0.1};

/// Asks on a thread of its own; once it waits, or has its turn or a refusal, the next may ask.
class Asking {
 public:
  Asking(Compute& compute, const TurnAsk& ask, std::string& order)
      : thread_([&compute, ask, &order] {
          const Compute::Turn turn(compute, ask);
          order += turn ? ask.client : "-";
        }) {
    std::this_thread::sleep_for(milliseconds(100));
  }
  ~Asking() { thread_.join(); }
  Asking(const Asking&) = delete;

 private:
  std::thread thread_;
};

TEST(Compute, LongTurnsLeaveOneForShortOnes) {
  Compute compute(2, milliseconds(50), seconds(1));
  const Compute::Turn first(compute, kLong);
  ASSERT_TRUE(first);
  EXPECT_FALSE(Compute::Turn(compute, kLong)) << "the other turn is for short ones";
  EXPECT_TRUE(Compute::Turn(compute));
  const Compute::Turn second(compute);
  EXPECT_TRUE(second);
  EXPECT_FALSE(Compute::Turn(compute)) << "there are only two";
}

TEST(Compute, OneCoreServesLongOnesToo) {
  Compute compute(1, milliseconds(50), seconds(1));
  EXPECT_TRUE(Compute::Turn(compute, kLong));
  EXPECT_TRUE(Compute::Turn(compute));
}

TEST(Compute, WhatCannotBeginInTimeIsToldAtOnceAndWhenToComeAgain) {
  // Of 1,000 s each, with 5,000 s of patience: the fifth behind the one that runs begins just in time.
  Compute compute(2, seconds(5000), seconds(3000));
  std::optional<Compute::Turn> running(std::in_place, compute, TurnAsk{1000.0});
  std::string order;
  std::vector<std::unique_ptr<Asking>> asking;
  for (const char* name : {"a", "b", "c", "d", "e", "f"})
    asking.push_back(std::make_unique<Asking>(compute, TurnAsk{1000.0, name}, order));
  EXPECT_EQ(order, "-");
  const Compute::Turn refused(compute, {1000.0, "a"});
  EXPECT_EQ(refused.end(), Compute::End::Busy);
  EXPECT_EQ(refused.retry_after_s(), 60) << "an hour is no answer";
  running.reset();
  asking.clear();
  EXPECT_EQ(order, "-abcde");
}

TEST(Compute, WhoComesBehindAnothersCrowdWaitsForOneOfThem) {
  Compute compute(1, seconds(300), seconds(300));
  std::optional<Compute::Turn> running(std::in_place, compute, TurnAsk{0.1, "a"});
  std::string order;
  {
    std::vector<std::unique_ptr<Asking>> asking;
    for (const char* name : {"a", "a", "a", "b", "b", "c"})
      asking.push_back(std::make_unique<Asking>(compute, TurnAsk{0.1, name}, order));
    running.reset();
  }
  EXPECT_EQ(order, "bcabaa");
}

TEST(Compute, ACrowdRefusesItselfAndNobodyElse) {
  Compute compute(1, seconds(25), seconds(10));
  std::optional<Compute::Turn> running(std::in_place, compute, TurnAsk{9.0, "a"});
  std::string order;
  {
    Asking one(compute, {9.0, "a"}, order), two(compute, {9.0, "a"}, order);  // after 9 and 18 s
    EXPECT_FALSE(Compute::Turn(compute, {9.0, "a"})) << "after 27 s";
    Asking other(compute, {9.0, "b"}, order);
    running.reset();
  }
  EXPECT_EQ(order, "baa");
}

TEST(Compute, WhatCouldNotEndInTimeIsRefusedWhileOthersWaitAndTriedWhereNobodyDoes) {
  Compute compute(2, hours(1), seconds(10));
  EXPECT_TRUE(Compute::Turn(compute, {11.0, "a"}));
  const Compute::Turn running(compute, {1.0, "b"});
  const Compute::Turn refused(compute, {11.0, "a"});
  EXPECT_EQ(refused.end(), Compute::End::Busy);
  EXPECT_EQ(refused.retry_after_s(), 1);
}

TEST(Compute, TheSameIsNotBegunAgainRightAfterItRanOutOfTime) {
  Compute compute(2, seconds(20), seconds(10));
  const TurnAsk ask{1.0, "a", 7};
  Compute::Turn(compute, ask).ran_out();
  const Compute::Turn again(compute, ask);
  EXPECT_EQ(again.end(), Compute::End::TooLong);
  EXPECT_GT(again.retry_after_s(), 20);
  EXPECT_LE(again.retry_after_s(), 30);
  EXPECT_TRUE(Compute::Turn(compute, {1.0, "a", 8}));
  EXPECT_TRUE(Compute::Turn(compute, {1.0, "a"})) << "what is not to be known again";
}

TEST(Compute, LearnsHowFastTheMachineIsFromTheMedianOfWhatWasDone) {
  // What is done at once is faster than expected, to a quarter at most: 11 s become 2.75.
  Compute compute(2, hours(1), seconds(10));
  const auto could_end = [&compute] {
    const Compute::Turn running(compute, {1.0, "b"});
    const Compute::Turn refused(compute, {11.0, "a", 0});
    return refused.end() == Compute::End::Running;
  };
  for (int i = 0; i < 4; ++i) Compute::Turn(compute, {1.0, "b"}).done();
  EXPECT_FALSE(could_end()) << "four of nine";
  Compute::Turn(compute, {1.0, "b"}).done();
  std::string order;
  {
    std::optional<Compute::Turn> running(std::in_place, compute, TurnAsk{1.0, "b"});
    Asking waits(compute, {11.0, "a"}, order);
    running.reset();
  }
  EXPECT_EQ(order, "a");
}

TEST(Compute, LearnsNothingFromWhatIsExpectedToTakeNoTime) {
  Compute compute(2, hours(1), seconds(10));
  for (int i = 0; i < 9; ++i) {
    Compute::Turn quick(compute, {0.0, "b"});
    std::this_thread::sleep_for(milliseconds(1));
    quick.done();
  }
  std::string order;
  {
    std::optional<Compute::Turn> running(std::in_place, compute, TurnAsk{1.0, "b"});
    Asking waits(compute, {9.0, "a"}, order);
    running.reset();
  }
  EXPECT_EQ(order, "a") << "9 s do not count as 36";
}

TEST(Compute, ShortOnesGoFirstUntilALongOneHasWaitedLongEnough) {
  for (const auto& [pause, expected] :
       {std::pair{milliseconds(0), "sl"}, std::pair{milliseconds(600), "ls"}}) {
    Compute compute(1, seconds(2), seconds(2));  // overdue after 0.5 s
    std::optional<Compute::Turn> running(std::in_place, compute);
    std::string order;
    {
      Asking heavy(compute, {1.0, "l"}, order), light(compute, {0.1, "s"}, order);
      std::this_thread::sleep_for(pause);
      running.reset();
    }
    EXPECT_EQ(order, expected);
  }
}

}  // namespace
}  // namespace coapt
