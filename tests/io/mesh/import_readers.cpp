#include "io/mesh/import_readers.h"

#include <gtest/gtest.h>

#include "io/mesh/csv_table.h"
#include "io/mesh/import_valve.h"

namespace coapt {
namespace {

constexpr const char* kNamed =
    "# traced by hand\n"
    "# id,length_mm,papillary,kind,ins_x,ins_y,ins_z,tip_x,tip_y,tip_z\n"
    "7,19.1,AL,strut,1,2,-3,4.5,5,-6\n"
    "\n"
    "8,19.2,posteromedial,basal,-1,-2,-3,-4.5,-5,-6\n";

constexpr const char* kJson = R"({"chordae": [
  {"id": "7", "papillary": "AL", "kind": "strut", "insertion_mm": [1, 2, -3], "tip_mm": [4.5, 5, -6]},
  {"id": "8", "papillary": "posteromedial", "kind": "basal", "insertion_mm": [-1, -2, -3],
   "tip_mm": [-4.5, -5, -6]}]})";

void expect_two(const Expected<std::vector<ImportedChorda>>& chordae) {
  ASSERT_TRUE(chordae) << chordae.errors()[0].path << ": " << chordae.errors()[0].message;
  ASSERT_EQ(chordae->size(), 2U);
  EXPECT_EQ((*chordae)[0].id, "7");
  EXPECT_EQ((*chordae)[0].side, Side::Anterolateral);
  EXPECT_EQ((*chordae)[0].kind, ChordaKind::Strut);
  EXPECT_EQ((*chordae)[0].insertion_mm, Vec3(1.0, 2.0, -3.0));
  EXPECT_EQ((*chordae)[0].tip_mm, Vec3(4.5, 5.0, -6.0));
  EXPECT_EQ((*chordae)[1].side, Side::Posteromedial);
  EXPECT_EQ((*chordae)[1].kind, ChordaKind::Basal);
  EXPECT_EQ((*chordae)[1].tip_mm, Vec3(-4.5, -5.0, -6.0));
}

TEST(ImportReaders, CsvColumnsAreFoundByName) { expect_two(read_chordae(kNamed, "csv")); }

TEST(ImportReaders, JsonGivesTheSameChordae) { expect_two(read_chordae(kJson, "json")); }

TEST(ImportReaders, CsvWithoutNamesHasTheDocumentedColumns) {
  const auto chordae = read_chordae("3,anterior,PM,1,2,-3,4,5,-6,19.1,0.8\n", "csv");
  ASSERT_TRUE(chordae);
  ASSERT_EQ(chordae->size(), 1U);
  EXPECT_EQ((*chordae)[0].side, Side::Posteromedial);
  EXPECT_EQ((*chordae)[0].kind, ChordaKind::Marginal);
  EXPECT_EQ((*chordae)[0].tip_mm, Vec3(4.0, 5.0, -6.0));
}

TEST(ImportReaders, EveryProblemOfATableNamesItsRowColumnAndLine) {
  const auto chordae = read_chordae(
      "id,papillary,ins_x,ins_y,ins_z,tip_x,tip_y,tip_z\n"
      "1,AL,1,2,3,4,5,6\n2,XX,1,two,nan,4,5,6\n3,PM,1,2\n",
      "csv");
  ASSERT_FALSE(chordae);
  const Errors& errors = chordae.errors();
  ASSERT_EQ(errors.size(), 4U);
  EXPECT_EQ(errors[0].path, "/chordae/1/papillary");
  EXPECT_EQ(errors[0].code, ErrorCode::BadReference);
  EXPECT_EQ(errors[1].path, "/chordae/1/ins_y");
  EXPECT_EQ(errors[1].message, "line 3: must be a number");
  EXPECT_EQ(errors[2].path, "/chordae/1/ins_z");
  EXPECT_EQ(errors[2].code, ErrorCode::OutOfRange);
  EXPECT_EQ(errors[3].path, "/chordae/2");
  EXPECT_EQ(errors[3].message, "line 4: has 4 fields, must have 8");
}

TEST(ImportReaders, AMissingColumnIsNamed) {
  const auto chordae = read_chordae("id,papillary,ins_x,ins_y,ins_z,tip_x,tip_y\n", "csv");
  ASSERT_FALSE(chordae);
  EXPECT_EQ(chordae.errors()[0].code, ErrorCode::MissingField);
  EXPECT_EQ(chordae.errors()[0].message, "has no column tip_z");
}

TEST(ImportReaders, ProblemsOfJsonHavePointers) {
  const auto chordae = read_chordae(
      R"({"chordae": [{"id": "1", "papillary": "left", "insertion_mm": [1, 2], "tip_mm": [0, 0, 1e9]}]})",
      "json");
  ASSERT_FALSE(chordae);
  const Errors& errors = chordae.errors();
  ASSERT_EQ(errors.size(), 3U);
  EXPECT_EQ(errors[0].path, "/chordae/0/papillary");
  EXPECT_EQ(errors[1].path, "/chordae/0/insertion_mm");
  EXPECT_EQ(errors[2].path, "/chordae/0/tip_mm");
  EXPECT_FALSE(read_chordae("[[[[", "json"));
  EXPECT_EQ(read_chordae("", "xml").errors()[0].code, ErrorCode::Unsupported);
}

TEST(ImportReaders, PointsAreReadWithCommentsAndWithoutTheirNames) {
  const auto points = read_points_csv("# a ring\nx,y,z\n1,2,3\r\n 4 , 5 , 6.5 \n");
  ASSERT_TRUE(points);
  ASSERT_EQ(points->rows(), 2);
  EXPECT_EQ(points->row(1), Eigen::RowVector3d(4.0, 5.0, 6.5));
}

TEST(ImportReaders, TheSamePointsInAnyTable) {
  for (const char* table :
       {"1.5,2,3\n4,5,6.5\n",
        "\xef\xbb\xbfx,y,z\r\n1.5,2,3\r\n4,5,6.5\r\n",
        "1.5\t2\t3\n4\t5\t6.5\n",
        "1.5 2   3\n  4 5 6.5 \n",
        "1.5;2;3\n4;5;6.5\n",
        "x;y;z\n1,5;2;3\n4;5;6,5\n",
        "1,5 2,0 3,0\n4,0 5,0 6,5\n",
        "1,5\t2\t3\n4\t5\t6,5\n",
        "y,z,id,x\n2,3,7,1.5\n5,6.5,8,4\n",
        "id,X [mm],Y [mm],Z [mm]\n1,1.5,2,3\n2,4,5,6.5\n",
        "\"Points:0\",\"Points:1\",\"Points:2\",\"Block Name\"\n1.5,2,3,a\n4,5,6.5,a\n",
        "% x y z\n1.5 2 3\n4 5 6.5\n",
        "// traced\n# x_mm y_mm z_mm\n1.5 2 3\n4 5 6.5\n",
        "# x_mm,y_mm,z_mm  2 points, in order [1 0], traced\n1.5,2,3\n4,5,6.5\n",
        "# from x\n1.5,2,3\n4,5,6.5\n",
        "label,r,a,s\nF-1,1.5,2,3\nF-2,4,5,6.5\n",
        "\"1.5\",\"2\",\"3\"\n\"4\",\"5\",\"6,5\"\n",
        "x,y,z\nmm,mm,mm\n1.5,2,3\n4,5,6.5\n",
        "x;y;z\n[mm];[mm];[mm]\n1,5;2;3\n4;5;6,5\n",
        "1.5,2,3,\n4,5,6.5,\n",
        "x,y,z\r1.5,2,3\r4,5,6.5\r",
        "Pos X,Pos Y,Pos Z\n1.5,2,3\n4,5,6.5\n",
        "Xmm;Ymm;Zmm\n1,5;2;3\n4;5;6,5\n;;\n",
        "Node Number,X Location (mm),Y Location (mm),Z Location (mm)\n1,1.5,2,3\n2,4,5,6.5\n",
        "COORD.COOR1,COORD.COOR2,COORD.COOR3\n1.5,2,3\n4,5,6.5\n",
        "Position_0,Position_1,Position_2,Magnitude\n1.5,2,3,9\n4,5,6.5,9\n",
        "Var1,Var2,Var3\n1.5,2,3\n4,5,6.5\n",
        ",0,1,2\n0,1.5,2,3\n1,4,5,6.5\n",
        "sep=;\nx;y;z\n1,5;2;3\n4;5;6,5\n",
        "Annulus of case 3\nx,y,z\n1.5,2,3\n4,5,6.5\n",
        "Pos X  Pos Y  Pos Z\n1.5  2  3\n4  5  6.5\n",
        "# Markups fiducial file version = 4.11\n# CoordinateSystem = LPS\n# columns = "
        "id,x,y,z,ow,label\n"
        "1,1.5,2,3,0,C-1\n2,4,5,6.5,0,C-2\n"}) {
    const Expected<Points> points = read_points_csv(table);
    ASSERT_TRUE(points) << table << points.errors()[0].message;
    ASSERT_EQ(points->rows(), 2) << table;
    EXPECT_EQ(points->row(0), Eigen::RowVector3d(1.5, 2.0, 3.0)) << table;
    EXPECT_EQ(points->row(1), Eigen::RowVector3d(4.0, 5.0, 6.5)) << table;
  }
}

TEST(ImportReaders, AFieldWithoutANameIsThatOfItsRowOrRefused) {
  for (const char* table :
       {"x,y,z\n\"a\",1.5,2,3\n\"b\",4,5,6.5\n", "x y z\n1 1.5 2 3\n2 4 5 6.5\n",
        "x,y,z\n0,1.5,2,3,,\n1,4,5,6.5,,\n",
        "# Markups fiducial file version = 5.0\n# columns = id,x,y,z,associatedNodeID\n"
        "1,1.5,2,3,,2,0\n2,4,5,6.5,,2,0\n"}) {
    const Expected<Points> points = read_points_csv(table);
    ASSERT_TRUE(points) << table << points.errors()[0].message;
    EXPECT_EQ(points->row(1), Eigen::RowVector3d(4.0, 5.0, 6.5)) << table;
  }
  for (const char* table : {"x,y,z\n1,5,2,5,3,5\n4,5,5,5,6,5\n", "x,y,z\na,1,2,3\n4,5,6\n",
                            "x,y,z\n1,2,3,0.7\n4,5,6,0.9\n"}) {
    const Expected<Points> points = read_points_csv(table);
    ASSERT_FALSE(points) << table;
    EXPECT_NE(points.errors()[0].message.find(" fields, must have 3"), std::string::npos) << table;
  }
}

TEST(ImportReaders, ColumnsThatNothingNamesAreNotGuessed) {
  const Expected<Points> four = read_points_csv("0,1.5,2,3\n1,4,5,6.5\n");
  ASSERT_FALSE(four);
  EXPECT_NE(four.errors()[0].message.find("has 4 columns without names"), std::string::npos);
  for (const char* empty : {"", "x;y;z\n", "# a ring\n"}) EXPECT_FALSE(read_points_csv(empty));
  EXPECT_FALSE(read_tips_csv("papillary,x,y,z\n"));
  EXPECT_FALSE(read_chordae("id,papillary,ins_x,ins_y,ins_z,tip_x,tip_y,tip_z\n", "csv"));
  const Expected<Points> two = read_points_csv("x,y\n1,2\n");
  ASSERT_FALSE(two);
  EXPECT_NE(two.errors()[0].message.find("not all of x, y and z"), std::string::npos);
}

TEST(ImportReaders, NamesOfAxesStateTheUnit) {
  for (const auto& [names, unit] :
       {std::pair("x [cm],y [cm],z [cm]", std::optional(LengthUnit::Centimetre)),
        {"id;X (mm);Y (mm);Z (mm)", LengthUnit::Millimetre},
        {"x_m,y_m,z_m", LengthUnit::Metre},
        {"x (in),y,z", LengthUnit::Inch},
        {"Xcm,Ycm,Zcm", LengthUnit::Centimetre},
        {"x in cm,y in cm,z in cm", LengthUnit::Centimetre},
        {"# units: cm\nx,y,z", LengthUnit::Centimetre},
        {"x (um),y (um),z (um)", LengthUnit::Millimetre},
        {"x [inch],y [inch],z [inch]", LengthUnit::Inch},
        {"X [Millimetres],Y [Millimetres],Z [Millimetres]", LengthUnit::Millimetre},
        {"x,y,z,time_m", std::nullopt},
        {"x (LPS),y,z", std::nullopt}})
    EXPECT_EQ(stated_unit(names + std::string("\n1,2,3\n")), unit) << names;
}

TEST(ImportReaders, NamesOfAxesMayStateWhatIsNoUnit) {
  for (const auto& [names, stated] : {std::pair("x [px],y [px],z [px]", "px"),
                                      {"x [cm],y [voxel],z", "voxel"},
                                      {"x [cm],y,z", ""},
                                      {"x (LPS),y (LPS),z (LPS)", ""},
                                      {"x [0],y [1],z [2]", ""},
                                      {"x,y,z,score [px]", ""}})
    EXPECT_EQ(read_csv(names + std::string("\n1,2,3\n"), {"x"})->no_unit, stated) << names;
}

TEST(ImportReaders, ColumnsOfDifferentUnitsBecomeThatOfTheFirst) {
  for (const char* table : {"x [mm],y [mm],z [cm]\n10,20,3\n", "x,y,z\nmm,mm,cm\n10,20,3\n",
                            "z_cm,x_mm,y_mm\n3,10,20\n"}) {
    const double unit = table[0] == 'z' ? 0.1 : 1.0;
    const Expected<Points> points = read_points_csv(table);
    ASSERT_TRUE(points) << table << points.errors()[0].message;
    EXPECT_TRUE(points->row(0).isApprox(unit * Eigen::RowVector3d(10, 20, 30))) << table;
  }
  const std::string chordae =
      "id,papillary,ins_x [cm],ins_y [cm],ins_z [cm],tip_x [mm],tip_y [mm],tip_z [mm]\n"
      "1,AL,1,2,3,40,50,60\n";
  EXPECT_EQ(stated_unit(chordae, {"papillary"}), LengthUnit::Centimetre);
  const auto read = read_chordae(chordae, "csv");
  ASSERT_TRUE(read) << read.errors()[0].message;
  EXPECT_EQ((*read)[0].insertion_mm, Vec3(1, 2, 3));
  EXPECT_TRUE((*read)[0].tip_mm.isApprox(Vec3(4, 5, 6)));
}

TEST(ImportReaders, TextInSixteenBitsIsNamed) {
  const Expected<Points> points = read_points_csv(std::string("\xff\xfex\0,\0y\0", 8));
  ASSERT_FALSE(points);
  EXPECT_NE(points.errors()[0].message.find("UTF-16"), std::string::npos);
}

TEST(ImportReaders, TipsByTheirColumnsOrTheirLabels) {
  for (const char* table :
       {"AL,1,2,3\nPM,4,5,6\n", "x,y,z,papillary\n1,2,3,AL\n4,5,6,posteromedial\n",
        "# columns = id,x,y,z,label\n1,1,2,3,AL-1\n2,4,5,6,PM-1\n"}) {
    const auto tips = read_tips_csv(table);
    ASSERT_TRUE(tips) << table << tips.errors()[0].message;
    ASSERT_EQ(tips->size(), 2U);
    EXPECT_EQ((*tips)[0].side, Side::Anterolateral);
    EXPECT_EQ((*tips)[1].side, Side::Posteromedial);
    EXPECT_EQ((*tips)[1].position_mm, Vec3(4, 5, 6)) << table;
  }
  EXPECT_EQ(read_tips_csv("left,1,2,3\n").errors()[0].path, "/tips/0/papillary");
}

TEST(ImportReaders, MicrometresAreReadAsMillimetres) {
  for (const char* table :
       {"x (um),y (um),z (um)\n1500,2000,-3e6\n", "# coordinates in microns\n1500,2000,-3e6\n"}) {
    const Expected<Points> points = read_points_csv(table);
    ASSERT_TRUE(points) << points.errors()[0].message;
    EXPECT_TRUE(points->row(0).isApprox(Eigen::RowVector3d(1.5, 2.0, -3000.0))) << table;
  }
}

TEST(ImportReaders, AxesBesideTheNamesAreThoseOfTheTableOrRefused) {
  for (const char* names : {"x (RAS),y (RAS),z (RAS)", "x_RAS,y_RAS,z_RAS", "x (R),y (A),z (S)"})
    EXPECT_EQ(read_csv(names + std::string("\n1,2,3\n"), {"x"})->axes, "ras") << names;
  EXPECT_FALSE(read_points_csv("x (L),y (A),z (S)\n1,2,3\n"));
}

TEST(ImportReaders, ColumnsThatMeanTheSameAreNotGuessed) {
  EXPECT_FALSE(read_points_csv("x1,y1,z1,x2,y2,z2\n1,2,3,4,5,6\n"));
  EXPECT_EQ(read_points_csv("Pos X,x,y,z\n9,1,2,3\n")->row(0), Eigen::RowVector3d(1, 2, 3));
}

TEST(ImportReaders, SidesInTheWordsOfTheField) {
  for (const auto& [lateral, medial] : {std::pair("al", "pm"),
                                        {"ALPM", "PMPM"},
                                        {"APM", "PPM"},
                                        {"antero-lateral", "medial"},
                                        {"PM anterolateral", "PM posteromedial"},
                                        {"anterior", "posterior"}}) {
    const auto tips =
        read_tips_csv("Side,X,Y,Z\n" + std::string(lateral) + ",1,2,3\n" + medial + ",4,5,6\n");
    ASSERT_TRUE(tips) << lateral << tips.errors()[0].message;
    EXPECT_EQ((*tips)[0].side, Side::Anterolateral) << lateral;
    EXPECT_EQ((*tips)[1].side, Side::Posteromedial) << medial;
  }
  const auto chordae = read_chordae(
      "papillary muscle,Insertion X,Insertion Y,Insertion Z,Tip X,Tip Y,Tip Z\nALPM,1,2,3,4,5,6\n",
      "csv");
  ASSERT_TRUE(chordae) << chordae.errors()[0].message;
  EXPECT_EQ((*chordae)[0].id, "1");
}

TEST(ImportReaders, APointThatIsNoneNamesItsLine) {
  const auto points = read_points_csv("1,2,3\n1,2\n1,,3\n");
  ASSERT_FALSE(points);
  ASSERT_EQ(points.errors().size(), 2U);
  EXPECT_EQ(points.errors()[0].path, "/points/1");
  EXPECT_EQ(points.errors()[1].message, "line 3: must be a number");
}

}  // namespace
}  // namespace coapt
