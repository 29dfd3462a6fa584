#include "io/store/closure_store.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <filesystem>
#include <limits>
#include <utility>

#include "tests/io/store/store_files.h"
#include "tests/io/store/store_scene.h"

namespace coapt {
namespace {

void expect_same(const OrificeSample& a, const OrificeSample& b) {
  EXPECT_EQ(std::bit_cast<std::uint64_t>(a.area_mm2), std::bit_cast<std::uint64_t>(b.area_mm2));
  EXPECT_EQ(std::bit_cast<std::uint64_t>(a.sd_mm2), std::bit_cast<std::uint64_t>(b.sd_mm2));
  EXPECT_EQ(a.trusted, b.trusted);
}

TEST(ClosureStore, GivesBackWhatItKeptBitForBit) {
  using Limits = std::numeric_limits<double>;
  const TemporaryFolder folder;
  Expected<ClosureStore> store = ClosureStore::open(folder.file("a.db"));
  ASSERT_TRUE(store);
  const std::vector<double> values = {0.0,
                                      -0.0,
                                      1.0,
                                      -3.0,
                                      0.1,
                                      4503599627370497.0,
                                      1e300,
                                      Limits::denorm_min(),
                                      -Limits::min() / 2,
                                      Limits::min(),
                                      Limits::max(),
                                      Limits::infinity(),
                                      std::nextafter(1.0, 2.0)};
  for (std::size_t i = 0; i < values.size(); ++i) {
    const OrificeSample sample = {values[i], values[values.size() - 1 - i], i % 2 == 0};
    EXPECT_TRUE(store->keep(kSubject, numbered_key(static_cast<int>(i)), sample).empty());
  }
  const Expected<KnownOrifices> known = store->read(kSubject);
  ASSERT_TRUE(known);
  ASSERT_EQ(known->size(), values.size());
  for (std::size_t i = 0; i < values.size(); ++i)
    expect_same(known->at(numbered_key(static_cast<int>(i))),
                {values[i], values[values.size() - 1 - i], i % 2 == 0});
}

TEST(ClosureStore, KeepsWhatCannotBeMadeAsNaN) {
  const TemporaryFolder folder;
  Expected<ClosureStore> store = ClosureStore::open(folder.file("a.db"));
  ASSERT_TRUE(store);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(store->keep(kSubject, numbered_key(0), {nan, 0.0, false}).empty());
  EXPECT_TRUE(store->keep(kSubject, numbered_key(1), {2.0, nan, true}).empty());
  const Expected<KnownOrifices> known = store->read(kSubject);
  ASSERT_TRUE(known);
  EXPECT_TRUE(std::isnan(known->at(numbered_key(0)).area_mm2));
  EXPECT_EQ(known->at(numbered_key(0)).sd_mm2, 0.0);
  EXPECT_TRUE(std::isnan(known->at(numbered_key(1)).sd_mm2));
}

TEST(ClosureStore, TellsKeysApartByEachOfTheirNumbers) {
  const TemporaryFolder folder;
  Expected<ClosureStore> store = ClosureStore::open(folder.file("a.db"));
  ASSERT_TRUE(store);
  using Limits = std::numeric_limits<std::int64_t>;
  KnownOrifices kept;
  for (std::size_t i = 0; i < ConfigurationKey{}.size(); ++i) {
    for (const std::int64_t value :
         {std::int64_t{-7}, std::int64_t{7}, Limits::min(), Limits::max()}) {
      ConfigurationKey key{};
      key[i] = value;
      kept[key] = {static_cast<double>(kept.size()), 0.0, true};
    }
  }
  for (const auto& [key, sample] : kept) EXPECT_TRUE(store->keep(kSubject, key, sample).empty());
  const Expected<KnownOrifices> known = store->read(kSubject);
  ASSERT_TRUE(known);
  ASSERT_EQ(known->size(), 36u);
  for (const auto& [key, sample] : kept) expect_same(known->at(key), sample);
}

TEST(ClosureStore, TheFirstAnswerStays) {
  const TemporaryFolder folder;
  Expected<ClosureStore> store = ClosureStore::open(folder.file("a.db"));
  ASSERT_TRUE(store);
  EXPECT_TRUE(store->keep(kSubject, numbered_key(0), {1.0, 0.5, true}).empty());
  EXPECT_TRUE(store->keep(kSubject, numbered_key(0), {2.0, 0.0, false}).empty());
  const Expected<KnownOrifices> known = store->read(kSubject);
  ASSERT_TRUE(known);
  ASSERT_EQ(known->size(), 1u);
  expect_same(known->at(numbered_key(0)), {1.0, 0.5, true});
}

TEST(ClosureStore, TwoSubjectsDoNotSeeEachOther) {
  const TemporaryFolder folder;
  Expected<ClosureStore> store = ClosureStore::open(folder.file("a.db"));
  ASSERT_TRUE(store);
  EXPECT_TRUE(store->keep("a", numbered_key(0), {1.0, 0.0, true}).empty());
  EXPECT_TRUE(store->keep("b", numbered_key(0), {2.0, 0.0, true}).empty());
  const Expected<KnownOrifices> a = store->read("a"), b = store->read("b"), c = store->read("c");
  ASSERT_TRUE(a && b && c);
  EXPECT_EQ(a->at(numbered_key(0)).area_mm2, 1.0);
  EXPECT_EQ(b->at(numbered_key(0)).area_mm2, 2.0);
  EXPECT_TRUE(c->empty());
}

TEST(ClosureStore, KeepsAllWhenMovedClosedAndOpenedAgain) {
  const TemporaryFolder folder;
  const std::string path = folder.file("100% #1?.db");
  for (int round = 0; round < 3; ++round) {
    Expected<ClosureStore> opened = ClosureStore::open(path);
    ASSERT_TRUE(opened);
    ClosureStore store = *std::move(opened);
    EXPECT_TRUE(store.keep(kSubject, numbered_key(round), numbered_sample(round)).empty());
    const Expected<KnownOrifices> known = store.read(kSubject);
    ASSERT_TRUE(known);
    ASSERT_EQ(known->size(), static_cast<std::size_t>(round) + 1);
    for (int i = 0; i <= round; ++i) expect_same(known->at(numbered_key(i)), numbered_sample(i));
  }
  EXPECT_FALSE(std::filesystem::exists(path + "-wal"));
}

TEST(ClosureStore, IsMadeInAnEmptyFile) {
  const TemporaryFolder folder;
  write(folder.file("a.db"), "");
  EXPECT_TRUE(ClosureStore::open(folder.file("a.db")));
}

TEST(ClosureStore, TwoStoresShareAFile) {
  const TemporaryFolder folder;
  Expected<ClosureStore> a = ClosureStore::open(folder.file("a.db"));
  Expected<ClosureStore> b = ClosureStore::open(folder.file("a.db"));
  ASSERT_TRUE(a && b);
  EXPECT_TRUE(a->keep(kSubject, numbered_key(0), {1.0, 0.0, true}).empty());
  EXPECT_TRUE(b->keep(kSubject, numbered_key(0), {2.0, 0.0, true}).empty());
  EXPECT_TRUE(b->keep(kSubject, numbered_key(1), {3.0, 0.0, true}).empty());
  const Expected<KnownOrifices> known = a->read(kSubject);
  ASSERT_TRUE(known);
  EXPECT_EQ(known->at(numbered_key(0)).area_mm2, 1.0);
  EXPECT_EQ(known->at(numbered_key(1)).area_mm2, 3.0);
}

TEST(ClosureStore, RefusesTheDatabaseOfAnotherApplication) {
  const TemporaryFolder folder;
  const std::string path = folder.file("a.db");
  Database(path).run("PRAGMA application_id = 7; CREATE TABLE closures (subject TEXT)");
  expect_store_refused_and_untouched<ClosureStore>(folder, path, "another application");
}

TEST(ClosureStore, RefusesADatabaseOfNoApplication) {
  const TemporaryFolder folder;
  const std::string path = folder.file("a.db");
  Database(path).run("CREATE TABLE t (a)");
  expect_store_refused_and_untouched<ClosureStore>(folder, path, "another application");
}

TEST(ClosureStore, LeavesTheLogOfAnotherApplicationAlone) {
  const TemporaryFolder folder;
  const Database other(folder.file("other.db"));
  other.run("PRAGMA journal_mode = WAL; CREATE TABLE t (a); INSERT INTO t VALUES (1)");
  const std::string path = folder.file("copy.db");  // as if its application had been killed
  for (const char* end : {"", "-wal"})
    std::filesystem::copy_file(folder.file("other.db") + end, path + end);
  ASSERT_GT(std::filesystem::file_size(path + "-wal"), 0u);
  expect_store_refused_and_untouched<ClosureStore>(folder, path, "another application");
}

TEST(ClosureStore, RefusesANewerSchema) {
  const TemporaryFolder folder;
  const std::string path = folder.file("a.db");
  ASSERT_TRUE(ClosureStore::open(path));
  Database(path).run("PRAGMA journal_mode = DELETE; PRAGMA user_version = 2");
  expect_store_refused_and_untouched<ClosureStore>(folder, path,
                                                   "schema 2; this coapt knows schema 1");
}

TEST(ClosureStore, RefusesANewerSchemaThatOnlyItsLogKnows) {
  const TemporaryFolder folder;
  const std::string path = folder.file("a.db");
  ASSERT_TRUE(ClosureStore::open(path));
  const Database newer(path);
  newer.run("PRAGMA user_version = 2");
  expect_store_refused<ClosureStore>(path, "schema 2; this coapt knows schema 1");
  newer.run("PRAGMA wal_checkpoint(TRUNCATE)");
  expect_store_refused<ClosureStore>(path, "schema 2; this coapt knows schema 1");
}

TEST(ClosureStore, RefusesWhatIsNoDatabase) {
  const TemporaryFolder folder;
  write(folder.file("short"), "x");
  write(folder.file("long"), std::string(10000, 'x'));
  write(folder.file("cut"), std::string("SQLite format 3\0", 16));
  expect_store_refused_and_untouched<ClosureStore>(folder, folder.file("short"), "some other file");
  expect_store_refused_and_untouched<ClosureStore>(folder, folder.file("long"), "some other file");
  expect_store_refused_and_untouched<ClosureStore>(folder, folder.file("cut"),
                                                   "another application");
}

TEST(ClosureStore, RefusesPathsWithoutAFile) {
  const TemporaryFolder folder;
  expect_store_refused<ClosureStore>(folder.path(), "Is a directory");
  expect_store_refused<ClosureStore>(folder.file("missing/a.db"), "No such file or directory");
  expect_store_refused<ClosureStore>("", "needs the path of a file");
  expect_store_refused<ClosureStore>(":memory:", "is not a file");
  expect_store_refused<ClosureStore>("/dev/null", "cannot be opened");
}

TEST(ClosureStore, SaysThatItIsDamaged) {
  const TemporaryFolder folder;
  const std::string path = folder.file("a.db");
  {
    Expected<ClosureStore> store = ClosureStore::open(path);
    ASSERT_TRUE(store);
    for (int i = 0; i < 1000; ++i)
      EXPECT_TRUE(store->keep(kSubject, numbered_key(i), numbered_sample(i)).empty());
  }
  std::string bytes = bytes_of(path);
  bytes.replace(8192, bytes.size() - 8192, bytes.size() - 8192, 'x');
  write(path, bytes);
  Expected<ClosureStore> store = ClosureStore::open(path);
  ASSERT_TRUE(store);
  const Expected<KnownOrifices> known = store->read(kSubject);
  ASSERT_FALSE(known);
  EXPECT_EQ(known.errors()[0].message, path + ": cannot be read: database disk image is malformed");
  EXPECT_FALSE(store->keep(kSubject, numbered_key(0), {}).empty());
}

TEST(ClosureStore, SaysThatAnotherConnectionLocksIt) {
  const TemporaryFolder folder;
  const std::string path = folder.file("a.db");
  Expected<ClosureStore> store = ClosureStore::open(path, 20);
  ASSERT_TRUE(store);
  EXPECT_TRUE(store->keep(kSubject, numbered_key(0), numbered_sample(0)).empty());
  const Database other(path);
  other.run("BEGIN IMMEDIATE");
  const Errors errors = store->keep(kSubject, numbered_key(1), numbered_sample(1));
  ASSERT_EQ(errors.size(), 1u);
  EXPECT_EQ(errors[0].code, ErrorCode::InputOutput);
  EXPECT_EQ(errors[0].message, path + ": a closure cannot be kept: database is locked");
  EXPECT_EQ(store->read(kSubject)->size(), 1u);
  EXPECT_TRUE(ClosureStore::open(path, 20));

  other.run("COMMIT");
  EXPECT_TRUE(store->keep(kSubject, numbered_key(1), numbered_sample(1)).empty());
  EXPECT_EQ(store->read(kSubject)->size(), 2u);
}

TEST(ClosureStore, IsNotOpenedWhileAnotherConnectionHoldsAll) {
  const TemporaryFolder folder;
  const std::string path = folder.file("a.db");
  ASSERT_TRUE(ClosureStore::open(path));
  const Database other(path);
  other.run("PRAGMA locking_mode = EXCLUSIVE; BEGIN EXCLUSIVE; PRAGMA user_version = 1; COMMIT");
  const Expected<ClosureStore> store = ClosureStore::open(path, 20);
  ASSERT_FALSE(store);
  EXPECT_EQ(store.errors()[0].message, path + ": cannot be opened: database is locked");
}

}  // namespace
}  // namespace coapt
