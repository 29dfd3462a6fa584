#include "io/exchange/import_files.h"

#include <gtest/gtest.h>

namespace coapt {
namespace {

const std::string kTriangle = "v 1 2 3\nv 2 2 3\nv 1 3 3\nf 1 2 3\n";

ImportFiles with_head(const std::string& head) {
  ImportFiles files;
  files.leaflets = {{"a.obj", head + kTriangle}};
  return files;
}

Vec3 first_vertex(const ImportFiles& files, const ImportReading& reading = {}) {
  const Expected<ImportSource> source = read_import_files(files, reading);
  return source ? Vec3(source->leaflets[0].vertices_mm.row(0)) : Vec3::Zero().eval();
}

TEST(ImportFiles, AHeaderOfSlicerSaysTheAxes) {
  EXPECT_EQ(first_vertex(with_head("")), Vec3(1, 2, 3));
  EXPECT_EQ(first_vertex(with_head("# SPACE=LPS\n")), Vec3(1, 2, 3));
  EXPECT_EQ(first_vertex(with_head("# SPACE=RAS\n")), Vec3(-1, -2, 3));
  ImportFiles vtk;
  vtk.leaflets = {{"a.vtk",
                   "# vtk DataFile Version 5.1\n3D Slicer output. SPACE=RAS\nASCII\nDATASET "
                   "POLYDATA\nPOINTS 3 float\n1 2 3 2 2 3 1 3 3\nPOLYGONS 2 3\nOFFSETS "
                   "vtktypeint64\n0 3\nCONNECTIVITY vtktypeint64\n0 1 2\n"}};
  EXPECT_EQ(first_vertex(vtk), Vec3(-1, -2, 3));
}

TEST(ImportFiles, GivenAxesOverruleAHeaderAndTheDecisionSaysSo) {
  ImportReading reading;
  reading.axes = PatientAxes::RAS;
  EXPECT_EQ(first_vertex(with_head(""), reading), Vec3(-1, -2, 3));
  const Expected<ImportSource> source = read_import_files(with_head("# SPACE=LPS\n"), reading);
  ASSERT_TRUE(source);
  ASSERT_EQ(source->decisions.size(), 1U);
  EXPECT_EQ(source->decisions[0].decision, "leaflet 1: RAS, turned to LPS");
  EXPECT_EQ(source->decisions[0].reason, "as given, against their headers, which say SPACE=LPS");
}

TEST(ImportFiles, FilesOfDifferentAxesAreTurnedOneByOne) {
  ImportFiles files = with_head("# SPACE=RAS\n");
  files.annulus = {"a.csv", "1,2,3\n4,5,6\n"};
  files.chordae = {"c.csv", "1,anterior,AL,1,2,3,4,5,6\n"};
  files.tips = {"t.csv", "AL,1,2,3\n"};
  Expected<ImportSource> source = read_import_files(files);
  ASSERT_TRUE(source);
  EXPECT_EQ(Vec3(source->annulus_mm.row(0)), Vec3(1, 2, 3));
  ASSERT_EQ(source->decisions.size(), 2U);
  EXPECT_EQ(source->decisions[1].decision, "annulus, chordae, papillary tips: LPS");
  ImportReading reading;
  reading.axes = PatientAxes::RAS;
  source = read_import_files(files, reading);
  ASSERT_TRUE(source);
  EXPECT_EQ(Vec3(source->annulus_mm.row(0)), Vec3(-1, -2, 3));
  EXPECT_EQ(source->chordae[0].insertion_mm, Vec3(-1, -2, 3));
  EXPECT_EQ(source->chordae[0].tip_mm, Vec3(-4, -5, 6));
  EXPECT_EQ(source->tips[0].position_mm, Vec3(-1, -2, 3));
}

/// Two plates and a square ring about them in 20 x 20 x 4 voxels of 1 mm, as ASCII NRRD.
std::string labels_nrrd(const std::string& keys, const std::array<int, 3>& labels) {
  std::string text =
      "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 20 20 4\nspace: left-posterior-superior\n"
      "space directions: (1,0,0) (0,1,0) (0,0,1)\nspace origin: (5,6,7)\nencoding: ascii\n" +
      keys + "\n";
  for (int k = 0; k < 4; ++k)
    for (int j = 0; j < 20; ++j)
      for (int i = 0; i < 20; ++i) {
        const int out = std::max(std::abs(2 * i - 19), std::abs(2 * j - 19));
        const bool plate = out < 12 && (k == 1 || k == 2);
        const int label = plate && j < 9    ? labels[0]
                          : plate && j > 10 ? labels[1]
                          : out == 15       ? labels[2]
                                            : 0;
        text += std::to_string(label) + ' ';
      }
  return text;
}

std::vector<bool> looks(const ImportSource& source) {
  std::vector<bool> found;
  for (const ImportDecision& decision : source.decisions) found.push_back(decision.look);
  return found;
}

TEST(ImportFiles, LabelsByNumberByNameOrAsGiven) {
  ImportFiles files;
  files.labels = {"DOE.nrrd", labels_nrrd("", {1, 2, 3})};
  Expected<ImportSource> source = read_import_files(files);
  ASSERT_TRUE(source) << source.errors()[0].path << source.errors()[0].message;
  ASSERT_EQ(source->leaflets.size(), 2U);
  EXPECT_EQ(source->annulus_mm.rows(), 72);
  EXPECT_LT(source->leaflets[0].vertices_mm.col(1).maxCoeff(), 15.8);
  EXPECT_GT(source->leaflets[1].vertices_mm.col(1).minCoeff(), 16.2);
  EXPECT_EQ(looks(*source), (std::vector{true, true, true, false})) << "numbers alone chose";

  files.labels = {"x.nrrd", labels_nrrd("Segment0_Name:=DOE^JANE anterior\nSegment0_LabelValue:=8\n"
                                        "Segment1_Name:=posterior\nSegment1_LabelValue:=7\n",
                                        {8, 7, 3})};
  source = read_import_files(files);
  ASSERT_TRUE(source) << source.errors()[0].path << source.errors()[0].message;
  EXPECT_EQ(source->annulus_mm.rows(), 0) << "other labels are named, this one is not";
  EXPECT_EQ(source->decisions[0].decision, "label 8 is the anterior leaflet");
  EXPECT_EQ(looks(*source), (std::vector{false, false, false}));
  for (const ImportDecision& decision : source->decisions)
    EXPECT_EQ((decision.decision + decision.reason).find("DOE"), std::string::npos);

  ImportReading reading;
  reading.labels = {7, 8, 3};
  source = read_import_files(files, reading);
  ASSERT_TRUE(source);
  EXPECT_GT(source->leaflets[0].vertices_mm.col(1).minCoeff(), 16.2);
  EXPECT_EQ(source->annulus_mm.rows(), 72);
  EXPECT_EQ(looks(*source), (std::vector{false, false, false, false}));
}

TEST(ImportFiles, LabelsThatAreNotThereOrTwiceAreNamed) {
  ImportFiles files;
  files.labels = {"x.nrrd", labels_nrrd("", {1, 5, 3})};
  EXPECT_EQ(read_import_files(files).errors()[0].path, "/label_numbers/posterior");
  ImportReading reading;
  reading.labels = {1, 1, {}};
  EXPECT_EQ(read_import_files(files, reading).errors()[0].path, "/label_numbers");
  reading.labels = {1, 5, 1};
  EXPECT_FALSE(read_import_files(files, reading)) << "a plate is no ring";
  files.leaflets = {{"a.obj", kTriangle}};
  EXPECT_EQ(read_import_files(files, {}).errors()[0].path, "/labels");
}

TEST(ImportFiles, ASeriesPlacesLabelsAndNeedsThem) {
  ImportReading reading;
  reading.series = ImageGeometry{{20, 20, 5}, Eigen::Matrix4d::Identity(), true};
  EXPECT_EQ(read_import_files(with_head(""), reading).errors()[0].path, "/labels");
  ImportFiles files;
  files.labels = {"x.nrrd", labels_nrrd("", {1, 2, 3})};
  EXPECT_EQ(read_import_files(files, reading).errors()[0].path, "/series");
}

}  // namespace
}  // namespace coapt
