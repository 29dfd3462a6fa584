#include "search/population/population.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/closure/closure.h"
#include "core/metrics/measure.h"
#include "io/json/population_json.h"
#include "io/json/population_prior_json.h"
#include "search/parallel.h"
#include "search/plans/objective.h"
#include "search/population/population_factors.h"
#include "search/population/truncated_normal.h"

namespace coapt {
namespace {

double leak_of(const Valve& valve) {
  const ClosureResult closure = close_valve(valve);
  EXPECT_TRUE(trusted(closure)) << valve.name;
  return measure(valve, closure).leak.area_mm2;
}

TEST(TruncatedNormal, OfFarEndsIsTheNormalOne) {
  const PriorDistribution wide{10.0, 2.0, -90.0, 110.0};
  EXPECT_NEAR(truncated_normal(wide, 1.5), 13.0, 1e-7);
  EXPECT_NEAR(cut_moments(wide).sd, 2.0, 1e-12);
}

TEST(TruncatedNormal, CutInTheMiddleIsAHalfNormal) {
  const PriorDistribution half{0.0, 1.0, 0.0, 50.0};
  EXPECT_NEAR(cut_moments(half).mean, std::sqrt(2.0 / 3.14159265358979), 1e-9);
  EXPECT_NEAR(cut_moments(half).sd, std::sqrt(1.0 - 2.0 / 3.14159265358979), 1e-9);
  // The median of a half normal is the third quartile of the whole.
  EXPECT_NEAR(truncated_normal(half, 0.0), 0.67448975, 1e-7);
  EXPECT_NEAR(share_below(half, 0.67448975), 0.5, 1e-7);
}

TEST(Prior, OfAdultsIsAcceptedAndComesBackFromItsJson) {
  const PopulationPrior prior = adult_prior();
  EXPECT_TRUE(check_prior(prior).empty());
  EXPECT_EQ(prior.anatomy.size(), std::size_t{kAnatomyFactors});
  const Expected<PopulationPrior> again = read_prior(to_json(prior).dump());
  ASSERT_TRUE(again);
  EXPECT_EQ(to_json(*again), to_json(prior));
}

TEST(Prior, CorrelationsThatContradictEachOtherAreRefused) {
  PopulationPrior prior = adult_prior();
  prior.correlations = {{0, 1, 0.9, "", false}, {1, 2, 0.9, "", false}, {0, 2, -0.9, "", false}};
  const Errors errors = check_prior(prior);
  ASSERT_EQ(errors.size(), 1u);
  EXPECT_EQ(errors[0].path, "/correlations");
}

TEST(Prior, ProblemsNameTheirPlace) {
  PopulationPrior prior = adult_prior();
  prior.anatomy[0].distribution.mean = 200.0;
  prior.aetiologies[1].share = 0.0;
  const Errors errors = check_prior(prior);
  ASSERT_EQ(errors.size(), 3u);
  EXPECT_EQ(errors[0].path, "/anatomy/ap_mm/mean");
  EXPECT_EQ(errors[2].path, "/aetiologies/1/share");
}

TEST(Prior, AMeanAtEitherEndIsAccepted) {
  PopulationPrior prior = adult_prior();
  PriorDistribution& first = prior.anatomy[0].distribution;
  for (const double end : {first.min, first.max}) {
    first.mean = end;
    EXPECT_TRUE(check_prior(prior).empty()) << end;
  }
}

TEST(Factors, OfTheUsualAnatomyGiveTheHumanPreset) {
  const HumanValve ours = healthy_valve(usual_anatomy()), preset = human_normal();
  EXPECT_EQ(ours.dimensions.ap_mm, preset.dimensions.ap_mm);
  EXPECT_EQ(ours.dimensions.asymmetry.tip_mm, preset.dimensions.asymmetry.tip_mm);
  EXPECT_EQ(ours.dimensions.slack, preset.dimensions.slack);
  const Proportions heights = proportions(preset.dimensions, 29.0, 39.0);
  EXPECT_EQ(ours.dimensions.anterior_height_mm, heights.anterior_height_mm);
  EXPECT_EQ(ours.dimensions.lateral_height_mm, heights.lateral_height_mm);
  EXPECT_EQ(ours.dimensions.tissue, preset.dimensions.tissue);
}

TEST(Members, AreCompetentBeforeDiseaseLeakAfterItAndDoNotDependOnThreads) {
  constexpr int kCount = 2;
  Population population{adult_prior(), 7, std::vector<PopulationMember>(kCount)};
  // Flail valves leak at once; of others up to 40 lesions are drawn.
  for (AetiologyPrior& aetiology : population.prior.aetiologies)
    if (aetiology.aetiology != Aetiology::P2Flail) aetiology.share = 1e-6;
  for_each_index(kCount, 2, [&](int i) {
    population.members[static_cast<std::size_t>(i)] = *member(population.prior, 7, i);
  });
  for (const PopulationMember& drawn : population.members) {
    EXPECT_EQ(leak_of(*make_healthy_valve(drawn)), drawn.leak_healthy_mm2);
    EXPECT_EQ(leak_of(*make_valve(drawn)), drawn.leak_mm2);
    EXPECT_LE(drawn.leak_healthy_mm2, kMildLeak_mm2);
    EXPECT_GT(drawn.leak_mm2, kMildLeak_mm2);
    const DrawCounts& d = drawn.draws;
    EXPECT_EQ(d.anatomies - d.anatomies_invalid - d.anatomies_untrusted - d.anatomies_leaking -
                  d.anatomies_resistant,
              1);
    EXPECT_EQ(d.lesions - d.lesions_invalid - d.lesions_untrusted - d.lesions_competent, 1);
  }
  Population again = population;
  again.members.back() = *member(population.prior, 7, kCount - 1);
  const std::string text = to_json(population).dump();
  EXPECT_EQ(to_json(again).dump(), text);
  const Expected<Population> read = read_population(text);
  ASSERT_TRUE(read);
  EXPECT_EQ(to_json(*read).dump(), text);
}

TEST(Members, HaveTheCorrelationsOfTheirPrior) {
  // Two dimensions alone, wide enough that neither end is near: as the copula is the normal one, r itself comes back.
  PopulationPrior prior;
  prior.anatomy = {{0, {29.0, 3.0, 14.0, 44.0}, "", false},
                   {1, {39.0, 5.0, 14.0, 64.0}, "", false}};
  prior.correlations = {{0, 1, 0.7, "", false}};
  constexpr int kDraws = 2000;
  double sum = 0.0;
  std::mt19937_64 engine(1);
  for (int i = 0; i < kDraws; ++i) {
    const AnatomyValues drawn = draw_anatomy(prior, engine);
    sum += (drawn[0] - 29.0) / 3.0 * ((drawn[1] - 39.0) / 5.0);
    EXPECT_EQ(drawn[2], usual_anatomy()[2]);
  }
  EXPECT_NEAR(sum / kDraws, 0.7, 3.0 * 1.22 / std::sqrt(kDraws));  // sd of a product: sqrt(1 + r^2)
}

}  // namespace
}  // namespace coapt
