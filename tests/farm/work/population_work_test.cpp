#include "farm/work/population_work.h"

#include <gtest/gtest.h>

#include <cmath>

#include "io/json/population_json.h"
#include "io/json/population_prior_json.h"

namespace coapt {
namespace {

constexpr int kMembers = 2;

const Population& drawn() {
  static const Population kPopulation = [] {
    Population population{adult_prior(), 3, {}};
    for (int i = 0; i < kMembers; ++i)
      population.members.push_back(*member(population.prior, population.seed, i));
    return population;
  }();
  return kPopulation;
}

TEST(PopulationWork, MembersAreThoseThatAreDrawnHereToTheBit) {
  const Population& population = drawn();
  const Expected<Work> work =
      open_work(members_request(population.prior, population.seed, kMembers));
  ASSERT_TRUE(work);
  EXPECT_EQ(work->items, kMembers);
  const Expected<std::vector<PopulationMember>> answers =
      member_answers(work->compute(0, 1, 1) + work->compute(1, 1, 2));
  ASSERT_TRUE(answers);
  ASSERT_EQ(answers->size(), population.members.size());
  const std::string first = work->compute(0, 1, 1);
  EXPECT_EQ(work->objection(0, 1, first), "");
  EXPECT_NE(work->objection(1, 1, first), "") << "another member";
  for (std::size_t i = 0; i < answers->size(); ++i)
    EXPECT_EQ(to_json((*answers)[i]), to_json(population.members[i]));
}

TEST(PopulationWork, RecordsAreThoseThatAreWorkedOutHereToTheBit) {
  const Population& population = drawn();
  PopulationRecordOptions options;
  options.nodes = 1;
  const Expected<WorkRequest> request = records_request(population, kMembers, options);
  ASSERT_TRUE(request);
  const Expected<Work> work = open_work(*request);
  ASSERT_TRUE(work);
  const std::string bytes = population_records(population, options, 0, kMembers);
  EXPECT_EQ(work->compute(0, 1, 2) + work->compute(1, 1, 1), bytes);
  EXPECT_EQ(work->objection(0, kMembers, bytes), "");
  EXPECT_NE(work->objection(1, 1, bytes.substr(0, bytes.size() / 2)), "") << "of another member";
  const auto objection = [&](auto change) {
    PopulationRecord record = unpack_records(bytes)->front();
    change(record);
    return work->objection(0, 1, {reinterpret_cast<const char*>(&record), sizeof record});
  };
  EXPECT_EQ(objection([](PopulationRecord&) {}), "");
  EXPECT_NE(objection([](PopulationRecord& record) { record.aetiology = 99; }), "");
  EXPECT_NE(objection([](PopulationRecord& record) { record.features[3] = NAN; }), "");
  EXPECT_NE(objection([](PopulationRecord& record) { record.candidates[0].state = -1; }), "");
  EXPECT_NE(objection([](PopulationRecord& record) { record.candidates[0].failures = 2; }), "");
}

TEST(PopulationWork, NamesWhatIsWrongWithARequest) {
  WorkRequest request = members_request(adult_prior(), 1, 5);
  request.parts.front() = R"({"prior": 2, "seed": 1, "members": 0})";
  const Expected<Work> work = open_work(request);
  ASSERT_FALSE(work);
  ASSERT_EQ(work.errors().size(), 2u);
  EXPECT_EQ(work.errors()[0].path, "/prior");
  EXPECT_EQ(work.errors()[1].path, "/members");
}

}  // namespace
}  // namespace coapt
