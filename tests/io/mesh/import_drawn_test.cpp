// Imports whose chordae nobody has seen.
#include <gtest/gtest.h>

#include "cone_scene.h"
#include "io/mesh/import_readers.h"

namespace coapt {
namespace {

ImportSource unseen() {
  ImportSource source = cone_source_with_gaps();
  source.chordae.clear();
  return source;
}

ImportOptions draws(int seed) {
  ImportOptions options;
  options.triangles = 300;
  options.chordae_seed = seed;
  return options;
}

std::string first_path(const Expected<Valve>& valve) {
  return valve ? "imported" : valve.errors().front().path;
}

TEST(ImportDrawn, TwoSheetsAndAnAnnulusAreEnough) {
  const Expected<Valve> valve = import_valve(unseen(), draws(1));
  ASSERT_TRUE(valve);
  EXPECT_GE(valve->chordae.size(), 12u);
  EXPECT_EQ(valve->drawn_chordae, (DrawnChordae{1, false}));
  EXPECT_NE(
      valve->provenance.back().find("not imaged; synthesised from anatomical data with seed 1"),
      std::string::npos);
}

TEST(ImportDrawn, EveryDecisionIsASentenceOfTheProvenance) {
  const Expected<ImportedValve> imported = import_with_decisions(unseen(), draws(1));
  ASSERT_TRUE(imported);
  const std::vector<std::string>& told = imported->valve.provenance;
  const std::vector<ImportDecision>& decisions = imported->decisions;
  ASSERT_GT(told.size(), decisions.size());
  for (std::size_t i = 0; i < decisions.size(); ++i) {
    const std::string& sentence = told[told.size() - decisions.size() + i];
    EXPECT_TRUE(sentence.starts_with(decisions[i].subject + ": " + decisions[i].value));
    EXPECT_TRUE(sentence.ends_with(decisions[i].reason)) << sentence;
  }
  EXPECT_EQ(decisions.front().subject, "units");
  EXPECT_EQ(decisions.front().value, "mm");
  EXPECT_EQ(decisions.back().subject, "chordae");
}

TEST(ImportDrawn, SheetsOrientTheValveAsTipsDo) {
  ImportSource turned = unseen();
  Eigen::Matrix3d turn;
  turn = Eigen::AngleAxisd(2.1, Vec3(1.0, -2.0, 0.5).normalized());
  const auto moved = [&](const Points& points) {
    return Points((points * turn.transpose()).rowwise() + Eigen::RowVector3d(5.0, -30.0, 12.0));
  };
  for (TriangleMesh& mesh : turned.leaflets) mesh.vertices_mm = moved(mesh.vertices_mm);
  turned.annulus_mm = moved(turned.annulus_mm);
  const Expected<Valve> straight = import_valve(unseen(), draws(0));
  const Expected<Valve> valve = import_valve(turned, draws(0));
  ASSERT_TRUE(straight);
  ASSERT_TRUE(valve);
  ASSERT_EQ(valve->heads.size(), straight->heads.size());
  for (std::size_t i = 0; i < valve->heads.size(); ++i)
    EXPECT_LT((valve->heads[i].tip_mm - straight->heads[i].tip_mm).norm(), 0.05);
}

TEST(ImportDrawn, TipsThatWereSeenAreTaken) {
  ImportSource source = unseen();
  source.tips = {{Side::Anterolateral, {-10.0, 0.0, -25.0}},
                 {Side::Posteromedial, {10.0, 0.0, -25.0}}};
  const Expected<Valve> valve = import_valve(source, draws(2));
  ASSERT_TRUE(valve);
  EXPECT_TRUE(valve->drawn_chordae->tips_given);
  bool found = false;
  for (const PapillaryHead& head : valve->heads)
    found = found || (head.tip_mm - Vec3(-11.0, 0.0, -25.0)).norm() < 0.05;  // the middle head
  EXPECT_TRUE(found);
}

TEST(ImportDrawn, WhatCannotBeDrawnIsRefused) {
  ImportSource one_tip = unseen(), skirt = cone_source(), both = cone_source_with_gaps();
  one_tip.tips = {{Side::Anterolateral, {-10.0, 0.0, -25.0}}};
  skirt.chordae.clear();
  EXPECT_EQ(first_path(import_valve(one_tip, draws(1))), "/tips");
  EXPECT_EQ(first_path(import_valve(skirt, draws(1))), "/tips");
  EXPECT_EQ(first_path(import_valve(both, draws(1))), "/chordae");
  EXPECT_EQ(first_path(import_valve(unseen(), draws(-1))), "/chordae_seed");
  EXPECT_EQ(first_path(import_valve(unseen(), {})), "/chordae");
}

TEST(ImportDrawn, TipsAreReadFromATableThatNamesTheMuscle) {
  const auto tips = read_tips_csv("# papillary,x,y,z\nPM,1,2,3\nAL,-1,2,3\n");
  ASSERT_TRUE(tips);
  ASSERT_EQ(tips->size(), 2u);
  EXPECT_EQ((*tips)[0].side, Side::Posteromedial);
  EXPECT_EQ((*tips)[1].position_mm, Vec3(-1.0, 2.0, 3.0));
  EXPECT_EQ(read_tips_csv("QQ,1,2,3\n").errors().front().path, "/tips/0/papillary");
}

TEST(ImportDrawn, ACancelledImportHasNoValveWhereverItWas) {
  ImportOptions options = draws(1);
  int asked = 0, last = 1 << 30;
  options.budget.cancelled = [&] { return ++asked >= last; };
  ASSERT_TRUE(import_with_decisions(unseen(), options));
  const int asks = asked;
  EXPECT_GT(asks, 1000) << "cuts, rays, steps of the closure";
  for (const int stop : {1, asks / 2, asks - 200, asks - 10, asks}) {
    asked = 0;
    last = stop;
    const Expected<ImportedValve> imported = import_with_decisions(unseen(), options);
    ASSERT_FALSE(imported) << last;
    EXPECT_EQ(imported.errors().front().code, ErrorCode::Busy) << last;
    EXPECT_LT(asked, last + 10) << "goes on after " << last;
  }
}

}  // namespace
}  // namespace coapt
