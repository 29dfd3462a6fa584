#include "core/repair/chordal.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/repair/apply_plan.h"
#include "tests/scenes/small_valve.h"

namespace coapt {
namespace {

const LeafletPoint kP2Edge{Leaflet::Posterior, 0.5, 1.0};

std::string refusal(const RepairStep& step, const Valve& valve = small_valve()) {
  const Expected<Valve> refused = apply_plan(valve, {{step}});
  return refused ? "accepted" : refused.errors()[0].path;
}

TEST(Chordal, NeochordaIsOneSegmentToTheLocatedPoint) {
  const Valve before = small_valve();
  const Valve valve =
      *apply_plan(before, {{Neochorda{.head = "PM1", .insertion = kP2Edge, .length_mm = 21.0}}});
  ASSERT_EQ(valve.chordae.size(), before.chordae.size() + 1);
  const Chorda& chorda = valve.chordae.back();
  EXPECT_EQ(chorda.id, "neochorda-1");
  EXPECT_EQ(chorda.kind, ChordaKind::Neochorda);
  EXPECT_EQ(chorda.head, 1);
  ASSERT_EQ(chorda.segments.size(), 1u);
  EXPECT_EQ(chorda.segments[0].rest_length_mm, 21.0);
  EXPECT_TRUE(chorda.segments[0].inserts);
  // The free edge near the column at mid-posterior, whose lowest vertex is (0, -7, -16).
  const Vec3 end = position(chorda.segments[0].insertion, valve.faces, valve.rest_mm);
  EXPECT_NEAR(end.z(), -16.0, 1e-9);
  EXPECT_NEAR(end.x(), 0.0, 1.5);
  EXPECT_LT(end.y(), -6.0);
}

TEST(Chordal, NeochordaeOfALaterRepairGetTheNextNumber) {
  const RepairPlan plan{{Neochorda{.head = "PM1", .insertion = kP2Edge, .length_mm = 21.0}}};
  const Valve once = *apply_plan(small_valve(), plan);
  EXPECT_EQ(apply_plan(once, plan)->chordae.back().id, "neochorda-2");
}

TEST(Chordal, LengthChangeIsOfTheTrunk) {
  const Valve before = small_valve();
  const Valve valve = *apply_plan(before, {{ChordalLengthChange{"AL1-P1-marginal-1", -1.5}}});
  const auto& old_segments = before.chordae[0].segments;
  const auto& segments = valve.chordae[0].segments;
  EXPECT_EQ(segments[0].rest_length_mm, old_segments[0].rest_length_mm - 1.5);
  EXPECT_EQ(segments[1].rest_length_mm, old_segments[1].rest_length_mm);
  EXPECT_EQ(segments[2].rest_length_mm, old_segments[2].rest_length_mm);
}

TEST(Chordal, MoreThanAMillimetreOfTrunkIsLeft) {
  const double trunk = small_valve().chordae[0].segments[0].rest_length_mm;
  const auto shortened = [](double by) {
    return RepairStep(ChordalLengthChange{"AL1-P1-marginal-1", -by});
  };
  EXPECT_EQ(refusal(shortened(trunk - 1.01)), "accepted");
  EXPECT_EQ(refusal(shortened(trunk - 1.0)), "/steps/0/change_mm");
  EXPECT_EQ(refusal(ChordalLengthChange{"AL1-P1-marginal-1", 20.5}), "/steps/0/change_mm");
  EXPECT_EQ(refusal(ChordalLengthChange{"AL1-P1-marginal-1", std::nan("")}), "/steps/0/change_mm");
}

TEST(Chordal, ExcisedChordaCarriesNothing) {
  const Valve valve = *apply_plan(small_valve(), {{ChordalExcision{"PM1-A2-strut-1"}}});
  EXPECT_TRUE(valve.chordae[1].ruptured);
  EXPECT_FALSE(valve.chordae[0].ruptured);
}

TEST(Chordal, TransferMovesAllInsertionsAndKeepsLengths) {
  Valve before = small_valve();
  auto& old_segments = before.chordae[0].segments;
  const Vec3 old_end = 0.5 * (before.rest_mm.row(20) + before.rest_mm.row(21));
  old_segments[0].branch_point_mm = 0.5 * (before.heads[0].rest_mm + old_end);
  const Valve valve = *apply_plan(before, {{ChordalTransfer{"AL1-P1-marginal-1", kP2Edge}}});
  const auto& segments = valve.chordae[0].segments;
  const Insertion place = locate(before, leaflet_coordinates(before), kP2Edge);
  for (std::size_t s = 0; s < 3; ++s) {
    EXPECT_EQ(segments[s].rest_length_mm, old_segments[s].rest_length_mm);
    if (s == 0) continue;
    EXPECT_EQ(segments[s].insertion.face, place.face);
    EXPECT_EQ(segments[s].insertion.weights, place.weights);
  }
  // The branch point was half-way to the middle of both insertions and is half-way again.
  const Vec3 end = position(place, before.faces, before.rest_mm);
  const Vec3 half_way = 0.5 * (before.heads[0].rest_mm + end);
  EXPECT_NEAR((segments[0].branch_point_mm - half_way).norm(), 0.0, 1e-9);
}

TEST(Chordal, RefusesWhatIsNotThere) {
  EXPECT_EQ(refusal(ChordalExcision{"X"}), "/steps/0/chorda");
  EXPECT_EQ(refusal(ChordalLengthChange{"X", 1.0}), "/steps/0/chorda");
  EXPECT_EQ(refusal(ChordalTransfer{"X", kP2Edge}), "/steps/0/chorda");
  EXPECT_EQ(refusal(Neochorda{"X", kP2Edge, 20.0}), "/steps/0/head");
}

TEST(Chordal, RefusesRupturedChordae) {
  Valve valve = small_valve();
  valve.chordae[1].ruptured = true;
  EXPECT_EQ(refusal(ChordalExcision{"PM1-A2-strut-1"}, valve), "/steps/0/chorda");
  EXPECT_EQ(refusal(ChordalLengthChange{"PM1-A2-strut-1", 1.0}, valve), "/steps/0/chorda");
  EXPECT_EQ(refusal(ChordalTransfer{"PM1-A2-strut-1", kP2Edge}, valve), "/steps/0/chorda");
}

TEST(Chordal, RefusesValuesOutsideTheirRange) {
  EXPECT_EQ(refusal(Neochorda{"AL1", kP2Edge, 4.9}), "/steps/0/length_mm");
  EXPECT_EQ(refusal(Neochorda{"AL1", kP2Edge, 40.1}), "/steps/0/length_mm");
  EXPECT_EQ(refusal(Neochorda{"AL1", {Leaflet::Anterior, -0.1, 1.0}, 20.0}),
            "/steps/0/insertion/along");
  EXPECT_EQ(refusal(ChordalTransfer{"PM1-A2-strut-1", {Leaflet::Anterior, 0.5, 1.1}}),
            "/steps/0/insertion/height");
}

}  // namespace
}  // namespace coapt
