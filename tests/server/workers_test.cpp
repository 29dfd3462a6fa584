#include "server/workers.h"

#include <gtest/gtest.h>

#include <atomic>

#include "demo_server.h"

namespace coapt {
namespace {

TEST(Workers, BodiesGetHalfOfTheThreads) {
  std::atomic<bool> go = false;
  std::atomic<int> bodies = 0, plain = 0;
  Workers workers(4);
  for (int i = 0; i < 10; ++i) {
    workers.add(true, [&] {
      ++bodies;
      eventually([&] { return go.load(); });
    });
  }
  EXPECT_TRUE(eventually([&] { return bodies == 2; }));
  for (int i = 0; i < 10; ++i) workers.add(false, [&] { ++plain; });
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
      for (int i = 0; i < 100; ++i) workers.add(i % 2 == 0, [&] { ++done; });
    }
    EXPECT_EQ(done, 100);
  }
}

}  // namespace
}  // namespace coapt
