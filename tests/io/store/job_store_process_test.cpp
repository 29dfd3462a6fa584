// What needs a process of its own: kill -9, a full disk, a user without rights, two servers.
#include <gtest/gtest.h>
#include <signal.h>
#include <sqlite3.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <random>

#include "io/store/job_store.h"
#include "io/store/stored_valves.h"
#include "tests/io/store/job_scene.h"
#include "tests/io/store/process_scene.h"
#include "tests/io/store/store_scene.h"

namespace coapt {
namespace {

constexpr int kEvents = 4;
constexpr int kCallsOfAJob = kEvents + 3;  ///< submit, start, events, finish

/// The calls of one job after another; whether it was kept.
bool call(JobStore& store, int number) {
  const int i = number / kCallsOfAJob, part = number % kCallsOfAJob;
  if (part == 0) return bool(store.submit(numbered_job(i), numbered_document(i), 5));
  if (part == 1) return bool(store.start(numbered_id(i), 0, 6));
  if (part == kCallsOfAJob - 1) return store.finish(numbered_id(i), numbered_end(i), 7).empty();
  return bool(store.add_event(numbered_id(i), "progress", numbered_event(part - 1), part / 4.0));
}

/// What SQLite itself finds wrong: "ok" without rows of other tables that are missing.
std::string wrong_in(const std::string& path) {
  sqlite3* database = nullptr;
  sqlite3_open(path.c_str(), &database);
  std::string found;
  const auto add = [](void* text, int, char** values, char**) {
    *static_cast<std::string*>(text) += values[0];
    return 0;
  };
  sqlite3_exec(database, "PRAGMA integrity_check; PRAGMA foreign_key_check", add, &found, nullptr);
  sqlite3_close_v2(database);
  return found;
}

/// That the file holds the first calls, no less than `at_least`, each of them whole. How many.
int expect_calls(const JobStore& store, int at_least) {
  const auto page = store.page(1, 0, {});
  EXPECT_TRUE(page);
  if (!page || page->jobs.empty()) {
    EXPECT_EQ(at_least, 0);
    return 0;
  }
  const int last = static_cast<int>(page->jobs[0].number) - 1;
  for (int i = 0; i <= last; ++i) {
    const Job job = job_of(store, numbered_id(i));
    EXPECT_EQ(job.request, numbered_job(i).request);
    EXPECT_EQ(**stored_valve(store, job.valve), numbered_document(i));
    const std::vector<JobEvent> events = events_of(store, job.id, "progress");
    const int last_event = static_cast<int>(events.size());
    for (int event = 1; event <= last_event; ++event)
      EXPECT_EQ(events[static_cast<std::size_t>(event) - 1].content, numbered_event(event));
    const std::string state = std::string("{\"state\": \"") + to_string(job.state) + "\"}";
    EXPECT_EQ(events_of(store, job.id, "state").back().content, state);
    if (has_ended(job.state)) {
      EXPECT_EQ(last_event, kEvents);
      expect_ended(store, i);
      continue;
    }
    EXPECT_EQ(i, last);
    EXPECT_EQ(job.progress, last_event == 0 ? "" : numbered_event(last_event));
    EXPECT_TRUE(store.files(job.id)->empty());
    const int started = job.state == JobState::Running ? 1 : 0;
    const int calls = i * kCallsOfAJob + 1 + started + last_event;
    EXPECT_GE(calls, at_least);
    return calls;
  }
  const int calls = (last + 1) * kCallsOfAJob;
  EXPECT_GE(calls, at_least);
  return calls;
}

TEST(JobStoreProcess, WhatReturnedOutlivesAKillAndNothingIsHalf) {
  constexpr int kCalls = 2'000;
  std::mt19937 random(1);
  const TemporaryFolder folder;
  const std::string path = folder.file("a.db");
  int kept = 0;  // the next process goes on after it
  for (int round = 0; round < 12; ++round) {
    int pipe_ends[2];
    ASSERT_EQ(pipe(pipe_ends), 0);
    const pid_t child = start([&path, kept, writing = pipe_ends[1]] {
      Expected<JobStore> store = JobStore::open(path);
      for (int number = kept; store && number < kCalls; ++number) {
        if (!call(*store, number)) return false;
        const int returned = number + 1;
        if (::write(writing, &returned, sizeof(returned)) != sizeof(returned)) return false;
      }
      pause();
      return false;
    });
    close(pipe_ends[1]);
    const int kill_at = kept + static_cast<int>(random() % 50);
    const auto moment_us = static_cast<useconds_t>(random() % 4'000);
    int returned = kept, told = 0;
    while (returned < kill_at && ::read(pipe_ends[0], &told, sizeof(told)) == sizeof(told))
      returned = told;
    usleep(moment_us);
    kill(child, SIGKILL);
    EXPECT_EQ(end_of(child), -SIGKILL);
    while (::read(pipe_ends[0], &told, sizeof(told)) == sizeof(told)) returned = told;
    close(pipe_ends[0]);
    ASSERT_GE(returned, kill_at);

    const Expected<JobStore> store = JobStore::open(path);
    ASSERT_TRUE(store) << store.errors()[0].message;
    kept = expect_calls(*store, returned);
    EXPECT_LE(kept, returned + 1);
    EXPECT_EQ(wrong_in(path), "ok");
    ASSERT_FALSE(HasFailure());
  }
  EXPECT_GT(kept, kCallsOfAJob);
}

TEST(JobStoreProcess, OpensAfterAKillWhileItWasMade) {
  for (int round = 0; round < 40; ++round) {
    const TemporaryFolder folder;
    const std::string path = folder.file("a.db");
    const pid_t child = start([&path] { return bool(JobStore::open(path)); });
    usleep(static_cast<useconds_t>(400 * round));
    kill(child, SIGKILL);
    end_of(child);
    Expected<JobStore> store = JobStore::open(path);
    ASSERT_TRUE(store) << store.errors()[0].message;
    submit(*store, 1);
  }
}

/// In this process alone; a write beyond it fails instead of ending the process.
bool limit_files(rlim_t bytes) {
  signal(SIGXFSZ, SIG_IGN);
  rlimit limit{};
  getrlimit(RLIMIT_FSIZE, &limit);
  limit.rlim_cur = bytes;
  return setrlimit(RLIMIT_FSIZE, &limit) == 0;
}

bool is_no_space(const Errors& errors) {
  return errors.size() == 1 && errors[0].code == ErrorCode::NoSpace;
}

TEST(JobStoreProcess, AFullDiskIsNoSpaceAndTheSameStoreGoesOnAfterwards) {
  const TemporaryFolder folder;
  const std::string path = folder.file("a.db");
  int pipe_ends[2];
  ASSERT_EQ(pipe(pipe_ends), 0);
  const pid_t child = start([&path, writing = pipe_ends[1]] {
    if (!limit_files(400'000)) return false;
    Expected<JobStore> store = JobStore::open(path);
    int kept = 0;
    while (store && kept < 2'000 && call(*store, kept)) ++kept;
    if (::write(writing, &kept, sizeof(kept)) != sizeof(kept)) return false;
    for (int again = 0; again < 3; ++again) {
      if (!is_no_space(store->submit(numbered_job(999), std::string(500'000, ' '), 5).errors()))
        return false;
    }
    const auto before = store->page(2'000, 0, {});
    if (!before || before->jobs.empty() || *store->job(numbered_id(999))) return false;
    if (!limit_files(RLIM_INFINITY)) return false;
    for (const int end = kept + 50; kept < end; ++kept) {
      if (!call(*store, kept)) return false;
    }
    return ::write(writing, &kept, sizeof(kept)) == sizeof(kept);
  });
  close(pipe_ends[1]);
  int kept_when_full = 0, kept = 0;
  ASSERT_EQ(::read(pipe_ends[0], &kept_when_full, sizeof(int)), static_cast<ssize_t>(sizeof(int)));
  EXPECT_EQ(end_of(child), 0);
  ASSERT_EQ(::read(pipe_ends[0], &kept, sizeof(kept)), static_cast<ssize_t>(sizeof(kept)));
  EXPECT_GT(kept_when_full, 10);
  EXPECT_LT(kept_when_full, 2'000);
  const Expected<JobStore> store = JobStore::open(path);
  ASSERT_TRUE(store);
  EXPECT_EQ(expect_calls(*store, kept), kept);
  EXPECT_EQ(wrong_in(path), "ok");
}

TEST(JobStoreProcess, SaysThatItCannotBeWrittenWhenTheDiskIsFull) {
  const TemporaryFolder folder;
  const std::string path = folder.file("a.db");
  const auto work = [&path] {
    Expected<JobStore> store = JobStore::open(path);
    if (!store || !limit_files(1'000) || !is_no_space(store->check_writable())) return false;
    return limit_files(RLIM_INFINITY) && store->check_writable().empty();
  };
  EXPECT_EQ(end_of(start(work)), 0);
}

TEST(JobStoreProcess, IsNotMadeOnAFullDiskButAfterwards) {
  const TemporaryFolder folder;
  const std::string path = folder.file("a.db");
  const auto work = [&path] {
    for (const rlim_t bytes : {0, 1'000, 10'000, 30'000}) {
      if (!limit_files(bytes)) return false;
      const Expected<JobStore> store = JobStore::open(path);
      if (store || !is_no_space(store.errors())) return false;
    }
    return limit_files(RLIM_INFINITY) && bool(JobStore::open(path));
  };
  EXPECT_EQ(end_of(start(work)), 0);
}

TEST(JobStoreProcess, RefusesAFileThatItMayNotWrite) {
  const TemporaryFolder folder;
  const std::string path = folder.file("a.db");
  ASSERT_TRUE(JobStore::open(path));
  ASSERT_EQ(chmod(path.c_str(), 0444), 0);
  ASSERT_EQ(chmod(folder.path().c_str(), 0755), 0);
  const auto work = [&path] {
    constexpr uid_t kNobody = 65534;
    if (geteuid() == 0 && setuid(kNobody) != 0) return false;
    const Expected<JobStore> store = JobStore::open(path);
    return !store && store.errors()[0].code == ErrorCode::InputOutput &&
           store.errors()[0].message == path + ": is read-only";
  };
  EXPECT_EQ(end_of(start(work)), 0);
}

TEST(JobStoreProcess, OfTwoServersOneIsRefusedUntilTheOtherEndsHoweverItEnds) {
  const TemporaryFolder folder;
  const std::string path = folder.file("a.db");
  int pipe_ends[2];
  ASSERT_EQ(pipe(pipe_ends), 0);
  const pid_t child = start([&path, writing = pipe_ends[1]] {
    const Expected<JobStore> store = JobStore::open(path);
    if (!store || ::write(writing, "x", 1) != 1) return false;
    pause();
    return true;
  });
  close(pipe_ends[1]);
  char told = 0;
  ASSERT_EQ(::read(pipe_ends[0], &told, 1), 1);
  const Expected<JobStore> second = JobStore::open(path);
  kill(child, SIGKILL);
  end_of(child);
  ASSERT_FALSE(second);
  EXPECT_EQ(second.errors()[0].code, ErrorCode::Busy);
  EXPECT_EQ(second.errors()[0].message, path + ": is used by another coapt-server");
  EXPECT_TRUE(JobStore::open(path));
}

}  // namespace
}  // namespace coapt
