#include "search/population/population_records.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "core/repair/apply_plan.h"
#include "io/json/population_prior_json.h"
#include "search/population/population_findings.h"
#include "search/population/population_tree.h"
#include "tests/scenes/small_preset.h"

namespace coapt {
namespace {

int named(const std::string& name) {
  for (int c = 0; c < kCandidates; ++c)
    if (candidate_repairs()[c].name == name) return c;
  ADD_FAILURE() << name;
  return 0;
}

TEST(Candidates, HaveNamesOfTheirOwnAndOwnRingsComeFirst) {
  ASSERT_EQ(candidate_repairs().size(), std::size_t{kCandidates});
  std::set<std::string> names;
  for (const CandidateRepair& candidate : candidate_repairs()) names.insert(candidate.name);
  EXPECT_EQ(names.size(), std::size_t{kCandidates});
  for (int sizes = 0; sizes <= 4; ++sizes) {
    EXPECT_EQ(candidate_repairs()[sizes].family, RepairFamily::OwnRing);
    EXPECT_EQ(candidate_repairs()[sizes].sizes_below, sizes);
  }
}

TEST(Candidates, SuturesMoveTheirMusclesSoFarAlsoBesideARing) {
  const Valve& valve = small_preset("human-functional-mr");
  const CandidateSite site = candidate_site(valve);
  for (const CandidateRepair& candidate : candidate_repairs()) {
    if (candidate.movement_mm == 0.0) continue;
    const Valve repaired = *apply_plan(valve, *candidate_plan(candidate, site));
    for (const Side side : {Side::Posteromedial, Side::Anterolateral}) {
      const bool moves = side == Side::Posteromedial || candidate.both_muscles;
      EXPECT_NEAR((papillary_tip_mm(repaired, side) - papillary_tip_mm(valve, side)).norm(),
                  moves ? candidate.movement_mm : 0.0, 1e-9)
          << candidate.name;
    }
  }
}

TEST(Candidates, RepairAFlailLeaflet) {
  const Valve& valve = small_preset("fibroelastic-flail");
  const CandidateSite site = candidate_site(valve);
  EXPECT_NEAR(site.lesion_along, 0.5, 0.05);
  const RepairPlan plan = *candidate_plan(
      candidate_repairs()[named("2 neochordae, 100 % of intact chordae, ring")], site);
  EXPECT_EQ(plan.steps.size(), 3u);
  EXPECT_EQ(apply_plan(valve, plan)->chordae.size(), valve.chordae.size() + 2);
}

TEST(Candidates, ARingThatPracticeRejectsGivesWayToTheNextLargerOne) {
  Valve valve = small_preset("human-functional-mr");
  const auto ring_of = [&valve](std::size_t candidate) {
    const RepairPlan plan = *candidate_plan(candidate_repairs()[candidate], candidate_site(valve));
    return std::get<Annuloplasty>(plan.steps.front()).ring;
  };
  EXPECT_EQ(std::get<OwnRing>(ring_of(4)).sizes_below, 4);
  // Taller leaflets and a wider annulus: four sizes of its width are more than four of its area below the true one.
  valve.annulus_mm.col(0) *= 1.31;
  valve.rest_mm *= 1.5;
  EXPECT_EQ(std::get<OwnRing>(ring_of(4)).sizes_below, 3);
  EXPECT_EQ(std::get<OwnRing>(ring_of(3)).sizes_below, 3);
}

/// Flail valves of the usual anatomy: hardly a draw is rejected.
Population few() {
  Population population{adult_prior(), 7, {}};
  population.prior.anatomy.clear();
  population.prior.correlations.clear();
  for (AetiologyPrior& aetiology : population.prior.aetiologies)
    if (aetiology.aetiology != Aetiology::P2Flail) aetiology.share = 1e-6;
  for (int i = 0; i < 2; ++i) population.members.push_back(*member(population.prior, 7, i));
  return population;
}

TEST(PopulationRecords, AreTheSameBytesForEveryNumberOfThreadsAndRange) {
  const Population population = few();
  PopulationRecordOptions options;
  options.nodes = 2;
  options.threads = 2;
  const std::string both = population_records(population, options, 0, 2);
  options.threads = 1;
  EXPECT_EQ(population_records(population, options, 1, 1), both.substr(both.size() / 2));
  const std::vector<PopulationRecord> records = *unpack_records(both);
  EXPECT_FALSE(unpack_records(both.substr(1)));
  EXPECT_TRUE(unpack_records("")->empty());
  for (const PopulationRecord& record : records) {
    EXPECT_EQ(record.made, 1);
    EXPECT_FLOAT_EQ(
        record.leak_mm2,
        static_cast<float>(population.members[static_cast<std::size_t>(record.index)].leak_mm2));
    const auto of = [&](const std::string& name) {
      return record.candidates[static_cast<std::size_t>(named(name))];
    };
    EXPECT_EQ(of("posteromedial muscle 3 mm towards the trigone").state,
              static_cast<int>(CandidateState::NotOffered));
    EXPECT_LT(of("own ring, 3 sizes below").mean_mm2, of("own ring, not undersized").mean_mm2);
    EXPECT_TRUE(is_closed(of("clip alone")));
  }
}

/// A record whose candidates all cost 50, one of them nothing.
PopulationRecord record_with(int index, float leak, int best) {
  PopulationRecord record;
  record.index = index;
  record.made = 1;
  record.leak_mm2 = leak;
  record.features[11] = leak;
  for (CandidateRecord& candidate : record.candidates)
    candidate = {static_cast<int>(CandidateState::Closed), 0, 50.0f, 9.0f, 9.0f, 0.0f};
  record.candidates[static_cast<std::size_t>(best)] = {
      static_cast<int>(CandidateState::Closed), 0, 0.0f, 1.0f, 1.0f, 0.0f};
  return record;
}

TEST(PopulationTree, IsJudgedOnMembersThatItHasNotSeen) {
  // Small leaks want an undersized ring, large ones a clip; the judged members follow the rule.
  const int ring = named("own ring, 2 sizes below"), clip = named("clip alone");
  std::vector<PopulationRecord> records;
  for (int i = 0; i < 80; ++i)
    records.push_back(record_with(i, i % 8 < 4 ? 10.0f : 30.0f, i % 8 < 4 ? ring : clip));
  const PopulationTree tree = population_tree(records);
  EXPECT_EQ(tree.grown_on, 40);
  EXPECT_EQ(tree.pruned_on, 20);
  EXPECT_EQ(tree.judged_on, 20);
  EXPECT_EQ(leaves(tree.tree), 2);
  EXPECT_EQ(tree.of_tree.cost.mean, 0.0);
  EXPECT_NEAR(tree.of_single.cost.mean, 25.0, 1e-9);
  EXPECT_NEAR(tree.of_single.leak_mm2.mean, 4.0, 1e-6);
  EXPECT_EQ(tree_in_words(tree.tree),
            (std::vector<std::string>{"If leak below 20 mm2:", "  own ring, 2 sizes below",
                                      "If leak 20 mm2 or more:", "  clip alone"}));
}

TEST(PopulationFindings, CountWinsTiesAndAnchors) {
  Population population{adult_prior(), 1, std::vector<PopulationMember>(2)};
  const int trigone = named("posteromedial muscle 3 mm towards the trigone");
  std::vector<PopulationRecord> records = {record_with(0, 20.0f, trigone),
                                           record_with(1, 20.0f, named("clip alone"))};
  records[1].candidates[static_cast<std::size_t>(trigone)].cost = 0.5f;  // as good as the clip
  records[1].candidates[static_cast<std::size_t>(trigone)].mean_mm2 = 9.1f;
  const GroupFindings all = population_findings(population, records).front();
  const FamilyWins& sutures = all.families[static_cast<std::size_t>(RepairFamily::Papillary)];
  EXPECT_EQ(sutures.wins, 1);
  EXPECT_EQ(sutures.as_good, 2);
  // 1 against 9 mm2 is better, 9.1 against 9 the same.
  EXPECT_EQ(all.anchors.front().members, 2);
  EXPECT_EQ(all.anchors.front().trigone_better, 1);
  EXPECT_EQ(all.anchors.front().same, 1);
  EXPECT_NEAR(all.anchors.front().difference_mm2.mean, (-8.0 + 0.1) / 2.0, 1e-6);
}

}  // namespace
}  // namespace coapt
