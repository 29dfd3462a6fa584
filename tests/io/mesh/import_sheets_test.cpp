// Imports of what segmentation gives: thick, without annulus, open or closed.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>

#include "core/closure/closure.h"
#include "core/metrics/measure.h"
#include "io/mesh/find_annulus.h"
#include "io/mesh/imaged_state.h"
#include "io/mesh/judged_state.h"
#include "shell_scene.h"

namespace coapt {
namespace {

// Thresholds were looked at on the first half, the other half was not.
constexpr const char* kSeen[] = {"human-normal", "human-functional-mr", "human-p2-prolapse",
                                 "secondary-mr"};
constexpr const char* kHeldOut[] = {"barlow", "fibroelastic-flail", "marfan", "hypertrophic",
                                    "porcine-1"};

std::vector<const char*> presets() {
  std::vector<const char*> all(std::begin(kSeen), std::end(kSeen));
  all.insert(all.end(), std::begin(kHeldOut), std::end(kHeldOut));
  return all;
}

double leak_mm2(const Valve& valve) { return measure(valve, close_valve(valve)).leak.area_mm2; }

double loop_rms_mm(const Points& found, const Points& given) {
  double sum = 0.0;
  for (const auto& p : found.rowwise()) {
    double best = 1e300;
    for (Eigen::Index i = 0; i < given.rows(); ++i) {
      const Vec3 a = given.row(i), along = Vec3(given.row((i + 1) % given.rows())) - a;
      const double share = std::clamp(along.dot(Vec3(p) - a) / along.squaredNorm(), 0.0, 1.0);
      best = std::min(best, (a + share * along - Vec3(p)).norm());
    }
    sum += best * best;
  }
  return std::sqrt(sum / static_cast<double>(found.rows()));
}

TEST(ImportSheets, OpenAndClosedPresetsAreToldApart) {
  for (const char* preset : presets())
    for (const bool closed : {false, true}) {
      const ImportSource source = preset_leaflets(preset, closed);
      const StateSigns signs = imaged_state(source.leaflets, source.annulus_mm, 1.0);
      EXPECT_EQ(signs.state, closed ? ImagedState::Closed : ImagedState::Open) << preset;
    }
}

TEST(ImportSheets, TheAnnulusIsFoundAlongTheOutlines) {
  for (const char* preset : presets())
    for (const bool closed : {false, true}) {
      ImportSource source = preset_leaflets(preset, closed);
      const Points given = source.annulus_mm;
      source.annulus_mm.resize(0, 3);
      const Expected<FoundAnnulus> found = find_annulus(source);
      EXPECT_TRUE(found) << preset << closed << found.errors()[0].message;
      if (!found) continue;
      const double rms = loop_rms_mm(found->annulus_mm, given);
      EXPECT_LT(rms, 1.0) << preset << closed;
    }
}

/// A half of a tube of radius 15 and height 20 mm.
TriangleMesh half_tube(double from_turn) {
  constexpr int kColumns = 24, kRows = 10;
  TriangleMesh sheet{Points((kColumns + 1) * (kRows + 1), 3), Faces(2 * kColumns * kRows, 3)};
  for (int c = 0; c <= kColumns; ++c)
    for (int r = 0; r <= kRows; ++r) {
      const double angle = std::numbers::pi * (2.0 * from_turn + static_cast<double>(c) / kColumns);
      sheet.vertices_mm.row(c * (kRows + 1) + r) << 15.0 * std::cos(angle), 15.0 * std::sin(angle),
          -2.0 * r;
    }
  for (int c = 0, f = 0; c < kColumns; ++c)
    for (int r = 0; r < kRows; ++r) {
      const int at = c * (kRows + 1) + r, next = at + kRows + 1;
      sheet.faces.row(f++) << at, at + 1, next;
      sheet.faces.row(f++) << next, at + 1, next + 1;
    }
  return sheet;
}

TEST(ImportSheets, TheAnnulusOfATubeIsAskedFor) {
  ImportSource source;
  source.leaflets = {half_tube(0.0), half_tube(0.5)};
  const Expected<FoundAnnulus> found = find_annulus(source);
  ASSERT_FALSE(found);
  EXPECT_NE(found.errors()[0].message.find("two loops are equally likely"), std::string::npos);
}

/// One row of the table: thick leaflets, drawn chordae.
void thick_row(const char* preset, bool closed, bool ring) {
  ImportSource sheets = preset_leaflets(preset, closed);
  ImportOptions options;
  options.chordae_seed = 0;
  ImportSource shells = sheets;
  for (TriangleMesh& mesh : shells.leaflets) mesh = thickened(mesh, 2.0, 0.1);
  if (!ring) shells.annulus_mm.resize(0, 3);
  const Expected<ImportedValve> thin = import_with_decisions(sheets, options);
  const Expected<ImportedValve> thick = import_with_decisions(shells, options);
  ASSERT_TRUE(thin) << preset << closed << thin.errors()[0].message;
  ASSERT_TRUE(thick) << preset << closed << ring << thick.errors()[0].path
                     << thick.errors()[0].message;
  ASSERT_EQ(thick->thickness.size(), 2u);
  EXPECT_NEAR(leak_mm2(thick->valve), leak_mm2(thin->valve), 5.0) << preset << closed;
  EXPECT_NEAR(thick->thickness[0].mean_mm, 2.0, 0.2);
  EXPECT_NEAR(thick->thickness[1].mean_mm, 2.0, 0.2);
  EXPECT_EQ(thick->valve.tissue.reference,
            closed ? TissueReference::InVivo : TissueReference::Excised);
}

TEST(ImportSheets, ThickLeafletsOfPresetsAreImported) {
  for (const char* preset : {"human-normal", "secondary-mr", "hypertrophic", "marfan"})
    for (const bool closed : {false, true}) thick_row(preset, closed, true);
}

TEST(ImportSheets, ThickLeafletsWithoutAnAnnulusAreImported) {
  for (const bool closed : {false, true}) thick_row("human-normal", closed, false);
}

const ImportDecision* told(const ImportedValve& valve, const std::string& about) {
  for (const ImportDecision& decision : valve.decisions)
    if (decision.subject == about) return &decision;
  return nullptr;
}

TEST(ImportSheets, WhatWasGuessedIsSaidAndMarked) {
  ImportSource source = preset_leaflets("human-normal", true);
  source.annulus_mm.resize(0, 3);
  ImportOptions options;
  options.chordae_seed = 0;
  const Expected<ImportedValve> judged = import_with_decisions(source, options);
  ASSERT_TRUE(judged);
  for (const char* about : {"annulus", "state"}) {
    ASSERT_NE(told(*judged, about), nullptr) << about;
    EXPECT_TRUE(told(*judged, about)->look) << about;
  }
  EXPECT_EQ(told(*judged, "state")->value, "imaged closed");
  options.closed = false;
  const Expected<ImportedValve> given =
      import_with_decisions(preset_leaflets("human-normal", false), options);
  ASSERT_TRUE(given);
  EXPECT_EQ(told(*given, "state")->value, "open, as given");
  EXPECT_FALSE(told(*given, "state")->look);
}

TEST(ImportSheets, OneShellOfBothLeafletsIsRefused) {
  ImportSource source = preset_leaflets("human-normal", true);
  source.leaflets = {thickened(source.leaflets[0], 2.0)};
  source.tips = {{Side::Anterolateral, {-15.0, -2.0, -25.0}},
                 {Side::Posteromedial, {15.0, -2.0, -25.0}}};
  ImportOptions options;
  options.chordae_seed = 0;
  const Expected<Valve> valve = import_valve(source, options);
  ASSERT_FALSE(valve);
  EXPECT_NE(valve.errors()[0].message.find("both leaflets are fused"), std::string::npos)
      << valve.errors()[0].message;
}

TEST(ImportSheets, AMeasuredThicknessIsTakenIfAskedFor) {
  ImportSource source = preset_leaflets("human-normal", false);
  for (TriangleMesh& mesh : source.leaflets) mesh = thickened(mesh, 1.5);
  ImportOptions options;
  options.chordae_seed = 0;
  EXPECT_DOUBLE_EQ(import_valve(source, options)->tissue.thickness_mm, 1.0);
  options.thickness_measured = true;
  EXPECT_NEAR(import_valve(source, options)->tissue.thickness_mm, 1.5, 0.1);
  EXPECT_EQ(import_valve(preset_leaflets("human-normal", false), options).errors()[0].path,
            "/thickness_measured");
}

TEST(ImportSheets, AnUnusualThicknessIsLookedAt) {
  ImportOptions options;
  options.chordae_seed = 0;
  for (const auto& [given_mm, look] :
       {std::pair(0.3, true), {0.8, false}, {2.0, false}, {5.0, true}}) {
    options.thickness_mm = given_mm;
    std::vector<ImportDecision> decisions;
    ASSERT_TRUE(tissue_thickness(options, {}, 1.0, decisions));
    EXPECT_EQ(decisions.at(0).look, look) << given_mm;
  }
  options.thickness_mm = {};
  for (const auto& [posterior_mm, look] : {std::pair(1.7, false), {4.6, true}}) {
    std::vector<MeasuredThickness> measured(2);
    measured[0].mean_mm = 1.6;
    measured[1].mean_mm = posterior_mm;
    std::vector<ImportDecision> decisions;
    ASSERT_TRUE(tissue_thickness(options, measured, 1.0, decisions));
    EXPECT_EQ(decisions.at(0).look, look) << sentence(decisions[0]);
  }
}

TEST(ImportSheets, TallLeafletsOfSickValvesHaveUsualSizes) {
  for (const char* preset : {"barlow", "hypertrophic", "marfan", "secondary-mr"}) {
    ImportOptions options;
    options.chordae_seed = 0;
    const Expected<ImportedValve> made =
        import_with_decisions(preset_leaflets(preset, false), options);
    ASSERT_TRUE(made) << preset << made.errors()[0].message;
    EXPECT_EQ(told(*made, "size"), nullptr) << preset << sentence(*told(*made, "size"));
  }
}

}  // namespace
}  // namespace coapt
