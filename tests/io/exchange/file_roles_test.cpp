#include "io/exchange/file_roles.h"

#include <gtest/gtest.h>

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
  for (const char* name : {"", "leaflets", "anterior and posterior", "commissure A", "apple",
                           "string", "anterolateral"})
    EXPECT_EQ(part_named(name), std::nullopt) << name;
  EXPECT_EQ(part_named("papillary AL"), NamedPart::Tips);
}

TEST(FileRoles, LabelMapsByTheirExtension) {
  EXPECT_EQ(roles_of({{"x.nrrd", ""}}), (std::vector{FileRole::Labels}));
  EXPECT_EQ(roles_of({{"x.seg.NRRD", ""}}), (std::vector{FileRole::Labels}));
  EXPECT_EQ(roles_of({{"x.nii.gz", ""}}), (std::vector{FileRole::Labels}));
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
  EXPECT_EQ(sorted->decisions[0].decision, "file 1 of 3 (.stl) is the anterior leaflet");
  for (const ImportDecision& decision : sorted->decisions) {
    EXPECT_EQ((decision.decision + decision.reason).find("DOE"), std::string::npos);
    EXPECT_FALSE(decision.reason.empty());
  }
  ASSERT_EQ(sorted->files.leaflets.size(), 2U);
  EXPECT_EQ(sorted->files.leaflets[1].bytes, "t");
  EXPECT_TRUE(sorted->files.annulus);
}

TEST(FileRoles, APersonShouldLookAtMeshesThatOnlyTheirOrderTellsApart) {
  const auto looks = [](const std::vector<NamedFile>& files) {
    const Expected<SortedFiles> sorted = sorted_files(files);
    std::vector<bool> found;
    for (const ImportDecision& decision : sorted->decisions) found.push_back(decision.look);
    return found;
  };
  EXPECT_EQ(looks({{"1.stl", ""}, {"2.stl", ""}, {"c.csv", "1,2,3"}}),
            (std::vector{true, true, false}));
  EXPECT_EQ(looks({{"1.stl", ""}, {"posterior.stl", ""}}), (std::vector{false, false}));
  EXPECT_EQ(looks({{"skirt.stl", ""}}), (std::vector{false}));
}

TEST(FileRoles, TwoOfOneRoleAndUnknownFilesAreNamed) {
  const Expected<SortedFiles> twice = sorted_files({{"a.nrrd", ""}, {"b.nii", ""}});
  ASSERT_FALSE(twice);
  EXPECT_EQ(twice.errors()[0].path, "/files/1");
  EXPECT_EQ(twice.errors()[0].message, "is a label map, as is file 1; must be one of each");
  EXPECT_EQ(sorted_files({{"a.pdf", ""}}).errors()[0].path, "/files/0");
}

}  // namespace
}  // namespace coapt
