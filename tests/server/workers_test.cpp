#include "server/workers.h"

#include <gtest/gtest.h>

#include <atomic>
#include <string>

#include "demo_server.h"

namespace coapt {
namespace {

TEST(Workers, BodiesGetHalfOfTheThreads) {
  std::atomic<bool> go = false;
  std::atomic<int> bodies = 0, plain = 0;
  Workers workers(4);
  for (int i = 0; i < 10; ++i) {
    workers.add(true, std::to_string(i), [&] {
      ++bodies;
      eventually([&] { return go.load(); });
    });
  }
  EXPECT_TRUE(eventually([&] { return bodies == 2; }));
  for (int i = 0; i < 10; ++i) workers.add(false, "a", [&] { ++plain; });
  EXPECT_TRUE(eventually([&] { return plain == 10; }));
  EXPECT_EQ(bodies, 2);
  go = true;
  EXPECT_TRUE(eventually([&] { return bodies == 10; }));
}

TEST(Workers, WhatIsQueuedIsDoneBeforeTheyEnd) {
  for (int threads = 1; threads < 4; ++threads) {
    std::atomic<int> done = 0;
    {
      Workers workers(threads);
      for (int i = 0; i < 100; ++i) workers.add(i % 2 == 0, "a", [&] { ++done; });
    }
    EXPECT_EQ(done, 100);
  }
}

TEST(Workers, BodiesOfOneClientLeaveThreadsForThoseOfOthers) {
  std::atomic<bool> go = false;
  std::atomic<int> slow = 0, others = 0;
  Workers workers(32);
  for (int i = 0; i < 20; ++i) {
    workers.add(true, "slow", [&] {
      ++slow;
      eventually([&] { return go.load(); });
    });
  }
  EXPECT_TRUE(eventually([&] { return slow == Workers::most_of_one_client(32); }));
  EXPECT_EQ(Workers::most_of_one_client(32), 14);
  for (int i = 0; i < 3; ++i) workers.add(true, "other", [&] { ++others; });
  EXPECT_TRUE(eventually([&] { return others == 3; }));
  EXPECT_EQ(slow, 14);
  go = true;
  EXPECT_TRUE(eventually([&] { return slow == 20; }));
}

TEST(Workers, ClientsAlternate) {
  std::string order;
  {
    std::atomic<bool> go = false, begun = false;
    Workers workers(1);
    workers.add(false, "a", [&] {
      begun = true;
      eventually([&] { return go.load(); });
    });
    EXPECT_TRUE(eventually([&] { return begun.load(); }));
    for (const char* client : {"a", "a", "b", "a", "c", "b"})
      workers.add(false, client, [&order, client] { order += client; });
    go = true;
  }
  EXPECT_EQ(order, "bcabaa");
}

}  // namespace
}  // namespace coapt
