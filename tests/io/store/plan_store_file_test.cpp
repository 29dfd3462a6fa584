// The file of a plan store: whose it is, whether it is whole, who else holds it.
#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "io/store/closure_store.h"
#include "io/store/plan_store.h"
#include "tests/io/store/plan_scene.h"
#include "tests/io/store/store_files.h"
#include "tests/io/store/store_scene.h"

namespace coapt {
namespace {

TEST(PlanStoreFile, NeitherStoreTakesAFileOfTheOther) {
  const TemporaryFolder folder;
  ASSERT_TRUE(PlanStore::open(folder.file("plans.db")));
  ASSERT_TRUE(ClosureStore::open(folder.file("closures.db")));
  expect_store_refused_and_untouched<PlanStore>(
      folder, folder.file("closures.db"),
      "is not a store of plans, but a database of another application");
  expect_store_refused_and_untouched<ClosureStore>(
      folder, folder.file("plans.db"),
      "is not a store of closures, but a database of another application");
}

TEST(PlanStoreFile, RefusesWhatAnotherApplicationMakesMeanwhile) {
  for (const char* lock : {"BEGIN IMMEDIATE", "BEGIN EXCLUSIVE"}) {
    const TemporaryFolder folder;
    const std::string path = folder.file("a.db");
    const Database other(path);
    other.run("PRAGMA busy_timeout = 5000");
    other.run(lock);
    other.run("PRAGMA application_id = 7; PRAGMA user_version = 1; CREATE TABLE t (a)");
    ASSERT_EQ(std::filesystem::file_size(path), 0u);
    std::thread opening([&path] { expect_store_refused<PlanStore>(path, "another application"); });
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    other.run("COMMIT");
    opening.join();
    other.run("INSERT INTO t VALUES (1)");
    EXPECT_FALSE(std::filesystem::exists(path + "-wal"));
  }
}

TEST(PlanStoreFile, IsMadeInAnEmptyFile) {
  const TemporaryFolder folder;
  write(folder.file("a.db"), "");
  EXPECT_TRUE(PlanStore::open(folder.file("a.db")));
}

TEST(PlanStoreFile, RefusesTheDatabaseOfAnotherApplication) {
  const TemporaryFolder folder;
  const std::string path = folder.file("a.db");
  Database(path).run("PRAGMA application_id = 7; CREATE TABLE closures (subject TEXT)");
  expect_store_refused_and_untouched<PlanStore>(folder, path, "another application");
}

TEST(PlanStoreFile, RefusesANewerSchema) {
  const TemporaryFolder folder;
  const std::string path = folder.file("a.db");
  ASSERT_TRUE(PlanStore::open(path));
  Database(path).run("PRAGMA journal_mode = DELETE; PRAGMA user_version = 3");
  expect_store_refused_and_untouched<PlanStore>(folder, path,
                                                "schema 3; this coapt knows schema 2");
}

TEST(PlanStoreFile, RefusesANewerSchemaThatOnlyItsLogKnows) {
  const TemporaryFolder folder;
  const std::string path = folder.file("a.db");
  ASSERT_TRUE(PlanStore::open(path));
  const Database newer(path);
  newer.run("PRAGMA user_version = 3");
  expect_store_refused<PlanStore>(path, "schema 3; this coapt knows schema 2");
}

TEST(PlanStoreFile, GoesOnInAFileOfRelease02) {
  const TemporaryFolder folder;
  const std::string path = folder.file("a.db");
  ASSERT_TRUE(PlanStore::open(path));
  Database(path).run(
      "ALTER TABLE closures RENAME COLUMN leak_mm2 TO orifice_mm2; "
      "ALTER TABLE closures ADD COLUMN gap_mm2 ANY; "
      "ALTER TABLE closures DROP COLUMN leaflet_ratio; PRAGMA user_version = 1");
  for (int opened = 0; opened < 2; ++opened) {
    Expected<PlanStore> store = PlanStore::open(path);
    ASSERT_TRUE(store);
    EXPECT_TRUE(keep_numbered(*store, "a", opened).empty());
    const Expected<KnownPlans> known = store->read("a");
    ASSERT_TRUE(known);
    expect_same(known->at(numbered_plan(opened)).at(numbered_disturbance(opened)),
                numbered_closure(opened));
  }
}

TEST(PlanStoreFile, RefusesWhatIsNoDatabase) {
  const TemporaryFolder folder;
  write(folder.file("short"), "x");
  write(folder.file("long"), std::string(10000, 'x'));
  expect_store_refused_and_untouched<PlanStore>(folder, folder.file("short"),
                                                "is not a store of plans");
  expect_store_refused_and_untouched<PlanStore>(folder, folder.file("long"), "some other file");
}

TEST(PlanStoreFile, RefusesPathsWithoutAFile) {
  const TemporaryFolder folder;
  expect_store_refused<PlanStore>(folder.path(), "Is a directory");
  expect_store_refused<PlanStore>(folder.file("missing/a.db"), "No such file or directory");
  expect_store_refused<PlanStore>("", "needs the path of a file");
  expect_store_refused<PlanStore>(":memory:", "is not a file");
}

TEST(PlanStoreFile, SaysThatItIsDamaged) {
  const TemporaryFolder folder;
  const std::string path = folder.file("a.db");
  {
    Expected<PlanStore> store = PlanStore::open(path);
    ASSERT_TRUE(store);
    for (int i = 0; i < 1000; ++i) EXPECT_TRUE(keep_numbered(*store, kSubject, i).empty());
  }
  std::string bytes = bytes_of(path);
  bytes.replace(8192, bytes.size() - 8192, bytes.size() - 8192, 'x');
  write(path, bytes);
  Expected<PlanStore> store = PlanStore::open(path);
  ASSERT_TRUE(store);
  const Expected<KnownPlans> known = store->read(kSubject);
  ASSERT_FALSE(known);
  EXPECT_EQ(known.errors()[0].message, path + ": cannot be read: database disk image is malformed");
  EXPECT_FALSE(keep_numbered(*store, kSubject, 0).empty());
}

TEST(PlanStoreFile, SaysThatItsTablesAreGone) {
  const TemporaryFolder folder;
  const std::string path = folder.file("a.db");
  ASSERT_TRUE(PlanStore::open(path));
  Database(path).run("DROP TABLE plans");
  expect_store_refused<PlanStore>(path, "cannot be opened: no such table: plans");
}

TEST(PlanStoreFile, SaysThatAnotherConnectionLocksItAndGoesOnAfterwards) {
  const TemporaryFolder folder;
  const std::string path = folder.file("a.db");
  Expected<PlanStore> store = PlanStore::open(path, 20);
  ASSERT_TRUE(store);
  EXPECT_TRUE(store->keep(kSubject, "a plan", 0, numbered_closure(0)).empty());
  const Database other(path);
  other.run("BEGIN IMMEDIATE");
  const std::vector<std::pair<std::string, std::string>> rows = {
      {kSubject, "a plan"}, {kSubject, "another"}, {"another", "a plan"}};
  for (const auto& [subject, plan] : rows) {
    const Errors errors = store->keep(subject, plan, 1, numbered_closure(1));
    ASSERT_EQ(errors.size(), 1u);
    EXPECT_EQ(errors[0].code, ErrorCode::InputOutput);
    EXPECT_EQ(errors[0].message, path + ": a closure cannot be kept: database is locked");
  }
  EXPECT_EQ(closures_in(*store->read(kSubject)), 1);
  EXPECT_TRUE(PlanStore::open(path, 20));

  other.run("COMMIT");
  for (const auto& [subject, plan] : rows)
    EXPECT_TRUE(store->keep(subject, plan, 1, numbered_closure(1)).empty());
  EXPECT_EQ(closures_in(*store->read(kSubject)), 3);
  EXPECT_EQ(closures_in(*store->read("another")), 1);
}

TEST(PlanStoreFile, IsNotOpenedWhileAnotherConnectionHoldsAll) {
  const TemporaryFolder folder;
  const std::string path = folder.file("a.db");
  ASSERT_TRUE(PlanStore::open(path));
  const Database other(path);
  other.run("PRAGMA locking_mode = EXCLUSIVE; BEGIN EXCLUSIVE; PRAGMA user_version = 1; COMMIT");
  const Expected<PlanStore> store = PlanStore::open(path, 20);
  ASSERT_FALSE(store);
  EXPECT_EQ(store.errors()[0].message, path + ": cannot be opened: database is locked");
}

}  // namespace
}  // namespace coapt
