// What needs a process of its own: kill -9, a full disk, a user without rights, several writers.
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include "io/store/closure_store.h"
#include "io/store/plan_store.h"
#include "tests/io/store/plan_scene.h"
#include "tests/io/store/process_scene.h"
#include "tests/io/store/store_scene.h"

namespace coapt {
namespace {

Errors keep_numbered(ClosureStore& store, const std::string& subject, int i) {
  return store.keep(subject, numbered_key(i), numbered_sample(i));
}

void expect_numbered(const Expected<KnownOrifices>& known, int at_least) {
  ASSERT_TRUE(known);
  EXPECT_GE(known->size(), static_cast<std::size_t>(at_least));
  for (int i = 0; i < static_cast<int>(known->size()); ++i) {
    const auto found = known->find(numbered_key(i));
    ASSERT_NE(found, known->end()) << i;
    EXPECT_EQ(found->second.area_mm2, numbered_sample(i).area_mm2);
    EXPECT_EQ(found->second.sd_mm2, numbered_sample(i).sd_mm2);
    EXPECT_EQ(found->second.trusted, numbered_sample(i).trusted);
  }
}

void expect_numbered(const Expected<KnownPlans>& known, int at_least) {
  ASSERT_TRUE(known);
  const int closures = closures_in(*known);
  EXPECT_GE(closures, at_least);
  for (int i = 0; i < closures; ++i) {
    const auto plan = known->find(numbered_plan(i));
    ASSERT_NE(plan, known->end()) << i;
    const auto closure = plan->second.find(numbered_disturbance(i));
    ASSERT_NE(closure, plan->second.end()) << i;
    expect_same(closure->second, numbered_closure(i));
  }
}

template <typename Store>
class StoreProcess : public testing::Test {};

using StoresOfClosures = testing::Types<ClosureStore, PlanStore>;
TYPED_TEST_SUITE(StoreProcess, StoresOfClosures);

TYPED_TEST(StoreProcess, WhatWasKeptOutlivesAKill) {
  constexpr int kRows = 10'000;
  for (const int kill_at : {1, 1'000, 2'345, 5'000}) {
    const TemporaryFolder folder;
    const std::string path = folder.file("a.db");
    int pipe_ends[2];
    ASSERT_EQ(pipe(pipe_ends), 0);
    const auto [reading, writing] = pipe_ends;
    const pid_t child = start([&path, writing = pipe_ends[1]] {
      Expected<TypeParam> store = TypeParam::open(path);
      for (int i = 0; store && i < kRows; ++i) {
        if (!keep_numbered(*store, kSubject, i).empty()) return false;
        const int kept = i + 1;
        if (::write(writing, &kept, sizeof(kept)) != sizeof(kept)) return false;
      }
      pause();
      return false;
    });
    close(writing);
    int kept = 0, told = 0;
    bool killed = false;
    while (::read(reading, &told, sizeof(told)) == sizeof(told)) {
      kept = told;
      if (kept < kill_at || killed) continue;
      kill(child, SIGKILL);
      killed = true;
    }
    close(reading);
    EXPECT_EQ(end_of(child), -SIGKILL);
    ASSERT_GE(kept, kill_at);
    EXPECT_LT(kept, kRows);

    Expected<TypeParam> store = TypeParam::open(path);
    ASSERT_TRUE(store);
    expect_numbered(store->read(kSubject), kept);
    for (int i = 0; i < kRows; ++i) ASSERT_TRUE(keep_numbered(*store, kSubject, i).empty());
    expect_numbered(store->read(kSubject), kRows);
  }
}

TYPED_TEST(StoreProcess, OpensAfterAKillWhileItWasMade) {
  for (int round = 0; round < 60; ++round) {
    const TemporaryFolder folder;
    const std::string path = folder.file("a.db");
    const pid_t child = start([&path] { return bool(TypeParam::open(path)); });
    usleep(static_cast<useconds_t>(200 * round));
    kill(child, SIGKILL);
    end_of(child);
    Expected<TypeParam> store = TypeParam::open(path);
    ASSERT_TRUE(store) << store.errors()[0].message;
    EXPECT_TRUE(keep_numbered(*store, kSubject, 0).empty());
  }
}

TYPED_TEST(StoreProcess, AFullDiskIsAnErrorAndLosesNothing) {
  const TemporaryFolder folder;
  const std::string path = folder.file("a.db");
  int pipe_ends[2];
  ASSERT_EQ(pipe(pipe_ends), 0);
  const pid_t child = start([&path, writing = pipe_ends[1]] {
    signal(SIGXFSZ, SIG_IGN);
    const rlimit limit = {300'000, 300'000};
    setrlimit(RLIMIT_FSIZE, &limit);
    Expected<TypeParam> store = TypeParam::open(path);
    int kept = 0;
    while (store && kept < 10'000 && keep_numbered(*store, kSubject, kept).empty()) ++kept;
    if (::write(writing, &kept, sizeof(kept)) != sizeof(kept)) return false;
    for (const char* const subject : {kSubject.c_str(), "another"}) {
      const Errors again = keep_numbered(*store, subject, 20'000);
      if (again.empty() || again[0].code != ErrorCode::InputOutput) return false;
    }
    return true;
  });
  int kept = 0;
  ASSERT_EQ(::read(pipe_ends[0], &kept, sizeof(kept)), static_cast<ssize_t>(sizeof(kept)));
  EXPECT_EQ(end_of(child), 0);
  EXPECT_GT(kept, 10);
  EXPECT_LT(kept, 10'000);
  const Expected<TypeParam> store = TypeParam::open(path);
  ASSERT_TRUE(store);
  expect_numbered(store->read(kSubject), kept);
}

TYPED_TEST(StoreProcess, RefusesAFileThatItMayNotWrite) {
  const TemporaryFolder folder;
  const std::string path = folder.file("a.db");
  ASSERT_TRUE(TypeParam::open(path));
  ASSERT_EQ(chmod(path.c_str(), 0444), 0);
  ASSERT_EQ(chmod(folder.path().c_str(), 0755), 0);
  const auto refused = [&path](const std::string& problem) {
    return [&path, problem] {
      constexpr uid_t kNobody = 65534;
      if (geteuid() == 0 && setuid(kNobody) != 0) return false;
      const Expected<TypeParam> store = TypeParam::open(path);
      return !store && store.errors()[0].code == ErrorCode::InputOutput &&
             store.errors()[0].message == path + ": " + problem;
    };
  };
  EXPECT_EQ(end_of(start(refused("is read-only"))), 0);
  ASSERT_EQ(chmod(path.c_str(), 0), 0);
  EXPECT_EQ(end_of(start(refused("cannot be opened: Permission denied"))), 0);
}

TYPED_TEST(StoreProcess, SeveralProcessesMakeAndFillOneFile) {
  constexpr int kRows = 300;
  const TemporaryFolder folder;
  const std::string path = folder.file("a.db");
  const auto fill = [&path] {
    Expected<TypeParam> store = TypeParam::open(path);
    for (int i = 0; store && i < kRows; ++i)
      if (!keep_numbered(*store, kSubject, i).empty()) return false;
    return bool(store);
  };
  std::vector<pid_t> children;
  for (int i = 0; i < 4; ++i) children.push_back(start(fill));
  for (const pid_t child : children) EXPECT_EQ(end_of(child), 0);
  const Expected<TypeParam> store = TypeParam::open(path);
  ASSERT_TRUE(store);
  expect_numbered(store->read(kSubject), kRows);
}

TEST(StoresProcess, OfTwoKindsThatMakeOneFileOneIsRefused) {
  for (int round = 0; round < 30; ++round) {
    const TemporaryFolder folder;
    const std::string path = folder.file("a.db");
    const pid_t plans = start([&path] { return bool(PlanStore::open(path)); });
    const pid_t closures = start([&path] { return bool(ClosureStore::open(path)); });
    const int plans_refused = end_of(plans), closures_refused = end_of(closures);
    EXPECT_EQ(plans_refused + closures_refused, 1);
    EXPECT_EQ(bool(PlanStore::open(path)), plans_refused == 0);
    EXPECT_EQ(bool(ClosureStore::open(path)), closures_refused == 0);
  }
}

}  // namespace
}  // namespace coapt
