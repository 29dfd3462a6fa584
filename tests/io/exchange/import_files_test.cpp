#include "io/exchange/import_files.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "io/exchange/markups.h"

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
  EXPECT_EQ(source->decisions[0].value, "leaflets: RAS, converted to LPS");
  EXPECT_EQ(source->decisions[0].reason,
            "as given, contrary to their headers, which state SPACE=LPS");
  EXPECT_TRUE(source->decisions[0].look);
  EXPECT_FALSE(read_import_files(with_head(""), reading)->decisions[0].look);
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
  EXPECT_EQ(source->decisions[1].value, "annulus, chordae, papillary tips: LPS");
  ImportReading reading;
  reading.axes = PatientAxes::RAS;
  source = read_import_files(files, reading);
  ASSERT_TRUE(source);
  EXPECT_EQ(Vec3(source->annulus_mm.row(0)), Vec3(-1, -2, 3));
  EXPECT_EQ(source->chordae[0].insertion_mm, Vec3(-1, -2, 3));
  EXPECT_EQ(source->chordae[0].tip_mm, Vec3(-4, -5, 6));
  EXPECT_EQ(source->tips[0].position_mm, Vec3(-1, -2, 3));
}

/// Two plates and a square ring about them in 20 x 20 x 4 voxels of 1 mm, as ASCII NRRD. The ring begins at 14 half voxels.
std::string labels_nrrd(const std::string& keys, const std::array<int, 3>& labels,
                        int plates_end = 12) {
  std::string text =
      "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 20 20 4\nspace: left-posterior-superior\n"
      "space directions: (1,0,0) (0,1,0) (0,0,1)\nspace origin: (5,6,7)\nencoding: ascii\n" +
      keys + "\n";
  for (int k = 0; k < 4; ++k)
    for (int j = 0; j < 20; ++j)
      for (int i = 0; i < 20; ++i) {
        const int out = std::max(std::abs(2 * i - 19), std::abs(2 * j - 19));
        const bool plate = out < plates_end && (k == 1 || k == 2);
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

/// What is said of labels.
std::string told(const ImportSource& source) {
  std::string all;
  for (const ImportDecision& decision : source.decisions) all += sentence(decision) + '\n';
  return all;
}

TEST(ImportFiles, LabelsWithoutNamesAreLeftToAnatomyAndTheClosedBandIsTheAnnulus) {
  for (const std::array<int, 3>& labels : {std::array{1, 2, 3}, {3, 1, 2}, {17, 40, 5}}) {
    ImportFiles files;
    files.labels = {"DOE.nrrd", labels_nrrd("", labels)};
    const Expected<ImportSource> source = read_import_files(files);
    ASSERT_TRUE(source) << source.errors()[0].path << source.errors()[0].message;
    ASSERT_EQ(source->leaflets.size(), 2U);
    EXPECT_EQ(source->annulus_mm.rows(), 72);
    EXPECT_EQ(source->order.claim, LeafletClaim::Guessed);
    const bool first = labels[0] < labels[1];  // by number, until the import has looked at them
    EXPECT_LT(source->leaflets[first ? 0 : 1].vertices_mm.col(1).maxCoeff(), 15.8);
    EXPECT_GT(source->leaflets[first ? 1 : 0].vertices_mm.col(1).minCoeff(), 16.2);
    EXPECT_EQ(source->order.called[first ? 0 : 1], "label " + std::to_string(labels[0]));
  }
}

TEST(ImportFiles, ABandThatLeafletsBeginAtIsAsWideAsItIs) {
  ImportFiles files;
  files.labels = {"x.nrrd", labels_nrrd("", {1, 2, 3}, 14)};
  const Expected<ImportSource> beside = read_import_files(files);
  ASSERT_TRUE(beside) << beside.errors()[0].message;
  // 240 voxels about some 58 mm.
  EXPECT_NEAR(beside->annulus_band_mm, std::sqrt(240.0 / (58.0 * M_PI)), 0.1);
  files.labels = {"x.nrrd", labels_nrrd("", {1, 2, 3}, 10)};
  EXPECT_EQ(read_import_files(files)->annulus_band_mm, 0.0) << "two voxels are between them";
}

TEST(ImportFiles, LabelsByNameOrAsGiven) {
  ImportFiles files;
  files.labels = {"x.nrrd", labels_nrrd("Segment0_Name:=DOE^JANE anterior\nSegment0_LabelValue:=8\n"
                                        "Segment1_Name:=posterior\nSegment1_LabelValue:=7\n",
                                        {8, 7, 3})};
  Expected<ImportSource> source = read_import_files(files);
  ASSERT_TRUE(source) << source.errors()[0].path << source.errors()[0].message;
  EXPECT_EQ(source->annulus_mm.rows(), 72) << "nothing names it, but it is a closed band";
  EXPECT_EQ(source->order.claim, LeafletClaim::Named);
  EXPECT_NE(told(*source).find("label 8 is the anterior leaflet"), std::string::npos);
  EXPECT_NE(told(*source).find("the anterior leaflet ends flat, with 60 voxels in one plane"),
            std::string::npos)
      << "they are plates";
  const std::vector kPlates = {false, true, false, true, false, false};
  EXPECT_EQ(looks(*source), kPlates);
  EXPECT_EQ(told(*source).find("DOE"), std::string::npos);

  ImportReading reading;
  reading.labels = {{7}, {8}, {3}};
  source = read_import_files(files, reading);
  ASSERT_TRUE(source);
  EXPECT_GT(source->leaflets[0].vertices_mm.col(1).minCoeff(), 16.2);
  EXPECT_EQ(source->order.claim, LeafletClaim::Given);
  EXPECT_EQ(source->order.swap, "say --label anterior=8 --label posterior=7");
  EXPECT_EQ(looks(*source), kPlates);

  reading.labels = {{}, {8}, {}};  // the other one is the other leaflet, whatever its name says
  files.labels = {"x.nrrd", labels_nrrd("", {8, 7, 3})};
  source = read_import_files(files, reading);
  ASSERT_TRUE(source);
  EXPECT_EQ(source->order.called[0], "label 7");
}

/// Two plates, the second one cut in two at the middle.
std::string scallops_nrrd(const std::string& keys) {
  std::string text = labels_nrrd(keys, {1, 2, 3});
  std::size_t voxel = text.find("\n\n") + 2;
  for (int i = 0; voxel < text.size(); voxel += 2, ++i)
    if (text[voxel] == '2' && i % 20 > 9) text[voxel] = '4';
  return text;
}

TEST(ImportFiles, SeveralLabelsMakeALeafletByNameOrAsGiven) {
  ImportFiles files;
  files.labels = {
      "x.nrrd",
      scallops_nrrd("Segment0_Name:=A\nSegment0_LabelValue:=1\nSegment1_Name:=P1\n"
                    "Segment1_LabelValue:=2\nSegment2_Name:=P2\nSegment2_LabelValue:=4\n")};
  const Expected<ImportSource> named = read_import_files(files);
  ASSERT_TRUE(named) << named.errors()[0].message;
  EXPECT_EQ(named->order.called[1], "the union of labels 2 and 4");
  files.labels = {"x.nrrd", scallops_nrrd("")};
  const Expected<ImportSource> unnamed = read_import_files(files);
  ASSERT_FALSE(unnamed) << "three that could be leaflets";
  EXPECT_EQ(unnamed.errors()[0].path, "/label_numbers");
  ImportReading reading;
  reading.labels = {{1}, {2, 4}, {}};
  const Expected<ImportSource> given = read_import_files(files, reading);
  ASSERT_TRUE(given) << given.errors()[0].message;
  EXPECT_EQ(given->leaflets[1].faces, named->leaflets[1].faces);
}

TEST(ImportFiles, ACommissureOfItsOwnIsOfThePosteriorLeafletAndItsNameTellsTheSide) {
  ImportFiles files;
  files.labels = {
      "x.nrrd",
      scallops_nrrd("Segment0_Name:=Anterior\nSegment0_LabelValue:=1\nSegment1_Name:=Posterior\n"
                    "Segment1_LabelValue:=2\nSegment2_Name:=AL commissure\n"
                    "Segment2_LabelValue:=4\n")};
  const Expected<ImportSource> source = read_import_files(files);
  ASSERT_TRUE(source) << source.errors()[0].message;
  EXPECT_EQ(source->order.called[1], "the union of labels 2 and 4");
  ASSERT_EQ(source->sided.size(), 1U);
  EXPECT_EQ(source->sided[0].side, Side::Anterolateral);
  EXPECT_NEAR(source->sided[0].position_mm.x(), 5.0 + 12.5, 0.51) << "the middle of its box";
  EXPECT_EQ(source->axes, SourceAxes::Stated);
}

TEST(ImportFiles, NamesOfScallopsThatAreOverruledTellNoSide) {
  ImportFiles files;
  files.labels = {"x.nrrd",
                  scallops_nrrd("Segment0_Name:=A\nSegment0_LabelValue:=1\nSegment1_Name:=P1\n"
                                "Segment1_LabelValue:=2\nSegment2_Name:=P3\n"
                                "Segment2_LabelValue:=4\n")};
  EXPECT_EQ(read_import_files(files)->sided.size(), 2U);
  ImportReading reading;
  reading.labels = {{1}, {2, 4}, {}};
  EXPECT_TRUE(read_import_files(files, reading)->sided.empty());
}

TEST(ImportFiles, ChambersAndPapillaryMusclesAreWitnessesOfTheirSide) {
  for (const auto& [name, side] : {std::pair("Left atrium", AnnulusSide::Atrium),
                                   {"AL papillary muscle", AnnulusSide::Ventricle}}) {
    ImportFiles files;
    files.labels = {"x.nrrd",
                    scallops_nrrd("Segment0_Name:=A\nSegment0_LabelValue:=1\nSegment1_Name:=P\n"
                                  "Segment1_LabelValue:=2\nSegment2_Name:=" +
                                  std::string(name) + "\nSegment2_LabelValue:=4\n")};
    const Expected<ImportSource> source = read_import_files(files);
    ASSERT_TRUE(source) << name << source.errors()[0].message;
    ASSERT_EQ(source->witnesses.size(), 1U) << name;
    EXPECT_EQ(source->witnesses[0].side, side);
    EXPECT_NEAR(source->witnesses[0].position_mm.x(), 5.0 + 12.5, 0.51);
  }
}

TEST(ImportFiles, ALabelMapThatIsNotPlacedLeavesTheAxesOpen) {
  std::string text = labels_nrrd("", {1, 2, 3});
  text.erase(text.find("space: "), text.find("space directions") - text.find("space: "));
  ImportFiles files;
  files.labels = {"x.nrrd", text};
  EXPECT_EQ(read_import_files(files)->axes, SourceAxes::Unknown);
}

TEST(ImportFiles, PartsOfAMeshThatAreNamedAfterTheirSideAreTurnedWithIt) {
  ImportFiles files;
  files.leaflets = {{"a.obj",
                     "# SPACE=RAS\no A1\nv 1 2 3\nv 2 2 3\nv 1 3 3\nf 1 2 3\no P3\nv 4 5 6\n"
                     "v 4 5 6\nv 4 5 6\nv 5 5 6\nv 5 6 6\nf 6 7 8\n"}};
  const Expected<ImportSource> source = read_import_files(files);
  ASSERT_TRUE(source) << source.errors()[0].message;
  ASSERT_EQ(source->sided.size(), 2U);
  EXPECT_LT(source->sided[1].position_mm.x(), -4.0);
  EXPECT_EQ(source->axes, SourceAxes::Stated);
}

TEST(ImportFiles, LeafletsOfOtherValvesAreRefusedOrLeftOut) {
  ImportFiles files;
  const auto with_names = [&](const std::string& before) {
    files.labels = {"x.nrrd",
                    scallops_nrrd("Segment0_Name:=" + before +
                                  "anterior leaflet\nSegment0_LabelValue:=1\n"
                                  "Segment1_Name:=" +
                                  before +
                                  "posterior leaflet\nSegment1_LabelValue:=2\n"
                                  "Segment2_Name:=Septal leaflet\nSegment2_LabelValue:=4\n")};
    return read_import_files(files);
  };
  const Expected<ImportSource> tricuspid = with_names("");
  ASSERT_FALSE(tricuspid);
  EXPECT_EQ(tricuspid.errors()[0].code, ErrorCode::Unsupported);
  const Expected<ImportSource> both = with_names("Mitral ");
  ASSERT_TRUE(both);
  EXPECT_NE(told(*both).find("1 of 4 labels not used: 4"), std::string::npos) << told(*both);
  ImportReading reading;
  reading.labels = {{1}, {2}, {}};
  const Expected<ImportSource> given = read_import_files(files, reading);
  ASSERT_TRUE(given);
  EXPECT_NE(told(*given).find("not used"), std::string::npos);
}

TEST(ImportFiles, OneLabelALayerCountsByLayer) {
  std::string text = labels_nrrd("kinds: list domain domain domain\n", {1, 2, 3});
  text.replace(text.find("dimension: 3"), 12, "dimension: 4");
  text.replace(text.find("sizes: "), 7, "sizes: 3 ");
  text.replace(text.find("space directions: "), 18, "space directions: none ");
  const std::size_t voxels = text.find("\n\n") + 2;
  std::string layered = text.substr(0, voxels);
  for (std::size_t at = voxels; at < text.size(); at += 2)
    for (const char label : {'3', '2', '1'}) layered += text[at] == label ? "1 " : "0 ";
  ImportFiles files;
  files.labels = {"x.nrrd", layered};
  const Expected<ImportSource> source = read_import_files(files);
  ASSERT_TRUE(source) << source.errors()[0].path << source.errors()[0].message;
  EXPECT_EQ(source->annulus_mm.rows(), 72);
  EXPECT_EQ(source->order.called, (std::array<std::string, 2>{"label 2", "label 3"}));
}

TEST(ImportFiles, LabelsThatAreNotThereOrTwiceAreNamed) {
  ImportFiles files;
  files.labels = {"x.nrrd", labels_nrrd("", {1, 0, 3})};
  EXPECT_EQ(read_import_files(files).errors()[0].path, "/label_numbers/anterior");
  files.labels = {"x.nrrd", labels_nrrd("", {1, 5, 3})};
  ImportReading reading;
  reading.labels = {{1}, {1}, {}};
  EXPECT_EQ(read_import_files(files, reading).errors()[0].path, "/label_numbers");
  reading.labels = {{9}, {}, {}};
  EXPECT_EQ(read_import_files(files, reading).errors()[0].path, "/label_numbers/anterior");
  reading.labels = {{1}, {5}, {1}};
  EXPECT_FALSE(read_import_files(files, reading));
  reading.labels = {{1}, {3}, {5}};
  EXPECT_FALSE(read_import_files(files, reading)) << "a plate is no ring";
  files.leaflets = {{"a.obj", kTriangle}};
  EXPECT_EQ(read_import_files(files, {}).errors()[0].path, "/labels");
}

TEST(ImportFiles, AClosedCurveOfSlicerIsASplineAndNeedsPoints) {
  const auto curve = [](int points, const std::string& more) {
    std::string list;
    for (int i = 0; i < points; ++i) {
      const double angle = 2.0 * M_PI * i / points;
      list += (i == 0 ? "" : ",") + std::string("{\"position\": [") +
              std::to_string(18.0 * std::cos(angle)) + ',' +
              std::to_string(18.0 * std::sin(angle)) + ",0]}";
    }
    return R"({"@schema": "https://raw.githubusercontent.com/slicer/slicer/master/Modules/Loadable/Markups/Resources/Schema/markups-schema-v1.0.3.json#",
      "markups": [{"type": "ClosedCurve", )" +
           more + R"("controlPoints": [)" + list + "]}]}";
  };
  const auto length = [](const Points& loop) {
    double sum = 0.0;
    for (Eigen::Index i = 0; i < loop.rows(); ++i)
      sum += (loop.row((i + 1) % loop.rows()) - loop.row(i)).norm();
    return sum;
  };
  const double round = 36.0 * M_PI;
  for (const auto& [points, share] :
       {std::pair(8, 0.005), {14, 0.001}, {40, 0.0005}, {60, 0.0005}}) {
    const Expected<Points> loop = read_closed_loop(curve(points, ""), "json");
    ASSERT_TRUE(loop) << points;
    EXPECT_NEAR(length(*loop), round, share * round) << points;
  }
  EXPECT_EQ(read_closed_loop(curve(14, R"("curveType": "linear", )"), "json")->rows(), 14);
  for (const int few : {0, 3}) {
    const Expected<Points> loop = read_closed_loop(curve(few, ""), "json");
    ASSERT_FALSE(loop);
    EXPECT_EQ(loop.errors()[0].path, "/markups");
  }
}

TEST(ImportFiles, OfSeveralClosedCurvesTheOneNamedAsTheAnnulusIsTaken) {
  const auto document = [](const std::vector<std::string>& names) {
    std::vector<Markup> curves;
    for (const std::string& name : names) {
      Markup& curve = curves.emplace_back();
      curve.type = MarkupType::ClosedCurve;
      curve.name = name;
      curve.points_mm = Points::Constant(60, 3, static_cast<double>(curves.size()));
      curve.labels.resize(60);
    }
    return write_markups(curves);
  };
  EXPECT_EQ((*read_closed_loop(document({"C"}), "json"))(0, 0), 1.0);
  EXPECT_EQ((*read_closed_loop(document({"Tricuspid annulus", "MV annulus"}), "json"))(0, 0), 2.0);
  for (const auto& names :
       {std::vector<std::string>{"C", "C_1"}, {"Annulus", "Mitral annulus"}, {"free edge", "x"}})
    EXPECT_FALSE(read_closed_loop(document(names), "json")) << names[0];
}

TEST(ImportFiles, ASurfaceIsNoAnnulus) {
  for (const char* format : {"stl", "ply", "vtu"}) {
    const Expected<Points> loop = read_closed_loop("solid x\n", format);
    ASSERT_FALSE(loop);
    EXPECT_EQ(loop.errors()[0].code, ErrorCode::Unsupported);
  }
}

TEST(ImportFiles, TablesOfSlicerSayTheirAxes) {
  for (const auto& [head, turned] :
       {std::pair("# CoordinateSystem = LPS\n# columns = id,x,y,z\n", false),
        {"# CoordinateSystem = 0\n# columns = id,x,y,z\n", true},
        {"label,r,a,s\n", true},
        {"label,l,p,s\n", false},
        {"# columns = id,x,y,z\n", true}}) {
    ImportFiles files = with_head("");
    files.annulus = {"ring.fcsv", head + std::string("1,1,2,3\n")};
    const Expected<ImportSource> source = read_import_files(files);
    ASSERT_TRUE(source) << head << source.errors()[0].message;
    EXPECT_EQ(source->annulus_mm(0, 0), turned ? -1.0 : 1.0) << head;
  }
}

TEST(ImportFiles, ATableOfVoxelsIsRefused) {
  for (const char* system : {"2", "IJK"}) {
    ImportFiles files = with_head("");
    files.annulus = {"ring.fcsv", std::string("# CoordinateSystem = ") + system +
                                      "\n# columns = id,x,y,z\n1,1,2,3\n"};
    const Expected<ImportSource> source = read_import_files(files);
    ASSERT_FALSE(source) << system;
    EXPECT_EQ(source.errors()[0].path, "/annulus");
    EXPECT_EQ(source.errors()[0].code, ErrorCode::Unsupported);
  }
}

TEST(ImportFiles, AFrameOfNoFileIsNotUsed) {
  ImportReading reading;
  reading.axes = PatientAxes::RAS;
  ImportFiles files;
  files.labels = {"x.nrrd", labels_nrrd("", {1, 2, 3})};
  const Expected<ImportSource> map = read_import_files(files, reading);
  ASSERT_TRUE(map) << map.errors()[0].message;
  EXPECT_EQ(map->decisions.back().value, "frame not used");
  EXPECT_TRUE(map->decisions.back().look);
  files.annulus = {"a.csv", "1,2,3\n4,5,6\n"};
  EXPECT_EQ(read_import_files(files, reading)->decisions.back().value,
            "annulus: RAS, converted to LPS");
}

TEST(ImportFiles, ColumnsThatNothingReadsAreSaidOnceAndByPlainNamesAlone) {
  ImportFiles files = with_head("# SPACE=LPS\n");
  files.annulus = {"a.csv", "x,y,z,weight,DOE^JANE\n1,2,3,4,5\n4,5,6,7,8\n"};
  files.chordae = {"c.csv", "id,papillary,ins_x,ins_y,ins_z,tip_x,tip_y,tip_z\n1,AL,1,2,3,4,5,6\n"};
  const Expected<ImportSource> source = read_import_files(files);
  ASSERT_TRUE(source);
  EXPECT_EQ(source->decisions[0].value, "annulus: 2 of 5 columns not used: weight and 1 more");
  EXPECT_EQ(source->decisions[1].subject, "axes");
}

TEST(ImportFiles, UnitsThatAreNoneAreDoubted) {
  for (const auto& [unit, value] : {std::pair("px", "annulus: \"px\" is ignored"),
                                    {"DOE^JANE", "annulus: what is stated is ignored"}}) {
    ImportFiles files = with_head("# SPACE=LPS\n");
    const std::string in = std::string(" [") + unit + "],";
    files.annulus = {"a.csv", "x" + in + "y" + in + "z" + in + "\n1,2,3,\n4,5,6,\n"};
    const Expected<ImportSource> source = read_import_files(files);
    ASSERT_TRUE(source) << source.errors()[0].message;
    EXPECT_EQ(source->decisions[0].subject, "units");
    EXPECT_EQ(source->decisions[0].value, value);
    EXPECT_TRUE(source->decisions[0].look);
  }
}

TEST(ImportFiles, ArraysThatNothingReadsAreSaid) {
  ImportFiles files;
  files.leaflets = {
      {"a.vtk",
       "# vtk DataFile Version 3.0\nx\nASCII\nDATASET POLYDATA\nPOINTS 3 float\n1 2 3 2 2 "
       "3 1 3 3\nPOLYGONS 1 4\n3 0 1 2\nCELL_DATA 1\nSCALARS strain float 1\n"
       "LOOKUP_TABLE default\n0.5\n"}};
  files.leaflets.push_back(files.leaflets[0]);
  const Expected<ImportSource> two = read_import_files(files);
  ASSERT_TRUE(two);
  EXPECT_EQ(two->decisions[0].value, "leaflet 1: 1 of 1 arrays not used: strain");
  files.leaflets.pop_back();
  const Expected<ImportSource> one = read_import_files(files);
  ASSERT_TRUE(one);
  EXPECT_EQ(one->decisions[0].value, "leaflets: 1 of 1 arrays not used: strain");
}

TEST(ImportFiles, LandmarksHaveTheAxesOfTheirFile) {
  ImportFiles files = with_head("# SPACE=RAS\n");
  files.landmarks = {"l.csv", "# SPACE=RAS\nP,1,2,3\n"};
  const Expected<ImportSource> source = read_import_files(files);
  ASSERT_TRUE(source);
  EXPECT_EQ(source->landmarks.mid_posterior_mm, Vec3(-1, -2, 3));
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
