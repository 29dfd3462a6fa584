#include "core/valve/remodel.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/valve/annulus_frame.h"
#include "core/valve/ruptures.h"
#include "tests/scenes/small_valve.h"

namespace coapt {
namespace {

// The small valve's annulus, an ellipse of 36 x 28 mm in z = 0 with vertices at 45 degrees:
// trigones at (+-9 sqrt 2, 7 sqrt 2), saddle peak (0, 14), mid-posterior (0, -14).
const double kTrigoneY = 7.0 * std::sqrt(2.0);

TEST(Remodel, DilationMovesPointsBehindTheTrigonesInProportion) {
  const Valve valve = small_valve();
  const Valve dilated = *remodel(valve, {.ap_dilation_percent = 25.0});
  // The anteroposterior diameter grows from 28 to 35: mid-posterior, 14 + 7 sqrt 2 behind the
  // trigones, moves 7 backwards; the commissures, 7 sqrt 2 behind them, in proportion.
  const double share = 7.0 / (14.0 + kTrigoneY);
  EXPECT_NEAR((Vec3(dilated.annulus_mm.row(6)) - Vec3(0, -21, 0)).norm(), 0.0, 1e-12);
  EXPECT_NEAR((Vec3(dilated.annulus_mm.row(0)) - Vec3(18, -share * kTrigoneY, 0)).norm(), 0.0,
              1e-12);
  EXPECT_NEAR((Vec3(dilated.annulus_mm.row(5)) -
               Vec3(-9.0 * std::sqrt(2.0), -kTrigoneY - share * 2.0 * kTrigoneY, 0))
                  .norm(),
              0.0, 1e-12);
}

TEST(Remodel, TrigonesSaddlePeakAndTransverseDimensionStay) {
  const Valve valve = small_valve();
  const Valve dilated = *remodel(valve, {.ap_dilation_percent = 30.0});
  for (const int vertex : {1, 2, 3})
    EXPECT_NEAR((dilated.annulus_mm.row(vertex) - valve.annulus_mm.row(vertex)).norm(), 0.0, 1e-12);
  EXPECT_NEAR(transverse_diameter_mm(dilated), 36.0, 1e-9);
  EXPECT_NEAR(ap_diameter_mm(dilated), 28.0 * 1.3, 1e-9);
  EXPECT_EQ(dilated.rest_mm, valve.rest_mm);
  EXPECT_EQ(dilated.heads[0].tip_mm, valve.heads[0].tip_mm);
}

TEST(Remodel, HeightIsScaledAboutTheAnnulusPlane) {
  Valve valve = small_valve();
  for (int i = 0; i < 8; ++i) valve.annulus_mm(i, 2) = i % 4 == 2 ? 3.0 : i % 4 == 0 ? -3.0 : 0.0;
  const Valve flatter = *remodel(valve, {.annular_height_percent = 50.0});
  for (int i = 0; i < 8; ++i) {
    EXPECT_NEAR(flatter.annulus_mm(i, 2), 0.5 * valve.annulus_mm(i, 2), 1e-12);
    EXPECT_NEAR(flatter.annulus_mm(i, 0), valve.annulus_mm(i, 0), 1e-12);
    EXPECT_NEAR(flatter.annulus_mm(i, 1), valve.annulus_mm(i, 1), 1e-12);
  }
  const Valve flat = *remodel(valve, {.annular_height_percent = 0.0});
  EXPECT_NEAR(flat.annulus_mm.col(2).cwiseAbs().maxCoeff(), 0.0, 1e-12);
}

TEST(Remodel, TipsMoveOutwardsBackwardsAndDown) {
  Remodelling change;
  change.anterolateral_mm = Vec3(1.0, 2.0, 3.0);
  change.posteromedial_mm = Vec3(4.0, 5.0, 6.0);
  const Valve valve = small_valve();
  const Valve changed = *remodel(valve, change);
  EXPECT_EQ(changed.heads[0].tip_mm, Vec3(-13.0, -4.0, -29.0));  // was (-12, -2, -26)
  EXPECT_EQ(changed.heads[1].tip_mm, Vec3(16.0, -7.0, -32.0));   // was (12, -2, -26)
  EXPECT_EQ(changed.heads[0].rest_mm, valve.heads[0].rest_mm);
}

TEST(Remodel, LeafletsGrowAwayFromTheAnnulus) {
  const Valve valve = small_valve();
  const Valve grown = *remodel(valve, {.leaflet_growth_percent = 20.0});
  // The small valve's columns hang from the annulus vertex of their own angle, which the leaflets' coordinates find to within
  // their own curvature.
  for (int vertex = 0; vertex < 8; ++vertex) {
    EXPECT_EQ(grown.rest_mm.row(vertex), valve.rest_mm.row(vertex));
    const auto height = [&](const Valve& of) {
      return (of.rest_mm.row(16 + vertex) - of.rest_mm.row(vertex)).norm();
    };
    EXPECT_NEAR(height(grown), 1.2 * height(valve), 0.02 * height(valve)) << vertex;
  }
  EXPECT_EQ(grown.annulus_mm, valve.annulus_mm);
  EXPECT_EQ(grown.chordae[1].segments[0].rest_length_mm,
            valve.chordae[1].segments[0].rest_length_mm);
  for (Index f = 0; f < grown.faces.rows(); ++f)
    EXPECT_NEAR(Vec3(grown.fibre.row(f)).norm(), 1.0, 1e-12);
}

TEST(Remodel, TheWholeValveGrowsAboutItsAnnulus) {
  const Valve valve = small_valve();
  const Valve grown = *remodel(valve, {.growth_percent = 10.0});
  EXPECT_NEAR(transverse_diameter_mm(grown), 1.1 * transverse_diameter_mm(valve), 1e-9);
  EXPECT_NEAR(ap_diameter_mm(grown), 1.1 * ap_diameter_mm(valve), 1e-9);
  const auto length_of = [](const Valve& of, const Vec3& point) {
    return (point - annulus_frame(of, AnnulusAxis::SaddlePeak).origin_mm).norm();
  };
  EXPECT_NEAR(length_of(grown, grown.heads[0].tip_mm),
              1.1 * length_of(valve, valve.heads[0].tip_mm), 1e-9);
  for (std::size_t c = 0; c < valve.chordae.size(); ++c)
    EXPECT_NEAR(grown.chordae[c].segments[0].rest_length_mm,
                1.1 * valve.chordae[c].segments[0].rest_length_mm, 1e-12);
  EXPECT_EQ(grown.tissue, valve.tissue);
}

TEST(Remodel, ElongatesAllChordaeAndThoseOfAScallopFurther) {
  const Valve valve = small_valve();
  Remodelling change;
  change.chordal_elongation_percent = 10.0;
  const Segment scallop = held_segments(valve).front();
  change.elongated = {{scallop, 30.0}};
  const Valve longer = *remodel(valve, change);
  for (std::size_t c = 0; c < valve.chordae.size(); ++c) {
    const Chorda& chorda = valve.chordae[c];
    const bool further = chorda.kind == ChordaKind::Marginal && held_by(valve, chorda) == scallop;
    EXPECT_NEAR(longer.chordae[c].segments[0].rest_length_mm,
                (further ? 1.1 * 1.3 : 1.1) * chorda.segments[0].rest_length_mm, 1e-12);
  }
}

TEST(Remodel, ChangesTheTissueByShares) {
  for (const TissueReference reference : {TissueReference::Excised, TissueReference::InVivo}) {
    Valve valve = small_valve();
    valve.tissue.reference = reference;
    const Valve changed = *remodel(valve, {.tissue = {.thickness_percent = 200.0,
                                                      .extension_percent = 150.0,
                                                      .circumferential_stiffness_percent = 60.0,
                                                      .radial_stiffness_percent = 50.0}});
    const auto left = [](const Tissue& tissue) {
      return (1.0 + tissue.radial_transition) / prestretch(tissue)[1] - 1.0;
    };
    EXPECT_NEAR(left(changed.tissue), 1.5 * left(valve.tissue), 1e-12);
    EXPECT_EQ(changed.tissue.thickness_mm, 2.0 * valve.tissue.thickness_mm);
    EXPECT_EQ(changed.tissue.circumferential_post_kpa, 0.6 * valve.tissue.circumferential_post_kpa);
    EXPECT_EQ(changed.tissue.radial_pre_kpa, 0.5 * valve.tissue.radial_pre_kpa);
  }
}

TEST(Remodel, NamesFieldsOfChordaeAndTissue) {
  Remodelling change;
  change.growth_percent = 101.0;
  change.chordal_elongation_percent = -51.0;
  change.elongated = {{Segment::P2, 201.0}};
  change.tissue.extension_percent = 0.0;
  const Expected<Valve> refused = remodel(small_valve(), change);
  ASSERT_FALSE(refused);
  std::vector<std::string> paths;
  for (const Error& error : refused.errors()) paths.push_back(error.path);
  EXPECT_EQ(paths, (std::vector<std::string>{"/growth_percent", "/chordal_elongation_percent",
                                             "/elongated/0/percent", "/tissue/extension_percent"}));
  change = {};
  change.elongated = {{Segment::AC, 10.0}};
  const Expected<Valve> unknown = remodel(small_valve(), change);
  ASSERT_FALSE(unknown);
  EXPECT_EQ(unknown.errors()[0].path, "/elongated/0/segment");
}

TEST(Remodel, RupturesTheMarginalChordaeOfASegmentThatAnyHolds) {
  const Valve valve = small_valve();
  const std::vector<Segment> held = held_segments(valve);
  ASSERT_FALSE(held.empty());
  Remodelling change;
  change.ruptured = {held.front()};
  const Valve without = *remodel(valve, change);
  EXPECT_EQ(held_segments(without).size() + 1, held.size());
  const Expected<Valve> twice = remodel(without, change);
  ASSERT_FALSE(twice);
  EXPECT_EQ(twice.errors()[0].path, "/ruptured/0");
  EXPECT_EQ(twice.errors()[0].code, ErrorCode::BadReference);
}

TEST(Remodel, NothingChangesWithoutARemodelling) {
  const Valve valve = small_valve();
  const Valve same = *remodel(valve, {});
  EXPECT_EQ(same.annulus_mm, valve.annulus_mm);
  EXPECT_EQ(same.heads[1].tip_mm, valve.heads[1].tip_mm);
  EXPECT_EQ(same.provenance.size(), valve.provenance.size() + 1);
  for (int digits = 0; digits < 100; ++digits) {
    Valve other = valve;
    other.tissue.reference = TissueReference::InVivo;
    other.tissue.radial_prestretch = 1.33 / (1.05 + 0.001 * digits);
    EXPECT_EQ(remodel(other, {})->tissue, other.tissue);
  }
}

TEST(Remodel, ListsEveryValueOutsideItsRange) {
  Remodelling change;
  change.ap_dilation_percent = 101.0;
  change.annular_height_percent = -1.0;
  change.anterolateral_mm.z() = std::numeric_limits<double>::quiet_NaN();
  change.posteromedial_mm.x() = 31.0;
  const Expected<Valve> refused = remodel(small_valve(), change);
  ASSERT_FALSE(refused);
  ASSERT_EQ(refused.errors().size(), 4u);
  EXPECT_EQ(refused.errors()[0].path, "/ap_dilation_percent");
  EXPECT_EQ(refused.errors()[1].path, "/annular_height_percent");
  EXPECT_EQ(refused.errors()[2].path, "/anterolateral_mm/2");
  EXPECT_EQ(refused.errors()[3].path, "/posteromedial_mm/0");
  for (const Error& error : refused.errors()) EXPECT_EQ(error.code, ErrorCode::OutOfRange);
}

TEST(Remodel, RefusesWhatLeavesNoValve) {
  // Tips 26 mm below the annulus, lifted by 30; a circumference of nearly 400 mm, which is the
  // most.
  const Expected<Valve> lifted =
      remodel(small_valve(), {.anterolateral_mm = Vec3(0.0, 0.0, -30.0)});
  ASSERT_FALSE(lifted);
  ASSERT_EQ(lifted.errors().size(), 1u);
  EXPECT_EQ(lifted.errors()[0].path, "/anterolateral_mm/2");
  EXPECT_EQ(lifted.errors()[0].code, ErrorCode::BadGeometry);
  Valve large = small_valve();
  large.annulus_mm *= 3.95;
  const Expected<Valve> dilated = remodel(large, {.ap_dilation_percent = 50.0});
  ASSERT_FALSE(dilated);
  for (const Error& error : dilated.errors()) EXPECT_EQ(error.path, "/ap_dilation_percent");
}

TEST(Remodel, RefusesAShrinkageThatPassesTheTrigones) {
  // Trigones moved to the middle: 40 % of 28 mm is more than the 10 mm between them and
  // mid-posterior.
  Valve valve = small_valve();
  valve.annulus_mm(1, 1) = valve.annulus_mm(3, 1) = -4.0;
  const Expected<Valve> refused = remodel(valve, {.ap_dilation_percent = -40.0});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.errors()[0].path, "/ap_dilation_percent");
}

}  // namespace
}  // namespace coapt
