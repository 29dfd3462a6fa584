#include "io/exchange/file_roles.h"

#include <gtest/gtest.h>

#include "io/exchange/companion_files.h"
#include "io/exchange/part_names.h"

namespace coapt {
namespace {

std::vector<FileRole> roles_of(const std::vector<NamedFile>& files) {
  std::vector<FileRole> roles;
  for (const GuessedRole& guess : guessed_roles(files)) roles.push_back(guess.role);
  return roles;
}

TEST(PartNames, CommonSpellingsOfSlicerHeartAndPapers) {
  for (const char* name :
       {"Anterior leaflet", "anterior_leaflet_sheet", "AMVL", "mv-ant", "A", "Mitral valve: AML"})
    EXPECT_EQ(part_named(name), NamedPart::Anterior) << name;
  for (const char* name : {"POSTERIOR", "PosteriorLeaflet", "pmvl", "post leaflet", "P"})
    EXPECT_EQ(part_named(name), NamedPart::Posterior) << name;
  for (const char* name : {"Annulus", "anterior annulus", "mitral ring", "MVAnnulusContour"})
    EXPECT_EQ(part_named(name), NamedPart::Annulus) << name;
  for (const char* name : {"P1", "p2 scallop", "Segment P3", "anterolateral commissural leaflet"})
    EXPECT_EQ(part_named(name), NamedPart::Posterior) << name;
  for (const char* name :
       {"", "leaflets", "anterior and posterior", "apple", "string", "anterolateral"})
    EXPECT_EQ(part_named(name), std::nullopt) << name;
  for (const char* name : {"Septal leaflet", "tricuspid anterior leaflet", "ATL", "aortic valve"})
    EXPECT_EQ(part_named(name), NamedPart::OtherLeaflet) << name;
  for (const char* name : {"left ventricle", "LA", "Aorta", "tricuspid annulus"})
    EXPECT_EQ(part_named(name), NamedPart::Other) << name;
  EXPECT_EQ(part_named("commissure A"), NamedPart::Commissure);
  EXPECT_EQ(part_named("MA"), NamedPart::Annulus);
  EXPECT_EQ(part_named("papillary AL"), NamedPart::Tips);
  for (const char* name : {"Left atrium", "LA", "left atrial blood pool"})
    EXPECT_EQ(annulus_side_named(name), AnnulusSide::Atrium) << name;
  for (const char* name : {"Left ventricle", "LV myocardium", "papillary muscle"})
    EXPECT_EQ(annulus_side_named(name), AnnulusSide::Ventricle) << name;
  for (const char* name : {"Right atrium", "RV", "LVOT", "left atrial appendage", "aorta", "A"})
    EXPECT_EQ(annulus_side_named(name), std::nullopt) << name;
}

TEST(FileRoles, LabelMapsByTheirExtension) {
  EXPECT_EQ(roles_of({{"x.nrrd", ""}}), (std::vector{FileRole::Labels}));
  EXPECT_EQ(roles_of({{"x.seg.NRRD", ""}}), (std::vector{FileRole::Labels}));
  EXPECT_EQ(roles_of({{"x.nii.gz", ""}}), (std::vector{FileRole::Labels}));
  EXPECT_EQ(roles_of({{"x.nrrd.bz2", ""}}), (std::vector{FileRole::Labels}));
}

TEST(FileRoles, MeshesByNameElseInTheOrderGiven) {
  EXPECT_EQ(roles_of({{"posterior.stl", ""}, {"anterior.stl", ""}}),
            (std::vector{FileRole::Posterior, FileRole::Anterior}));
  EXPECT_EQ(roles_of({{"1.stl", ""}, {"2.ply", ""}}),
            (std::vector{FileRole::Anterior, FileRole::Posterior}));
  EXPECT_EQ(roles_of({{"1.stl", ""}, {"ant.stl", ""}}),
            (std::vector{FileRole::Posterior, FileRole::Anterior}));
  EXPECT_EQ(roles_of({{"valve.vtk", ""}}), (std::vector{FileRole::Anterior})) << "a skirt";
  EXPECT_EQ(roles_of({{"1.stl", ""}, {"2.stl", ""}, {"3.stl", ""}}),
            (std::vector{FileRole::None, FileRole::None, FileRole::None}));
}

TEST(FileRoles, LandmarksHaveACommissureAmongTheirLabels) {
  EXPECT_EQ(roles_of({{"l.csv", "label,x,y,z\nALC,1,2,3\nAL,4,5,6\n"}}),
            (std::vector{FileRole::Landmarks}));
  EXPECT_EQ(roles_of({{"t.csv", "label,x,y,z\nAL,1,2,3\nPM,4,5,6\n"}}),
            (std::vector{FileRole::Tips}));
}

TEST(FileRoles, NamesOfFilesThatMayBePartsOfAValve) {
  for (const char* name : {"a.OBJ", "ring.csv", "x.mrk.json", "x.nii.gz", "m.vtm", "v.raw"})
    EXPECT_TRUE(may_have_role(name)) << name;
  for (const char* name : {"README.md", "LICENSE", "shot.png"})
    EXPECT_FALSE(may_have_role(name)) << name;
}

TEST(FileRoles, TablesAndMarkupsByWhatTheyHold) {
  EXPECT_EQ(roles_of({{"a.csv", "1,2,3\n"}}), (std::vector{FileRole::Annulus}));
  for (const char* empty : {"", "# x,y,z\n"})
    EXPECT_EQ(roles_of({{"a.csv", empty}}), (std::vector{FileRole::None})) << empty;
  EXPECT_EQ(roles_of({{"a.csv", "AL,1,2,3\n"}}), (std::vector{FileRole::Tips}));
  EXPECT_EQ(roles_of({{"a.csv",
                       "# id,papillary,ins_x,ins_y,ins_z,tip_x,tip_y,tip_z\n1,AL,1,2,3,4,5,6\n"}}),
            (std::vector{FileRole::Chordae}));
  EXPECT_EQ(roles_of({{"a.json", R"({"chordae": []})"}}), (std::vector{FileRole::Chordae}));
  const auto markups = [](const std::string& type, const std::string& label) {
    return R"({"@schema": "https://raw.githubusercontent.com/slicer/slicer/master/Modules/Loadable/Markups/Resources/Schema/markups-schema-v1.0.3.json#",
      "markups": [{"type": ")" +
           type + R"(", "controlPoints": [{"label": ")" + label +
           R"(", "position": [1, 2, 3]}]}]})";
  };
  EXPECT_EQ(roles_of({{"a.mrk.json", markups("ClosedCurve", "x")}}),
            (std::vector{FileRole::Annulus}));
  EXPECT_EQ(roles_of({{"a.mrk.json", markups("Fiducial", "PM 2")}}), (std::vector{FileRole::Tips}));
  EXPECT_EQ(roles_of({{"a.mrk.json", markups("Fiducial", "x")}}), (std::vector{FileRole::None}));
  EXPECT_EQ(roles_of({{"a.json", "{"}}), (std::vector{FileRole::None}));
}

TEST(FileRoles, DecisionsDoNotRepeatNamesOfFiles) {
  const Expected<SortedFiles> sorted = sorted_files(
      {{"DOE JANE anterior.stl", "s"}, {"DOE JANE posterior.stl", "t"}, {"doe.csv", "1,2,3"}});
  ASSERT_TRUE(sorted);
  ASSERT_EQ(sorted->decisions.size(), 3U);
  EXPECT_EQ(sorted->decisions[0].value, "file 1 of 3 (.stl) is the anterior leaflet");
  for (const ImportDecision& decision : sorted->decisions) {
    EXPECT_EQ((decision.value + decision.reason).find("DOE"), std::string::npos);
    EXPECT_FALSE(decision.reason.empty());
  }
  ASSERT_EQ(sorted->files.leaflets.size(), 2U);
  EXPECT_EQ(sorted->files.leaflets[1].bytes, "t");
  EXPECT_TRUE(sorted->files.annulus);
}

TEST(FileRoles, MeshesThatNothingTellsApartAreLeftToAnatomy) {
  const auto claim = [](const std::vector<NamedFile>& files) {
    return sorted_files(files)->files.order.claim;
  };
  EXPECT_EQ(claim({{"1.stl", ""}, {"2.stl", ""}, {"c.csv", "1,2,3"}}), LeafletClaim::Guessed);
  EXPECT_EQ(claim({{"1.stl", ""}, {"posterior.stl", ""}}), LeafletClaim::Named);
}

TEST(PartNames, SidesAreThoseOfScallopsCommissuresAndMuscles) {
  for (const char* name : {"A1", "P1 scallop", "anterolateral papillary muscle", "AL commissure",
                           "papillary AL PM", "AL-tip"})
    EXPECT_EQ(side_named(name), Side::Anterolateral) << name;
  for (const char* name :
       {"p3", "Mitral A3", "posteromedial commissure", "PM commissure", "papillary_PM"})
    EXPECT_EQ(side_named(name), Side::Posteromedial) << name;
  for (const char* name : {"", "P2", "PM", "al", "anterior", "lateral", "A10", "palm"})
    EXPECT_EQ(side_named(name), std::nullopt) << name;
}

TEST(FileRoles, ACommissureIsAFileOfThePosteriorLeaflet) {
  const Expected<SortedFiles> sorted = sorted_files({{"AL_commissure.stl", ""},
                                                     {"anterior.stl", ""},
                                                     {"posterior.stl", ""},
                                                     {"PM commissure.stl", ""}});
  ASSERT_TRUE(sorted) << sorted.errors()[0].message;
  EXPECT_EQ(sorted->files.order.called[1], "the union of files 1, 3, 4");
  EXPECT_EQ(roles_of({{"AL_commissure.csv", "x,y\n"}}), (std::vector{FileRole::None})) << "a place";
}

TEST(FileRoles, ScallopsAreFilesOfOneLeaflet) {
  const Expected<SortedFiles> sorted =
      sorted_files({{"P1.stl", ""}, {"anterior.stl", ""}, {"P3.stl", ""}, {"P2.stl", ""}});
  ASSERT_TRUE(sorted);
  EXPECT_EQ(sorted->files.leaflets.size(), 4U);
  EXPECT_EQ(sorted->files.posterior_from, 1U);
  EXPECT_EQ(sorted->files.order.called[1], "the union of files 1, 3, 4");
  EXPECT_FALSE(sorted_files({{"anterior.stl", ""}, {"anterior2.stl", ""}, {"anterior.ply", ""}}));
}

TEST(FileRoles, LinesAreTheAnnulusAndALeafletOfAnotherValveIsNamed) {
  EXPECT_EQ(roles_of({{"a.obj", "v 0 0 0\nf 1 1 1\n"}, {"x.obj", "v 0 0 0\nl 1 1\n"}}),
            (std::vector{FileRole::Anterior, FileRole::Annulus}));
  EXPECT_EQ(roles_of({{"ring.obj", "v 0 0 0\nf 1 1 1\n"}}), (std::vector{FileRole::Anterior}))
      << "all parts in one file";
  EXPECT_EQ(roles_of({{"a.vtp", "NumberOfLines=\"0\" NumberOfStrips=\"0\" NumberOfPolys=\"2\""},
                      {"x.vtp", "NumberOfLines=\"1\" NumberOfStrips=\"0\" NumberOfPolys=\"0\""}}),
            (std::vector{FileRole::Anterior, FileRole::Annulus}));
  const Expected<SortedFiles> septal =
      sorted_files({{"anterior.stl", ""}, {"posterior.stl", ""}, {"septal.stl", ""}});
  ASSERT_FALSE(septal);
  EXPECT_NE(septal.errors()[0].message.find("another valve"), std::string::npos);
}

TEST(FileRoles, TwoOfOneRoleAndUnknownFilesAreNamed) {
  const Expected<SortedFiles> twice = sorted_files({{"a.nrrd", ""}, {"b.nii", ""}});
  ASSERT_FALSE(twice);
  EXPECT_EQ(twice.errors()[0].path, "/files/1");
  EXPECT_EQ(twice.errors()[0].message,
            "is a label map, as is file 1; only one file per role is allowed");
  EXPECT_EQ(sorted_files({{"a.pdf", ""}}).errors()[0].path, "/files/0");
}

const std::string kBlocks =
    "<?xml version=\"1.0\"?>\n<VTKFile type=\"vtkMultiBlockDataSet\" version=\"1.0\">\n"
    "<vtkMultiBlockDataSet>\n<DataSet index=\"0\" name=\"posterior\" file=\"m/m_0.obj\"/>\n"
    "<Block index=\"1\" name=\"anterior\"><DataSet index=\"0\" file=\"m/m_1.obj\"/></Block>\n"
    "</vtkMultiBlockDataSet>\n</VTKFile>\n";

TEST(CompanionFiles, PiecesOfAMultiBlockAreCalledAsItsBlocks) {
  EXPECT_EQ(*companions_of({"m.vtm", kBlocks}),
            (std::vector<std::string>{"m/m_0.obj", "m/m_1.obj"}));
  const Expected<SortedFiles> sorted =
      sorted_files({{"m.vtm", kBlocks}, {"m_0.obj", "back"}, {"m_1.obj", "front"}});
  ASSERT_TRUE(sorted) << sorted.errors()[0].message;
  ASSERT_EQ(sorted->files.leaflets.size(), 2U);
  EXPECT_EQ(sorted->files.leaflets[0].bytes, "front");
  EXPECT_EQ(sorted->files.order.claim, LeafletClaim::Named);
  EXPECT_EQ(sorted->files.order.called[0], "file 3");
  EXPECT_EQ(sorted->places[0], (std::pair<std::string, std::size_t>{"/leaflets/0", 2}));
  EXPECT_EQ(sorted_files({{"m.vtm", kBlocks}, {"m_0.obj", ""}}).errors()[0].path, "/files/0");
  std::string elsewhere = kBlocks;
  elsewhere.replace(elsewhere.find("m/m_0"), 5, "../m0");
  EXPECT_EQ(companions_of({"m.vtm", elsewhere}).errors()[0].code, ErrorCode::Unsupported);
}

TEST(CompanionFiles, VoxelsAreJoinedToTheirHeader) {
  const std::string header = "NRRD0004\nsizes: 1 1 1\ndata file: x.raw.gz\nencoding: gzip\n";
  const Expected<SortedFiles> sorted = sorted_files({{"x.raw.gz", "voxels"}, {"x.nhdr", header}});
  ASSERT_TRUE(sorted) << sorted.errors()[0].message;
  ASSERT_TRUE(sorted->files.labels);
  EXPECT_TRUE(sorted->files.labels->bytes.ends_with("gzip\n\nvoxels"));
  EXPECT_EQ(sorted->places[0].second, 1U);
  EXPECT_EQ(sorted->decisions[0].value, "file 1 holds the voxels of file 2");
  EXPECT_FALSE(sorted_files({{"x.raw.gz", "voxels"}, {"x.nhdr", header + "data file: y.raw\n"}}));
}

}  // namespace
}  // namespace coapt
