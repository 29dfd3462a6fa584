// The file of a job store: whose it is, whether it is whole, who else holds it.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "io/store/job_store.h"
#include "tests/io/store/job_scene.h"
#include "tests/io/store/store_files.h"
#include "tests/io/store/store_scene.h"

namespace coapt {
namespace {

void expect_busy(const Errors& errors, const std::string& message) {
  ASSERT_EQ(errors.size(), 1u);
  EXPECT_EQ(errors[0].code, ErrorCode::Busy);
  EXPECT_EQ(errors[0].message, message);
}

TEST(JobStoreFile, IsMadeInAnEmptyFile) {
  const TemporaryFolder folder;
  write(folder.file("a.db"), "");
  EXPECT_TRUE(JobStore::open(folder.file("a.db")));
}

TEST(JobStoreFile, RefusesWhatIsNoneOfItsOwnAndMakesNothingBesideIt) {
  const TemporaryFolder folder;
  write(folder.file("text"), std::string(10'000, 'x'));
  Database(folder.file("other.db")).run("PRAGMA application_id = 7; CREATE TABLE jobs (id TEXT)");
  expect_store_refused_and_untouched<JobStore>(folder, folder.file("text"),
                                               "is not a store of jobs, but some other file");
  expect_store_refused_and_untouched<JobStore>(folder, folder.file("other.db"),
                                               "another application");
}

TEST(JobStoreFile, RefusesANewerSchema) {
  const TemporaryFolder folder;
  const std::string path = folder.file("a.db");
  ASSERT_TRUE(JobStore::open(path));
  Database(path).run("PRAGMA journal_mode = DELETE; PRAGMA user_version = 2");
  expect_store_refused_and_untouched<JobStore>(folder, path, "schema 2; this coapt knows schema 1");
}

TEST(JobStoreFile, RefusesPathsWithoutAFile) {
  const TemporaryFolder folder;
  expect_store_refused<JobStore>(folder.path(), "Is a directory");
  expect_store_refused<JobStore>(folder.file("missing/a.db"), "No such file or directory");
  expect_store_refused<JobStore>("", "needs the path of a file");
  expect_store_refused<JobStore>(":memory:", "is not a file");
  EXPECT_FALSE(std::filesystem::exists(":memory:-lock"));
}

TEST(JobStoreFile, SaysThatItsTablesAreGone) {
  const TemporaryFolder folder;
  const std::string path = folder.file("a.db");
  ASSERT_TRUE(JobStore::open(path));
  Database(path).run("DROP TABLE events");
  expect_store_refused<JobStore>(path, "cannot be opened: no such table: events");
}

TEST(JobStoreFile, SaysThatItIsDamaged) {
  const TemporaryFolder folder;
  const std::string path = folder.file("a.db");
  {
    Expected<JobStore> store = JobStore::open(path);
    ASSERT_TRUE(store);
    for (int i = 0; i < 20; ++i) submit(*store, i);
  }
  std::string bytes = bytes_of(path);
  bytes.replace(8192, bytes.size() - 8192, bytes.size() - 8192, 'x');
  write(path, bytes);
  const Expected<JobStore> store = JobStore::open(path);
  ASSERT_TRUE(store);
  const auto jobs = store->unfinished();
  ASSERT_FALSE(jobs);
  EXPECT_EQ(jobs.errors()[0].code, ErrorCode::InputOutput);
  EXPECT_EQ(jobs.errors()[0].message, path + ": cannot be read: database disk image is malformed");
}

TEST(JobStoreFile, IsOpenedByOneServerAtATime) {
  const TemporaryFolder folder;
  const std::string path = folder.file("a.db");
  {
    Expected<JobStore> store = JobStore::open(path);
    ASSERT_TRUE(store);
    const Expected<JobStore> second = JobStore::open(path);
    ASSERT_FALSE(second);
    expect_busy(second.errors(), path + ": is used by another coapt-server");
    submit(*store, 1);
  }
  EXPECT_TRUE(JobStore::open(path));
}

TEST(JobStoreFile, IsTheSameByAnyPath) {
  const TemporaryFolder folder;
  const std::string path = folder.file("a.db"), link = folder.file("link.db");
  const Expected<JobStore> store = JobStore::open(path);
  ASSERT_TRUE(store);
  std::filesystem::create_symlink(path, link);
  const Expected<JobStore> second = JobStore::open(link);
  ASSERT_FALSE(second);
  expect_busy(second.errors(), link + ": is used by another coapt-server");
}

TEST(JobStoreFile, IsNotOpenedIfItsLockCannotBe) {
  const TemporaryFolder folder;
  const std::string path = folder.file("a.db");
  std::filesystem::create_directory(path + "-lock");
  expect_store_refused<JobStore>(path, "a.db-lock: cannot be locked: Is a directory");
}

TEST(JobStoreFile, TakesNothingMoreOnceItIsNotWhereItWas) {
  const TemporaryFolder folder;
  const std::string path = folder.file("a.db");
  Expected<JobStore> store = JobStore::open(path, 20);
  ASSERT_TRUE(store);
  submit(*store, 1);
  std::filesystem::rename(path, folder.file("b.db"));
  const Expected<JobStore::Submitted> refused = store->submit(numbered_job(2), "{}", 5);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.errors().front().code, ErrorCode::InputOutput);
  EXPECT_EQ(
      refused.errors().front().message,
      path + ": a job cannot be kept: the file has been moved away or removed since it was opened");
  EXPECT_FALSE(store->check_writable().empty());
  EXPECT_EQ(job_of(*store, numbered_id(1)).state, JobState::Queued) << "what is there is read";
  std::filesystem::rename(folder.file("b.db"), path);
  submit(*store, 2);
}

TEST(JobStoreFile, IsBusyWhileAnotherApplicationLocksItAndGoesOnAfterwards) {
  const TemporaryFolder folder;
  const std::string path = folder.file("a.db");
  Expected<JobStore> store = JobStore::open(path, 20);
  ASSERT_TRUE(store);
  submit(*store, 1);
  const Database other(path);
  other.run("BEGIN IMMEDIATE");
  const std::string locked = ": database is locked";
  expect_busy(store->submit(numbered_job(2), "{}", 5).errors(),
              path + ": a job cannot be kept" + locked);
  expect_busy(store->finish(numbered_id(1), numbered_end(1), 5),
              path + ": the end of a job cannot be kept" + locked);
  expect_busy(store->check_writable(), path + ": cannot be written" + locked);
  EXPECT_EQ(job_of(*store, numbered_id(1)).state, JobState::Queued);
  EXPECT_EQ(store->unfinished()->size(), 1u);

  other.run("COMMIT");
  submit(*store, 2);
  EXPECT_TRUE(store->finish(numbered_id(1), numbered_end(1), 5).empty());
  expect_ended(*store, 1);
}

TEST(JobStoreFile, IsNotOpenedWhileAnotherConnectionHoldsAll) {
  const TemporaryFolder folder;
  const std::string path = folder.file("a.db");
  ASSERT_TRUE(JobStore::open(path));
  const Database other(path);
  other.run("PRAGMA locking_mode = EXCLUSIVE; BEGIN EXCLUSIVE; PRAGMA user_version = 1; COMMIT");
  const Expected<JobStore> store = JobStore::open(path, 20);
  ASSERT_FALSE(store);
  expect_busy(store.errors(), path + ": cannot be opened: database is locked");
}

}  // namespace
}  // namespace coapt
