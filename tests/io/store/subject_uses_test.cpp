// Which closures go when there are too many, of either store.
#include "io/store/subject_uses.h"

#include <gtest/gtest.h>

#include <type_traits>

#include "io/store/closure_store.h"
#include "io/store/plan_store.h"
#include "tests/io/store/plan_scene.h"
#include "tests/io/store/store_files.h"
#include "tests/io/store/store_scene.h"

namespace coapt {
namespace {

constexpr std::int64_t kDay_ms = 24 * 3600 * 1000;

void keep_ten(PlanStore& store, const std::string& subject) {
  for (int i = 0; i < 10; ++i) ASSERT_TRUE(keep_numbered(store, subject, i).empty());
}
void keep_ten(ClosureStore& store, const std::string& subject) {
  for (int i = 0; i < 10; ++i)
    ASSERT_TRUE(store.keep(subject, numbered_key(i), numbered_sample(i)).empty());
}

int kept(const PlanStore& store, const std::string& subject) {
  return closures_in(*store.read(subject));
}
int kept(const ClosureStore& store, const std::string& subject) {
  return static_cast<int>(store.read(subject)->size());
}

SubjectsInUse used(const std::set<std::string>& subjects) {
  return [subjects] { return Expected<std::set<std::string>>(subjects); };
}

SubjectsInUse nobody_asks() {
  return [] {
    ADD_FAILURE() << "asked although nothing is to go";
    return Expected<std::set<std::string>>(std::set<std::string>{});
  };
}

template <class Store>
class SubjectUses : public testing::Test {
 protected:
  SubjectUses() {
    for (const char* subject : {"a", "b", "c", "d"}) keep_ten(*store_, subject);
    note("c", 1 * kDay_ms);
    note("a", 2 * kDay_ms);
    note("b", 3 * kDay_ms);  // and d never
  }
  void note(const std::string& subject, std::int64_t now_ms) {
    EXPECT_TRUE(store_->note_use(subject, now_ms).empty());
  }
  Errors retain(const ClosureLimits& limits, const SubjectsInUse& in_use,
                std::int64_t now_ms = 4 * kDay_ms) {
    return store_->retain(limits, in_use, now_ms);
  }
  std::string subjects_left() const {
    std::string left;
    for (const char* subject : {"a", "b", "c", "d"}) {
      const int closures = kept(*store_, subject);
      EXPECT_TRUE(closures == 0 || closures == 10) << subject << ' ' << closures;
      if (closures > 0) left += subject;
    }
    return left;
  }

  const TemporaryFolder folder_;
  const std::string path_ = folder_.file("a.db");
  Expected<Store> store_ = Store::open(path_);
};
using Stores = testing::Types<PlanStore, ClosureStore>;
TYPED_TEST_SUITE(SubjectUses, Stores);

TYPED_TEST(SubjectUses, WithinTheLimitsAllStaysAndNobodyIsAsked) {
  EXPECT_TRUE(this->retain({40, 0.0}, nobody_asks()).empty());
  EXPECT_TRUE(this->retain({40, 3.5}, nobody_asks()).empty());
  EXPECT_EQ(this->subjects_left(), "abcd");
}

TYPED_TEST(SubjectUses, TheOneUsedLeastRecentlyGoesFirstAndGoesWhole) {
  EXPECT_TRUE(this->retain({39, 0.0}, used({})).empty());
  EXPECT_EQ(this->subjects_left(), "abc");
  EXPECT_TRUE(this->retain({20, 0.0}, used({})).empty());
  EXPECT_EQ(this->subjects_left(), "ab");
  this->note("a", 0);  // the order counts, not the clock
  EXPECT_TRUE(this->retain({10, 0.0}, used({})).empty());
  EXPECT_EQ(this->subjects_left(), "a");
}

TYPED_TEST(SubjectUses, ThoseInUseStayWhateverTheLimitSays) {
  EXPECT_TRUE(this->retain({15, 0.0}, used({"d", "c"})).empty());
  EXPECT_EQ(this->subjects_left(), "cd");
  EXPECT_TRUE(this->retain({1, 0.0}, used({"d", "c"})).empty());
  EXPECT_EQ(this->subjects_left(), "cd");
}

TYPED_TEST(SubjectUses, OldOnesGoWithinTheLimitOfNumber) {
  // c is three days old, a two, b one; d is known from now on
  EXPECT_TRUE(this->retain({1'000, 1.5}, used({})).empty());
  EXPECT_EQ(this->subjects_left(), "bd");
  EXPECT_TRUE(this->retain({1'000, 1.5}, used({"d"}), 10 * kDay_ms).empty());
  EXPECT_EQ(this->subjects_left(), "d");
}

TYPED_TEST(SubjectUses, IfItIsNotKnownWhoUsesThemNothingGoes) {
  const SubjectsInUse fails = [] {
    return Expected<std::set<std::string>>(Error{ErrorCode::Busy, "", "locked"});
  };
  const Errors errors = this->retain({1, 0.0}, fails);
  ASSERT_EQ(errors.size(), 1u);
  EXPECT_EQ(errors[0].code, ErrorCode::Busy);
  EXPECT_EQ(this->subjects_left(), "abcd");
}

TYPED_TEST(SubjectUses, WhatHasGoneIsKeptAgainByThoseWhoHadTheFileOpen) {
  Expected<TypeParam> other = TypeParam::open(this->path_);
  ASSERT_TRUE(other);
  keep_ten(*other, "a");  // are there already
  EXPECT_TRUE(this->retain({1, 0.0}, used({})).empty());
  EXPECT_EQ(this->subjects_left(), "");
  keep_ten(*this->store_, "b");
  keep_ten(*other, "a");
  EXPECT_EQ(this->subjects_left(), "ab");
  EXPECT_EQ(kept(*other, "b"), 10);
}

TYPED_TEST(SubjectUses, AFileOfAnEarlierVersionHasItsSubjectsNotedFromNowOn) {
  Database(this->path_).run("DROP TABLE uses");
  this->store_ = TypeParam::open(this->path_);
  ASSERT_TRUE(this->store_);
  this->note("d", 0);
  EXPECT_TRUE(this->retain({10, 0.0}, used({})).empty());
  EXPECT_EQ(this->subjects_left(), "d");
}

TYPED_TEST(SubjectUses, MoreThanOneStepOfRemovingLeavesNothing) {
  TypeParam& store = *this->store_;
  Database database(this->path_);
  database.run("PRAGMA synchronous = OFF");
  // 25,000 closures of "e", out of the ten of "a"
  if constexpr (std::is_same_v<TypeParam, PlanStore>)
    database.run(
        "INSERT INTO subjects (name) VALUES ('e'); WITH RECURSIVE n (i) AS (SELECT 0 UNION ALL "
        "SELECT i + 1 FROM n WHERE i < 24999) INSERT INTO closures SELECT (SELECT number FROM "
        "subjects WHERE name = 'e'), (SELECT min(number) FROM plans), i, 0, 0, 1.0, 1.0, 1.0, 1.0, "
        "1.0 "
        "FROM n");
  else
    database.run(
        "WITH RECURSIVE n (i) AS (SELECT 0 UNION ALL SELECT i + 1 FROM n WHERE i < 24999) INSERT "
        "INTO closures SELECT 'e', i, 0, 0, 0, 0, 0, 0, 0, 0, 1.0, 1.0, 1 FROM n");
  EXPECT_EQ(kept(store, "e"), 25'000);
  EXPECT_TRUE(this->retain({40, 0.0}, used({"a", "b", "c", "d"})).empty());
  EXPECT_EQ(kept(store, "e"), 0);
  EXPECT_EQ(this->subjects_left(), "abcd");
}

TEST(PlanStore, PlansThatNoClosureIsOfGoWithTheLast) {
  const TemporaryFolder folder;
  const std::string path = folder.file("a.db");
  Expected<PlanStore> store = PlanStore::open(path);
  ASSERT_TRUE(store);
  EXPECT_TRUE(store->keep("a", "shared", 0, numbered_closure(0)).empty());
  EXPECT_TRUE(store->keep("a", "of a alone", 0, numbered_closure(1)).empty());
  EXPECT_TRUE(store->keep("b", "shared", 0, numbered_closure(2)).empty());
  EXPECT_TRUE(store->note_use("b", 0).empty());
  EXPECT_TRUE(store->retain({1, 0.0}, used({}), 0).empty());
  EXPECT_TRUE(store->keep("b", "of a alone", 0, numbered_closure(3)).empty());
  const Expected<KnownPlans> known = store->read("b");
  ASSERT_TRUE(known);
  ASSERT_EQ(known->size(), 2u);
  expect_same(known->at("shared").at(0), numbered_closure(2));
  expect_same(known->at("of a alone").at(0), numbered_closure(3));
  EXPECT_TRUE(store->read("a")->empty());
}

}  // namespace
}  // namespace coapt
