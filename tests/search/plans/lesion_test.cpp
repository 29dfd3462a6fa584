#include "search/plans/lesion.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/scenes/small_valve.h"

namespace coapt {
namespace {

Valve with_rupture() {
  Valve valve = small_valve();
  valve.chordae[0].ruptured = true;
  return valve;
}

std::optional<Lesion> lesion_of(const Valve& valve) {
  return find_lesion(valve, leaflet_coordinates(valve));
}

Neochorda neochorda(const Valve& valve, const Lesion& lesion, double along) {
  return neochorda_at(valve, leaflet_coordinates(valve), lesion, along);
}

ChordaSegment inserting(const Valve& valve, const LeafletPoint& point, double length_mm) {
  ChordaSegment segment;
  segment.inserts = true;
  segment.insertion = locate(valve, leaflet_coordinates(valve), point);
  segment.rest_length_mm = length_mm;
  return segment;
}

/// Of one segment, from the anterolateral head to a free edge. Returns its index.
int add_chorda(Valve& valve, ChordaKind kind, Leaflet leaflet, double along,
               double length_mm = 15.0) {
  const std::string id = "added-" + std::to_string(valve.chordae.size());
  valve.chordae.push_back(
      {id, kind, 0, false, {inserting(valve, {leaflet, along, 1.0}, length_mm)}});
  return static_cast<int>(valve.chordae.size()) - 1;
}

TEST(Lesion, IsNoneWithoutARupturedMarginalChorda) {
  Valve valve = small_valve();
  EXPECT_FALSE(lesion_of(valve));
  valve.chordae[1].ruptured = true;  // a strut
  EXPECT_FALSE(lesion_of(valve));
}

TEST(Lesion, LiesWhereTheRupturedChordaeInserted) {
  // Chorda 0 inserts at vertices 20 and 21 of the free edge: in P1, near the anterolateral
  // commissure.
  const Lesion lesion = *lesion_of(with_rupture());
  EXPECT_EQ(lesion.leaflet, Leaflet::Posterior);
  EXPECT_GT(lesion.middle, 0.0);
  EXPECT_LT(lesion.middle, 0.5);
}

TEST(Lesion, OfSeveralChordaeLiesMidwayBetweenTheOutermost) {
  Valve valve = small_valve();
  for (const double along : {0.3, 0.35, 0.7})
    valve
        .chordae[static_cast<std::size_t>(
            add_chorda(valve, ChordaKind::Marginal, Leaflet::Anterior, along))]
        .ruptured = true;
  const Lesion lesion = *lesion_of(valve);
  EXPECT_EQ(lesion.leaflet, Leaflet::Anterior);
  EXPECT_NEAR(lesion.middle, 0.5, 1e-6);
}

TEST(Lesion, LiesOnTheLeafletWithMoreOfThem) {
  Valve valve = with_rupture();
  valve
      .chordae[static_cast<std::size_t>(
          add_chorda(valve, ChordaKind::Marginal, Leaflet::Anterior, 0.5))]
      .ruptured = true;
  EXPECT_EQ(lesion_of(valve)->leaflet, Leaflet::Posterior) << "as many on either";
  valve
      .chordae[static_cast<std::size_t>(
          add_chorda(valve, ChordaKind::Marginal, Leaflet::Anterior, 0.6))]
      .ruptured = true;
  EXPECT_EQ(lesion_of(valve)->leaflet, Leaflet::Anterior);
}

TEST(Lesion, ItsLengthIsThatOfTheLeafletsIntactMarginalChordae) {
  Valve valve = with_rupture();
  EXPECT_EQ(lesion_of(valve)->length_mm, 20.0) << "no intact marginal chorda at all";
  add_chorda(valve, ChordaKind::Marginal, Leaflet::Anterior, 0.5, 12.0);
  add_chorda(valve, ChordaKind::Strut, Leaflet::Posterior, 0.5, 30.0);
  EXPECT_NEAR(lesion_of(valve)->length_mm, 12.0, 1e-12) << "none on the posterior leaflet";
  add_chorda(valve, ChordaKind::Marginal, Leaflet::Posterior, 0.7, 16.0);
  EXPECT_NEAR(lesion_of(valve)->length_mm, 16.0, 1e-12);
  // A trunk of 10 mm with branches of 4 and 8 reaches 16 mm in the mean.
  const int tree = add_chorda(valve, ChordaKind::Marginal, Leaflet::Posterior, 0.6);
  ChordaSegment trunk, branch = inserting(valve, {Leaflet::Posterior, 0.6, 1.0}, 4.0);
  trunk.rest_length_mm = 10.0;
  branch.parent = 0;
  std::vector<ChordaSegment>& segments = valve.chordae[static_cast<std::size_t>(tree)].segments;
  segments = {trunk, branch, branch};
  segments[2].rest_length_mm = 8.0;
  EXPECT_NEAR(lesion_of(valve)->length_mm, 16.0, 1e-12);
  segments[2].rest_length_mm = 16.0;  // 20 mm: with 16 of the other, 18
  EXPECT_NEAR(lesion_of(valve)->length_mm, 18.0, 1e-12);
}

TEST(NeochordaAt, GoesToTheFreeEdgeFromItsOwnHalf) {
  const Valve valve = with_rupture();
  const Lesion lesion = *lesion_of(valve);
  const Neochorda step = neochorda(valve, lesion, lesion.middle);
  EXPECT_EQ(step.head, "AL1");
  EXPECT_EQ(step.insertion.leaflet, Leaflet::Posterior);
  EXPECT_EQ(step.insertion.height, 1.0);
  EXPECT_EQ(step.insertion.along, lesion.middle);
  EXPECT_EQ(step.length_mm, lesion.length_mm);
  EXPECT_EQ(neochorda(valve, lesion, 0.45).head, "AL1");
  EXPECT_EQ(neochorda(valve, lesion, 0.55).head, "PM1");
}

TEST(NeochordaAt, StaysOnTheLeaflet) {
  const Valve valve = with_rupture();
  EXPECT_EQ(neochorda(valve, *lesion_of(valve), -0.2).insertion.along, 0.0);
  EXPECT_EQ(neochorda(valve, *lesion_of(valve), 1.2).insertion.along, 1.0);
}

TEST(NeochordaAt, StartsAtTheNearestHeadIfThereIsOne) {
  Valve valve = with_rupture();
  const Lesion lesion = *lesion_of(valve);
  PapillaryHead nearer = valve.heads[0];
  nearer.id = "AL2";
  nearer.rest_mm.z() += 4.0;
  valve.heads.push_back(nearer);
  EXPECT_EQ(neochorda(valve, lesion, 0.3).head, "AL2");
  valve.heads = {valve.heads[1]};
  EXPECT_EQ(neochorda(valve, lesion, 0.3).head, "");
}

TEST(ChordaeAtALesion, AreThoseBesideItNearestFirstAndTheOneOpposite) {
  Valve valve = small_valve();
  valve.chordae.clear();
  const auto add = [&valve](ChordaKind kind, Leaflet leaflet, double along) {
    return add_chorda(valve, kind, leaflet, along);
  };
  const int ruptured = add(ChordaKind::Marginal, Leaflet::Posterior, 0.4);
  valve.chordae[static_cast<std::size_t>(ruptured)].ruptured = true;
  const int far = add(ChordaKind::Marginal, Leaflet::Posterior, 0.8);
  const int beside = add(ChordaKind::Marginal, Leaflet::Posterior, 0.5);
  const int other_side = add(ChordaKind::Marginal, Leaflet::Posterior, 0.25);
  add(ChordaKind::Strut, Leaflet::Posterior, 0.4);
  add(ChordaKind::Marginal, Leaflet::Anterior, 0.7);
  const int opposite = add(ChordaKind::Marginal, Leaflet::Anterior, 0.45);
  const LeafletCoordinates coordinates = leaflet_coordinates(valve);
  const Lesion lesion = *find_lesion(valve, coordinates);
  EXPECT_NEAR(lesion.middle, 0.4, 1e-6);
  EXPECT_EQ(chordae_beside(valve, coordinates, lesion, 2), (std::vector<int>{beside, other_side}));
  EXPECT_EQ(chordae_beside(valve, coordinates, lesion, 9),
            (std::vector<int>{beside, other_side, far}));
  EXPECT_TRUE(chordae_beside(valve, coordinates, lesion, 0).empty());
  EXPECT_EQ(chorda_opposite(valve, coordinates, lesion), opposite);
}

TEST(ChordaeAtALesion, AreNoneWhereAllAreRuptured) {
  const Valve valve = with_rupture();
  const LeafletCoordinates coordinates = leaflet_coordinates(valve);
  EXPECT_TRUE(chordae_beside(valve, coordinates, *lesion_of(valve), 4).empty());
  EXPECT_EQ(chorda_opposite(valve, coordinates, *lesion_of(valve)), -1);
}

TEST(AnteriorStruts, AreTheIntactOnesOfThatLeaflet) {
  Valve valve = small_valve();
  add_chorda(valve, ChordaKind::Strut, Leaflet::Posterior, 0.5);
  add_chorda(valve, ChordaKind::Basal, Leaflet::Anterior, 0.5);
  const int second = add_chorda(valve, ChordaKind::Strut, Leaflet::Anterior, 0.3);
  const LeafletCoordinates coordinates = leaflet_coordinates(valve);
  EXPECT_EQ(anterior_struts(valve, coordinates), (std::vector<int>{1, second}));
  valve.chordae[1].ruptured = true;
  EXPECT_EQ(anterior_struts(valve, coordinates), (std::vector<int>{second}));
}

}  // namespace
}  // namespace coapt
