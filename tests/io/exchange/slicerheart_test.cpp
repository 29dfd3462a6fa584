#include "io/exchange/slicerheart.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/presets/human_presets.h"
#include "core/repair/apply_plan.h"
#include "core/valve/validate.h"
#include "io/exchange/markups.h"
#include "tests/scenes/small_preset.h"

namespace coapt {
namespace {

std::vector<NamedFile> folder_of(const Valve& valve) {
  const Expected<std::vector<NamedFile>> files =
      write_slicerheart(close_and_measure(valve, {.motion = true}), {.open = true});
  EXPECT_TRUE(files);
  return files ? *files : std::vector<NamedFile>{};
}

Expected<Valve> imported(const std::vector<NamedFile>& files, int triangles) {
  const Expected<ImportSource> source = read_slicerheart(files);
  if (!source) return source.errors();
  ImportOptions options;
  options.triangles = triangles;
  return import_valve(*source, options);
}

Errors problems(const std::vector<NamedFile>& files) {
  const Expected<ImportSource> source = read_slicerheart(files);
  EXPECT_FALSE(source) << "was read";
  return source ? Errors{{}} : source.errors();
}

NamedFile& named(std::vector<NamedFile>& files, const std::string& name) {
  return *std::find_if(files.begin(), files.end(),
                       [&](const NamedFile& file) { return file.name == name; });
}

/// What both show of a closed valve, compared as two meshes of one valve may be.
void expect_closes_alike(const std::string& preset, int triangles) {
  const Valve& valve = shared_preset(preset, triangles);
  const Expected<Valve> again = imported(folder_of(valve), static_cast<int>(valve.faces.rows()));
  ASSERT_TRUE(again) << again.errors()[0].path << ": " << again.errors()[0].message;
  EXPECT_TRUE(validate(*again).empty());
  EXPECT_EQ(again->chordae.size(), valve.chordae.size());
  const ValveMeasure before = close_and_measure(valve, {.motion = true}).measure;
  const ClosedValve after = close_and_measure(*again, {.motion = true});
  EXPECT_EQ(after.closure.status, ClosureStatus::Converged);
  EXPECT_FALSE(after.closure.crossing);
  EXPECT_NEAR(after.measure.annulus.area_mm2, before.annulus.area_mm2, 5.0);
  // Meshes of one leaking valve differ by a fifth (docs/researcher/accuracy.md, "The mesh").
  const double leak = before.leak.area_mm2;
  EXPECT_NEAR(after.measure.leak.area_mm2, leak, std::max(3.0, 0.25 * leak)) << preset;
  EXPECT_NEAR(after.measure.coaptation.height_mean_mm, before.coaptation.height_mean_mm, 1.0);
}

TEST(SlicerHeart, ACompetentValveThatGoesOutAndInClosesAlike) {
  expect_closes_alike("human-normal", 650);
}

TEST(SlicerHeart, ALeakingValveThatGoesOutAndInClosesAlike) {
  expect_closes_alike("human-functional-mr", 650);
}

TEST(SlicerHeart, TiesOfAClipComeBackAndHoldAsBefore) {
  const Valve clipped =
      *apply_plan(shared_preset("secondary-mr", 650), {{EdgeToEdge{EdgeDevice::Clip, 0.5, 6.0}}});
  const std::vector<NamedFile> files = folder_of(clipped);
  const Expected<Valve> again = imported(files, static_cast<int>(clipped.faces.rows()));
  ASSERT_TRUE(again) << again.errors()[0].message;
  ASSERT_EQ(again->ties.size(), clipped.ties.size());
  for (std::size_t i = 0; i < clipped.ties.size(); ++i) {
    const Tie &before = clipped.ties[i], &after = again->ties[i];
    EXPECT_EQ(after.id, before.id);
    EXPECT_EQ(after.rest_length_mm, before.rest_length_mm);
    const auto length_mm = [](const Valve& valve, const Tie& tie) {
      return (position(tie.anterior, valve.faces, valve.rest_mm) -
              position(tie.posterior, valve.faces, valve.rest_mm))
          .norm();
    };
    EXPECT_NEAR(length_mm(*again, after), length_mm(clipped, before), 0.5);
  }
  const ValveMeasure before = close_and_measure(clipped).measure,
                     after = close_and_measure(*again).measure;
  EXPECT_NEAR(after.leak.area_mm2, before.leak.area_mm2,
              before.leak_error_mm2 + after.leak_error_mm2);
}

TEST(SlicerHeart, SuturesOfACleftComeBackOnThePosteriorLeaflet) {
  HumanValve human = human_normal();
  human.dimensions.cleft_depth_mm = 8.0;
  const Valve sutured = *apply_plan(*make_human_valve(human),
                                    {{EdgeToEdge{EdgeDevice::CleftSuture, 1.0 / 3.0, 10.0}}});
  const Expected<Valve> again =
      imported(folder_of(sutured), static_cast<int>(sutured.faces.rows()));
  ASSERT_TRUE(again) << again.errors()[0].message;
  ASSERT_EQ(again->ties.size(), sutured.ties.size());
  for (std::size_t i = 0; i < sutured.ties.size(); ++i)
    for (const auto end : {&Tie::anterior, &Tie::posterior}) {
      const auto at_mm = [&](const Valve& valve) {
        return position(valve.ties[i].*end, valve.faces, valve.rest_mm);
      };
      const Insertion& landed = again->ties[i].*end;
      const Segment on = again->segments[static_cast<std::size_t>(landed.face)];
      EXPECT_TRUE(on == Segment::P1 || on == Segment::P2) << to_string(on);
      EXPECT_LT((at_mm(*again) - at_mm(sutured)).norm(), 2.0) << "an edge of the new mesh is 3 mm";
    }
}

TEST(SlicerHeart, ATieThatIsNoneOrFarFromItsLeafletIsRefused) {
  const Valve clipped =
      *apply_plan(small_preset("human-normal"), {{EdgeToEdge{EdgeDevice::Stitch, 0.5, 4.0}}});
  std::vector<NamedFile> files = folder_of(clipped);
  Expected<std::vector<Markup>> repair = read_markups(named(files, "repair.mrk.json").bytes);
  ASSERT_TRUE(repair);
  (*repair)[1].points_mm(0, 2) += 40.0;
  named(files, "repair.mrk.json").bytes = write_markups(*repair);
  const Expected<Valve> far = imported(files, 648);
  ASSERT_FALSE(far);
  EXPECT_EQ(far.errors().front().path, "/ties/1/anterior_mm");
  (*repair)[1].points_mm.conservativeResize(1, 3);
  named(files, "repair.mrk.json").bytes = write_markups(*repair);
  EXPECT_NE(problems(files).front().message.find("must have two"), std::string::npos);
}

TEST(SlicerHeart, TreesRestLengthsAndHeadsComeBack) {
  const Valve& valve = small_preset("human-normal");
  const Expected<Valve> again = imported(folder_of(valve), static_cast<int>(valve.faces.rows()));
  ASSERT_TRUE(again);
  ASSERT_EQ(again->chordae.size(), valve.chordae.size());
  EXPECT_EQ(again->heads.size(), valve.heads.size());
  double before = 0.0, after = 0.0;
  for (std::size_t c = 0; c < valve.chordae.size(); ++c) {
    EXPECT_EQ(again->chordae[c].segments.size(), valve.chordae[c].segments.size());
    for (const ChordaSegment& segment : valve.chordae[c].segments) before += segment.rest_length_mm;
    for (const ChordaSegment& segment : again->chordae[c].segments) after += segment.rest_length_mm;
  }
  EXPECT_NEAR(after, before, 0.03 * before);
}

TEST(SlicerHeart, TissuePressureAndInsertionsComeBack) {
  Valve valve = small_preset("barlow");
  valve.pressure_kpa = 14.0;
  const Expected<ImportSource> source = read_slicerheart(folder_of(valve));
  ASSERT_TRUE(source);
  EXPECT_EQ(source->tissue, valve.tissue);
  EXPECT_EQ(source->pressure_kpa, 14.0);
  const Chorda& own = valve.chordae.front();
  const ImportedSegment& last = source->chordae.front().segments.back();
  ASSERT_TRUE(own.segments.back().inserts);
  EXPECT_LT(
      (last.end_mm - position(own.segments.back().insertion, valve.faces, valve.rest_mm)).norm(),
      1e-6);
}

TEST(SlicerHeart, ATissueThatIsNoneNamesItsFile) {
  std::vector<NamedFile> files = folder_of(small_preset("human-normal"));
  named(files, "tissue.json").bytes = R"({"schema": "coapt.tissue/1", "pressure_kpa": "16"})";
  std::vector<std::string> paths;
  for (const Error& error : problems(files)) paths.push_back(error.path);
  EXPECT_EQ(paths, (std::vector<std::string>{"tissue.json/pressure_kpa", "tissue.json/tissue"}));
}

TEST(SlicerHeart, SidesAreToldByTheLeafletsWhereTipsHaveNoLabels) {
  std::vector<NamedFile> files = folder_of(small_preset("human-normal"));
  std::erase_if(files, [](const NamedFile& file) { return file.name.starts_with("papillary"); });
  EXPECT_TRUE(imported(files, 648));
}

TEST(SlicerHeart, ASkirtAloneAndATableOfChordsAreTaken) {
  std::vector<NamedFile> files = folder_of(small_preset("human-normal"));
  std::erase_if(files, [](const NamedFile& file) {
    return file.name.ends_with("_leaflet.vtk") || file.name == "Chords_mesh.vtk";
  });
  const Expected<std::vector<Markup>> tips =
      read_markups(named(files, "papillary_muscle_tips.mrk.json").bytes);
  ASSERT_TRUE(tips);
  std::string table;
  for (Eigen::Index i = 0; i < (*tips)[0].points_mm.rows(); ++i) {
    const Vec3 tip = (*tips)[0].points_mm.row(i);
    table += std::to_string(i + 1) + ',' + std::to_string(tip.x()) + ',' + std::to_string(tip.y()) +
             ',' + std::to_string(tip.z()) + ',' + std::to_string(0.8 * tip.x()) +
             ",-6,-13,leaflet-primary-x-01\n";
  }
  files.push_back({"leaflet-primary.csv", table});
  const Expected<ImportSource> source = read_slicerheart(files);
  ASSERT_TRUE(source) << source.errors()[0].message;
  EXPECT_EQ(source->leaflets.size(), 1U);
  EXPECT_EQ(std::ssize(source->chordae), (*tips)[0].points_mm.rows());
}

TEST(SlicerHeart, AFolderInRasIsTurned) {
  std::vector<NamedFile> files = folder_of(small_preset("human-normal"));
  NamedFile& sheet = named(files, "anterior_leaflet.vtk");
  const Expected<ImportSource> lps = read_slicerheart(files);
  const std::size_t at = sheet.bytes.find("SPACE=LPS");
  sheet.bytes.replace(at, 9, "SPACE=RAS");
  const Expected<ImportSource> ras = read_slicerheart(files);
  ASSERT_TRUE(lps && ras);
  EXPECT_EQ(ras->leaflets[0].vertices_mm.col(0), -lps->leaflets[0].vertices_mm.col(0));
  EXPECT_EQ(ras->leaflets[0].vertices_mm.col(2), lps->leaflets[0].vertices_mm.col(2));
}

TEST(SlicerHeart, WhatIsMissingIsAllListed) {
  const Errors errors =
      problems({{"notes.txt", "hello"}, {"measurements.csv", "Metric,Value,Unit\n"}});
  ASSERT_EQ(errors.size(), 2U);
  EXPECT_NE(errors[0].message.find("one anterior and one posterior"), std::string::npos);
  EXPECT_NE(errors[1].message.find("save the annulus contour curve"), std::string::npos);
}

TEST(SlicerHeart, AFolderIsKnownByItsFilesAlone) {
  EXPECT_TRUE(is_slicerheart_folder({"leaflets.vtk", "annulus.mrk.json"}));
  EXPECT_TRUE(is_slicerheart_folder({"/home/leaflets.vtk", "/home/Chords_mesh.vtk"}));
  EXPECT_FALSE(is_slicerheart_folder({"/chordae/a.vtk", "/chordae/p.vtk", "/chordae/ring.csv"}));
  EXPECT_FALSE(is_slicerheart_folder({"a.obj", "p.obj", "ring.mrk.json"}));
}

TEST(SlicerHeart, AFolderWithoutChordaeGivesTheTipsForDrawnOnes) {
  std::vector<NamedFile> files = folder_of(small_preset("human-normal"));
  std::erase_if(files, [](const NamedFile& file) { return file.name.starts_with("Chords"); });
  const Expected<ImportSource> source = read_slicerheart(files);
  ASSERT_TRUE(source);
  EXPECT_TRUE(source->chordae.empty());
  ASSERT_EQ(source->tips.size(), 6U);
  EXPECT_EQ(source->tips.front().side, Side::Anterolateral);
  const Expected<Valve> refused = import_valve(*source, {});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.errors().front().path, "/chordae");
}

TEST(SlicerHeart, ProblemsOfAllFilesNameFileAndPlace) {
  std::vector<NamedFile> files = folder_of(small_preset("human-normal"));
  named(files, "anterior_leaflet.vtk").bytes.insert(200, " x ");
  named(files, "annulus.mrk.json").bytes = "{}";
  files.push_back({"chords.csv", "1,0,0,0,1,1,1,a\n2,0,0,zero,1,1,1,b\n"});
  const Errors errors = problems(files);
  std::vector<std::string> paths;
  for (const Error& error : errors) paths.push_back(error.path);
  EXPECT_TRUE(paths[0].starts_with("anterior_leaflet.vtk/vertices_mm/")) << paths[0];
  EXPECT_EQ(paths[1], "annulus.mrk.json/@schema");
  EXPECT_EQ(paths.back(), "chords.csv/chordae/1");
}

}  // namespace
}  // namespace coapt
