#include "search/strategies.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/repair/apply_plan.h"
#include "search/neochordae.h"
#include "tests/scenes/small_valve.h"

namespace coapt {
namespace {

const std::vector<RingShape> kCatalogue = {{"d", 0.75, 1.0, 0.0, ""}, {"huge", 0.75, 2.0, 0.0, ""}};

// Tips of the small valve are 28.6 mm from their trigones: displaced (normal up to 27.3).
Valve near_tips() {
  Valve valve = small_valve();
  for (PapillaryHead& head : valve.heads) head.tip_mm.z() += 4.0;
  return valve;
}

Valve with_rupture() {
  Valve valve = near_tips();
  valve.chordae[0].ruptured = true;
  return valve;
}

TEST(Choices, SuturesAreOfferedToDisplacedMusclesOnly) {
  // Rings: none, own, d (no size of "huge" is sensible on 36 mm); three options a side; not
  // nothing.
  EXPECT_EQ(sensible_choices(small_valve(), kCatalogue).size(), 3u * 3u * 3u - 1u);
  EXPECT_EQ(sensible_choices(near_tips(), kCatalogue).size(), 2u);
  Valve one_side = near_tips();
  one_side.heads[0].tip_mm.z() -= 4.0;
  EXPECT_EQ(sensible_choices(one_side, kCatalogue).size(), 3u * 3u - 1u);
}

TEST(Choices, FewestStepsComeFirst) {
  const std::vector<Choice> choices = sensible_choices(small_valve(), kCatalogue);
  for (std::size_t i = 0; i < 6; ++i) {
    const Choice& c = choices[i];
    EXPECT_EQ((c.ring ? 1 : 0) + (c.anterolateral ? 1 : 0) + (c.posteromedial ? 1 : 0), 1);
  }
}

TEST(Choices, AFunctionalValveStartsTwoSizesBelow) {
  for (const Choice& choice : sensible_choices(near_tips(), kCatalogue)) {
    EXPECT_EQ(choice.ring->sizes_below, choice.ring->shape == "own" ? 2 : 0);
    EXPECT_EQ(choice.ring->size_mm, choice.ring->shape == "d" ? 32.0 : 0.0);  // of 36
  }
}

TEST(Choices, RupturedChordaeBringNeochordaeAndATrueSizedRing) {
  const std::vector<Choice> choices = sensible_choices(with_rupture(), kCatalogue);
  EXPECT_EQ(choices.size(), 3u * 3u - 1u);  // rings x {0, 2, 4}
  for (const Choice& choice : choices) {
    if (!choice.ring || choice.ring->shape == "own") continue;
    EXPECT_EQ(choice.ring->size_mm, 36.0);
  }
}

TEST(RingNeighbours, AreOneSizeUpAndDownWithinReason) {
  const auto sizes = [](const Annuloplasty& ring) {
    std::vector<double> found;
    for (const Choice& choice : ring_neighbours(small_valve(), kCatalogue, Choice{ring, {}, {}, 0}))
      found.push_back(ring.shape == "own" ? choice.ring->sizes_below : choice.ring->size_mm);
    return found;
  };
  EXPECT_EQ(sizes({.shape = "d", .size_mm = 32.0}), (std::vector<double>{30.0, 34.0}));
  EXPECT_EQ(sizes({.shape = "d", .size_mm = 36.0}), (std::vector<double>{34.0}));
  EXPECT_EQ(sizes({.shape = "d", .size_mm = 28.0}), (std::vector<double>{30.0}));
  EXPECT_EQ(sizes({.shape = "own", .sizes_below = 2}), (std::vector<double>{3, 1}));
  EXPECT_EQ(sizes({.shape = "own", .sizes_below = 4}), (std::vector<double>{3}));
  EXPECT_TRUE(ring_neighbours(small_valve(), kCatalogue, {}).empty());
}

TEST(Strategy, EveryCornerOfItsLatticeIsPossible) {
  for (const Valve& valve : {small_valve(), with_rupture()}) {
    for (const Choice& choice : sensible_choices(valve, kCatalogue)) {
      const std::optional<Strategy> strategy = make_strategy(valve, kCatalogue, choice);
      ASSERT_TRUE(strategy);
      EXPECT_TRUE(apply_plan(valve, strategy->plan, kCatalogue));
      std::vector<int> lowest, highest;
      for (const Parameter& parameter : strategy->parameters) {
        lowest.push_back(0);
        highest.push_back(lattice_size(parameter) - 1);
      }
      EXPECT_TRUE(apply_plan(valve, plan_at(*strategy, lowest), kCatalogue));
      EXPECT_TRUE(apply_plan(valve, plan_at(*strategy, highest), kCatalogue));
    }
  }
}

TEST(Strategy, SuturesMoveTheMuscleByTwoToTenMillimetresInHalves) {
  const Choice choice{{}, Anchor::IpsilateralTrigone, {}, 0};
  const Strategy strategy = *make_strategy(small_valve(), {}, choice);
  ASSERT_EQ(strategy.parameters.size(), 1u);
  const Parameter& parameter = strategy.parameters[0];
  // The tip is 28.6 mm from the trigone.
  EXPECT_EQ(parameter.lower_mm, 19.0);
  EXPECT_EQ(parameter.upper_mm, 26.5);
  EXPECT_EQ(parameter.start_mm, 23.5);
  EXPECT_EQ(lattice_size(parameter), 16);
  EXPECT_EQ(lattice_index(parameter, 19.6), 1);
  EXPECT_EQ(lattice_index(parameter, 99.0), 15);
  EXPECT_EQ(std::get<PapillaryApproximation>(plan_at(strategy, {3}).steps[0]).suture_length_mm,
            20.5);
}

TEST(Strategy, SuturesKeepEveryHeadBelowTheAnnulus) {
  // With a second head 3 mm below the annulus a muscle is lifted by less than that.
  Valve valve = small_valve();
  PapillaryHead high = valve.heads[1];
  high.id = "PM2";
  high.tip_mm.z() = -3.0;
  valve.heads.push_back(high);
  Choice choice;
  choice.posteromedial = Anchor::SaddlePeak;
  const Strategy strategy = *make_strategy(valve, {}, choice);
  const Parameter& suture = strategy.parameters.at(0);
  for (int at = 0; at < lattice_size(suture); ++at)
    EXPECT_TRUE(apply_plan(valve, plan_at(strategy, {at}), {}));
  RepairPlan shorter = plan_at(strategy, {0});
  std::get<PapillaryApproximation>(shorter.steps[0]).suture_length_mm -= 0.5;
  EXPECT_FALSE(apply_plan(valve, shorter, {}));
}

TEST(Strategy, IsNoneWhereTheValveTakesNoMoreChordae) {
  Valve valve = with_rupture();
  Choice choice;
  choice.neochordae = 2;
  EXPECT_TRUE(make_strategy(valve, {}, choice));
  for (int i = 3; i <= 1999; ++i) {
    valve.chordae.push_back(valve.chordae[1]);
    valve.chordae.back().id = std::to_string(i);
  }
  EXPECT_FALSE(make_strategy(valve, {}, choice));
}

TEST(Neochordae, GoToTheLesionFromTheirOwnHalf) {
  // Chorda 0 inserts at vertices 20 and 21 of the free edge: in P1, near the anterolateral
  // commissure.
  const std::vector<NeochordaGroup> groups = neochordae_for_ruptures(with_rupture(), 2);
  ASSERT_EQ(groups.size(), 1u);
  ASSERT_EQ(groups[0].steps.size(), 2u);
  for (const Neochorda& step : groups[0].steps) {
    EXPECT_EQ(step.head, "AL1");
    EXPECT_EQ(step.insertion.leaflet, Leaflet::Posterior);
    EXPECT_EQ(step.insertion.height, 1.0);
    EXPECT_LT(step.insertion.along, 0.5);
  }
  EXPECT_TRUE(neochordae_for_ruptures(small_valve(), 2).empty());
}

TEST(Neochordae, AreAsLongAsTheIntactChordae) {
  Valve valve = with_rupture();
  valve.chordae[1].kind = ChordaKind::Marginal;
  EXPECT_DOUBLE_EQ(neochordae_for_ruptures(valve, 2)[0].length_mm,
                   valve.chordae[1].segments[0].rest_length_mm);
}

TEST(Neochordae, InTheMiddleComeFromBothMuscles) {
  Valve valve = with_rupture();
  for (ChordaSegment& segment : valve.chordae[0].segments)
    if (segment.inserts)
      segment.insertion = locate(valve, leaflet_coordinates(valve), {Leaflet::Posterior, 0.5, 1.0});
  const std::vector<NeochordaGroup> groups = neochordae_for_ruptures(valve, 4);
  ASSERT_EQ(groups.size(), 2u);
  EXPECT_EQ(groups[0].steps.size(), 2u);
  EXPECT_EQ(groups[0].steps[0].head, "AL1");
  EXPECT_EQ(groups[1].steps.size(), 2u);
  EXPECT_EQ(groups[1].steps[0].head, "PM1");
}

}  // namespace
}  // namespace coapt
