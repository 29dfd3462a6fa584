#include "io/store/job_store.h"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>

#include "io/store/stored_valves.h"
#include "tests/io/store/job_scene.h"

namespace coapt {
namespace {

TEST_F(JobStoreTest, GivesASubmittedJobBackByteForByteAfterOpeningAgain) {
  const std::string bytes = all_bytes();
  const NewJob wanted = {.id = "i" + bytes,
                         .kind = "k" + bytes,
                         .valve = "v" + bytes,
                         .request = all_bytes(100'000),
                         .idempotency_key = "y" + bytes};
  const auto submitted = store().submit(wanted, all_bytes(200'000), 1'700'000'000'123);
  ASSERT_TRUE(submitted) << submitted.errors()[0].message;
  EXPECT_TRUE(submitted->is_new);
  open_again();
  for (const Job& job : {submitted->job, job_of(store(), wanted.id)}) {
    EXPECT_EQ(job.number, 1);
    EXPECT_EQ(job.id, wanted.id);
    EXPECT_EQ(job.kind, wanted.kind);
    EXPECT_EQ(job.valve, wanted.valve);
    EXPECT_EQ(job.request, wanted.request);
    EXPECT_EQ(job.state, JobState::Queued);
    EXPECT_FALSE(job.cancel_requested);
    EXPECT_EQ(job.created_ms, 1'700'000'000'123);
    EXPECT_EQ(job.started_ms, 0);
    EXPECT_EQ(job.finished_ms, 0);
    EXPECT_EQ(job.seconds, 0.0);
    EXPECT_EQ(job.stalled, 0);
    EXPECT_EQ(job.kept, 0);
    EXPECT_EQ(job.progress + job.summary, "");
  }
  EXPECT_EQ(**stored_valve(store(), wanted.valve), all_bytes(200'000));
}

TEST_F(JobStoreTest, KnowsAnIdempotencyKeyAgainAndKeepsNothingElseThen) {
  submit(store(), 1);
  NewJob again = numbered_job(2);
  again.idempotency_key = numbered_job(1).idempotency_key;
  again.valve = "another valve";
  const auto submitted = store().submit(again, "{}", 5);
  ASSERT_TRUE(submitted);
  EXPECT_FALSE(submitted->is_new);
  EXPECT_EQ(submitted->job.id, numbered_id(1));
  EXPECT_EQ(submitted->job.request, numbered_job(1).request);
  EXPECT_FALSE(*store().job(numbered_id(2)));
  EXPECT_FALSE(*stored_valve(store(), "another valve"));
}

TEST_F(JobStoreTest, TakesManyJobsWithoutAKeyButNoIdTwice) {
  submit(store(), 0);
  submit(store(), 4);
  const auto twice = store().submit(numbered_job(4), "{}", 5);
  ASSERT_FALSE(twice);
  EXPECT_EQ(twice.errors()[0].code, ErrorCode::InputOutput);
  EXPECT_EQ(twice.errors()[0].message,
            path_ + ": a job cannot be kept: UNIQUE constraint failed: jobs.id");
  submit(store(), 5);
}

TEST_F(JobStoreTest, KeepsTheFirstValveOfAnIdAndRemovesNoneThatAJobRefersTo) {
  EXPECT_TRUE(*add_valve(store(), "v", "first"));
  EXPECT_FALSE(*add_valve(store(), "v", "second"));
  EXPECT_EQ(**stored_valve(store(), "v"), "first");
  EXPECT_TRUE(*remove_valve(store(), "v"));
  EXPECT_FALSE(*remove_valve(store(), "v"));
  EXPECT_FALSE(*stored_valve(store(), "v"));

  submit(store(), 1);
  const auto refused = remove_valve(store(), numbered_job(1).valve);
  ASSERT_FALSE(refused);
  expect_bad_reference(refused.errors());
  EXPECT_EQ(**stored_valve(store(), numbered_job(1).valve), numbered_document(1));
  EXPECT_TRUE(store().finish(numbered_id(1), numbered_end(1), 9).empty());
  EXPECT_TRUE(*store().remove(numbered_id(1)));
  EXPECT_TRUE(*remove_valve(store(), numbered_job(1).valve));
}

TEST_F(JobStoreTest, PagesNewestFirstAndPassesTheBodiesOver) {
  for (int i = 0; i < 7; ++i) submit(store(), i);
  for (const int i : {1, 4}) EXPECT_TRUE(store().start(numbered_id(i), 0, 5));
  const auto ids = [this](int size, std::int64_t before, std::optional<JobState> state,
                          std::int64_t next) {
    const auto page = store().page(size, before, state);
    EXPECT_EQ(page->next_before, next);
    std::string numbers;
    for (const Job& job : page->jobs) {
      EXPECT_EQ(job.request, "");
      numbers += std::to_string(job.number) + ' ';
    }
    return numbers;
  };
  EXPECT_EQ(ids(3, 0, {}, 5), "7 6 5 ");
  EXPECT_EQ(ids(3, 5, {}, 2), "4 3 2 ");
  EXPECT_EQ(ids(3, 2, {}, 0), "1 ");
  EXPECT_EQ(ids(7, 0, {}, 0), "7 6 5 4 3 2 1 ");
  EXPECT_EQ(ids(1, 0, JobState::Running, 5), "5 ");
  EXPECT_EQ(ids(1, 5, JobState::Running, 0), "2 ");
  EXPECT_EQ(ids(5, 0, JobState::Failed, 0), "");
  EXPECT_EQ(ids(1, 1, {}, 0), "");
}

TEST_F(JobStoreTest, ListsWhatAServerHasToDoInTheOrderOfSubmission) {
  for (int i = 0; i < 5; ++i) submit(store(), i);
  EXPECT_TRUE(store().start(numbered_id(3), 0, 5));
  EXPECT_TRUE(store().finish(numbered_id(0), numbered_end(0), 5).empty());
  open_again();
  std::string numbers;
  const Expected<std::vector<Job>> jobs = store().unfinished();
  ASSERT_TRUE(jobs);
  for (const Job& job : *jobs) numbers += std::to_string(job.number) + ' ';
  EXPECT_EQ(numbers, "2 3 4 5 ");
  EXPECT_EQ(*store().count(JobState::Queued), 3);
  EXPECT_EQ(*store().count(JobState::Running), 1);
  EXPECT_EQ(*store().count(JobState::Succeeded), 1);
  EXPECT_EQ(*store().count(JobState::Failed), 0);
}

TEST_F(JobStoreTest, ReadsWhileAnotherThreadWrites) {
  std::atomic<bool> is_done = false;
  std::atomic<int> wrong = 0, reads = 0;
  submit(store(), 0);
  const auto read = [&] {
    do {
      const auto page = store().page(100, 0, {});
      // Two changes of state and three of progress are kept with the end or before it, which has files: whoever sees the end sees all of them.
      for (std::size_t i = 0; page && i < page->jobs.size(); ++i) {
        const Job& job = page->jobs[i];
        if (!has_ended(job.state)) continue;
        if (store().files(job.id)->size() != 2 || store().events(job.id, 0, 9)->size() != 5)
          ++wrong;
      }
      if (!page || page->jobs.empty()) ++wrong;
      ++reads;
    } while (!is_done);
  };
  std::thread first(read), second(read);
  for (int i = 1; i <= 20; ++i) {
    submit(store(), i);
    for (int event = 1; event <= 3; ++event)
      EXPECT_TRUE(store().add_event(numbered_id(i), "progress", numbered_event(event), 1.0));
    EXPECT_TRUE(store().finish(numbered_id(i), numbered_end(i), 77).empty());
  }
  is_done = true;
  first.join();
  second.join();
  EXPECT_EQ(wrong, 0);
  EXPECT_GE(reads, 2);
}

TEST_F(JobStoreTest, SaysThatItCanBeWritten) {
  submit(store(), 1);
  EXPECT_TRUE(store().check_writable().empty());
  open_again();
  EXPECT_EQ(job(1).number, 1);
}

}  // namespace
}  // namespace coapt
