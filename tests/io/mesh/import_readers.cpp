#include "io/mesh/import_readers.h"

#include <gtest/gtest.h>

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

TEST(ImportReaders, SemicolonsAreOneError) {
  for (const char* table : {"1;2;3\n4;5;6\n", "x;y;z\n1;2;3\n", "# loop\n1,5;2,5;3,5\n"}) {
    const Expected<Points> points = read_points_csv(table);
    ASSERT_FALSE(points) << table;
    ASSERT_EQ(points.errors().size(), 1U) << table;
    EXPECT_NE(points.errors()[0].message.find("semicolons"), std::string::npos)
        << points.errors()[0].message;
  }
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
