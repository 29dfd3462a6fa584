#include "lab/lattices/solved_front.h"

#include <cmath>

#include "lab/lattices/front_runs.h"
#include "lab/lattices/opening_file.h"
#include "tests/search/plans/search_scene.h"

namespace coapt {
namespace {

/// Rings and sutures of the posteromedial muscle by 2 mm: small rings and tight sutures close the valve, small rings open less.
SolvedFront solved_front() {
  LatticeCase lattice{"functional", fitting_valve(), {}};
  lattice.rules.suture_lattice_mm = 2.0;
  lattice.rules.forbidden = {
      "papillary_approximation:anterolateral", "papillary_approximation:annulus_point",
      "annuloplasty:generic-etlogix-like", "annuloplasty:generic-geoform-like"};
  SearchContext context;
  context.evaluate = scene::leak_of([](const Valve& valve) {
    return 2.0 * std::max(0.0, 6.0 - scene::moved_mm(valve, Side::Posteromedial) -
                                   ring_sizes_below(fitting_valve(), valve));
  });
  context.open = [](const Valve& valve) {
    PlanOpening opening;
    opening.measure.opening_area_mm2 = opening.measure.projected_area_mm2 =
        400.0 - 40.0 * ring_sizes_below(fitting_valve(), valve);
    return opening;
  };
  return *solve_front(lattice, 1, context, {}, {});
}

TEST(SolvedFront, EveryPlanHasItsPriceAndWhatPracticeAcceptsATradeOff) {
  const SolvedFront front = solved_front();
  std::vector<TradeOff> accepted;
  int rejected = 0;
  for (const PlanOutcome& outcome : front.outcomes) {
    if (!outcome.trade_off) {
      rejected += outcome.closures == 1 && outcome.leak_mm2 > kMildLeak_mm2;
      continue;
    }
    accepted.push_back(*outcome.trade_off);
    EXPECT_GE(outcome.closures, kChosenBy + kOpeningClosures);
    EXPECT_EQ(outcome.leak_mm2, outcome.trade_off->leak_mm2);
  }
  EXPECT_GT(rejected, 0) << "a closure says that it leaks";
  EXPECT_GT(accepted.size(), 10u);
  EXPECT_EQ(front.volume, dominated_volume(accepted));
}

TEST(SolvedFront, TheVolumeRisesToAllOfItAndEachPlanIsPaidForOnce) {
  const SolvedFront front = solved_front();
  std::vector<int> twice;
  int closures = 0;
  for (std::size_t i = 0; i < front.outcomes.size(); ++i) {
    twice.insert(twice.end(), 2, static_cast<int>(i));
    closures += front.outcomes[i].closures;
  }
  const VolumeRise rise = volume_rise(front, twice);
  for (std::size_t i = 1; i < rise.size(); ++i) {
    EXPECT_GT(rise[i].first, rise[i - 1].first);
    EXPECT_GT(rise[i].second, rise[i - 1].second);
  }
  EXPECT_DOUBLE_EQ(rise.back().second, 1.0);
  EXPECT_LE(rise.back().first, closures);
}

TEST(FrontRun, TheSearchAndRandomPlansAreMeasuredAlikeAndCoaptSpendsLess) {
  const SolvedFront front = solved_front();
  const FrontRun ours = front_run({&front, "coapt", 1, {}}, 500, "");
  const FrontRun random = front_run({&front, "random", 1, {}}, 500, "");
  EXPECT_DOUBLE_EQ(random.rise.back().second, 1.0);
  EXPECT_GT(ours.rise.back().second, 0.97);
  double all_ours = 0.0, all_random = 0.0;
  for (std::uint64_t seed = 1; seed <= 9; ++seed) {
    all_ours += closures_to_share(front_run({&front, "coapt", seed, {}}, 500, ""), 0.97);
    all_random += closures_to_share(front_run({&front, "random", seed, {}}, 500, ""), 0.97);
  }
  EXPECT_LT(all_ours, all_random);
  EXPECT_EQ(closures_to_share(ours, 1.1), std::numeric_limits<double>::infinity());
  EXPECT_LE(closures_to_share(random, 0.5), closures_to_share(random, 0.9));
  EXPECT_EQ(front_methods(""), (std::vector<std::string>{"coapt", "random"}));
  const std::string csv = front_csv({front}, {ours, random});
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 1 + 2 * 3);
  EXPECT_NE(front_rise_csv({ours, random}).find("\n0,coapt,"), std::string::npos);
}

TEST(ObjectiveTables, LeaveNoPlanBetterThanOneThatPracticeAccepts) {
  const SolvedFront front = solved_front();
  const std::vector<rivals::LatticeTable> tables = objective_tables(front);
  ASSERT_EQ(tables.size(), 3u);
  for (std::size_t i = 0; i < front.numbers.size(); ++i) {
    if (front.numbers[i] < 0) {
      for (const rivals::LatticeTable& table : tables) EXPECT_TRUE(std::isinf(table.costs[i]));
      continue;
    }
    const PlanOutcome& outcome = front.outcomes[static_cast<std::size_t>(front.numbers[i])];
    EXPECT_EQ(tables[0].costs[i] < 1.0, outcome.trade_off.has_value());
    if (!outcome.trade_off) {
      EXPECT_GE(tables[0].costs[i], 1.0);
      EXPECT_LT(tables[0].costs[i], 1.5);
      EXPECT_EQ(tables[1].costs[i], 1.0);
      EXPECT_EQ(tables[2].costs[i], 1.0);
    }
  }
  EXPECT_EQ(tables[0].plans, tables[2].plans);
}

TEST(OpeningFile, OutAndInAgainIsTheSame) {
  PlanOpening open, failed;
  open.measure.opening_area_mm2 = 401.25;
  open.measure.projected_area_mm2 = 390.5;
  open.measure.gradient_mmhg = 1.75;
  failed.status = ClosureStatus::StepLimit;
  failed.crossing = true;
  failed.measure.opening_area_mm2 = std::nan("");
  const KnownOpenings read = read_openings("v", write_openings("v", {{"a", open}, {"b", failed}}));
  ASSERT_EQ(read.size(), 2u);
  EXPECT_EQ(read.at("a").measure.opening_area_mm2, 401.25);
  EXPECT_EQ(read.at("a").measure.projected_area_mm2, 390.5);
  EXPECT_EQ(read.at("a").measure.gradient_mmhg, 1.75);
  EXPECT_EQ(read.at("b").status, ClosureStatus::StepLimit);
  EXPECT_TRUE(read.at("b").crossing);
  EXPECT_TRUE(std::isnan(read.at("b").measure.opening_area_mm2));
  EXPECT_TRUE(read_openings("another", write_openings("v", {{"a", open}})).empty());
  for (const char* text :
       {"", "[]", R"({"subject": "v"})", R"({"subject": "v", "openings": {"a": [1]}})",
        R"({"subject": "v", "openings": {"a": ["x", 1, 2, 3, 4]}})"})
    EXPECT_TRUE(read_openings("v", text).empty()) << text;
}

}  // namespace
}  // namespace coapt
