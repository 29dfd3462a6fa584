#include <gtest/gtest.h>

#include <limits>

#include "cone_scene.h"
#include "io/mesh/source_units.h"

namespace coapt {
namespace {

/// The first problem of an import that must fail.
Error problem(const ImportSource& source, const ImportOptions& options = {}) {
  const Expected<Valve> valve = import_valve(source, options);
  EXPECT_FALSE(valve) << "was imported";
  return valve ? Error{} : valve.errors().front();
}

TEST(ImportErrors, MetresThatAreSaidToBeMillimetresAreCalledMetres) {
  ImportSource source = cone_source();
  scale(source, 0.001);
  const Error error = problem(source, {.units = LengthUnit::Millimetre});
  EXPECT_EQ(error.code, ErrorCode::BadGeometry);
  EXPECT_EQ(error.path, "/annulus_mm");
  EXPECT_NE(error.message.find("looks like metres"), std::string::npos) << error.message;
}

TEST(ImportErrors, UnitsMayNotBeMixed) {
  ImportSource annulus = cone_source(), leaflets = cone_source();
  annulus.annulus_mm *= 0.001;
  for (TriangleMesh& mesh : leaflets.leaflets) mesh.vertices_mm *= 0.1;
  EXPECT_EQ(problem(annulus).path, "/leaflets/0/vertices_mm");
  const Error error = problem(leaflets);
  EXPECT_EQ(error.path, "/leaflets/0/vertices_mm");
  EXPECT_NE(error.message.find("mixed units"), std::string::npos) << error.message;
  ImportSource chordae = cone_source();
  for (ImportedChorda& chorda : chordae.chordae) {
    chorda.tip_mm *= 0.001;
    chorda.insertion_mm *= 0.001;
  }
  EXPECT_EQ(problem(chordae).path, "/chordae");
}

TEST(ImportErrors, AnAnnulusOfOnePointIsNotCalledMetres) {
  ImportSource source = cone_source();
  source.annulus_mm *= 0.0;
  const Error error = problem(source);
  EXPECT_EQ(error.path, "/annulus_mm");
  EXPECT_NE(error.message.find("all points are the same"), std::string::npos) << error.message;
  EXPECT_EQ(error.message.find("metres"), std::string::npos) << error.message;
}

TEST(ImportErrors, AnAnnulusUnderPressureHasAsManyPoints) {
  ImportSource source = cone_source();
  source.pressed_annulus_mm = source.annulus_mm.topRows(7);
  EXPECT_EQ(problem(source).path, "/pressed_annulus_mm");
}

TEST(ImportErrors, SheetsInTheWrongOrderAreRefused) {
  ImportSource source = cone_source_with_gaps();
  std::swap(source.leaflets[0], source.leaflets[1]);
  EXPECT_EQ(problem(source).path, "/leaflets/0");
}

TEST(ImportErrors, AMirroredInputIsRefused) {
  ImportSource source = cone_source_with_gaps();
  source.annulus_mm.col(0) *= -1.0;
  for (TriangleMesh& mesh : source.leaflets) mesh.vertices_mm.col(0) *= -1.0;
  for (ImportedChorda& chorda : source.chordae) {
    chorda.insertion_mm.x() *= -1.0;
    chorda.tip_mm.x() *= -1.0;
  }
  EXPECT_EQ(problem(source).path, "/leaflets/0");
}

TEST(ImportErrors, AClosedSurfaceIsNoSheet) {
  ImportSource source = cone_source();
  source.leaflets[0] = {Points::Random(4, 3), Faces(4, 3)};
  source.leaflets[0].faces << 0, 1, 2, 0, 3, 1, 1, 3, 2, 2, 3, 0;
  EXPECT_EQ(problem(source).code, ErrorCode::BadTopology);
}

TEST(ImportErrors, AnAnnulusThatTurnsBackIsRefused) {
  ImportSource source = cone_source();
  source.annulus_mm.row(100).swap(source.annulus_mm.row(110));
  EXPECT_EQ(problem(source).code, ErrorCode::BadGeometry);
}

TEST(ImportErrors, ChordaeOfOneMuscleOnlyAreRefused) {
  ImportSource source = cone_source();
  source.chordae.pop_back();
  EXPECT_EQ(problem(source).code, ErrorCode::MissingField);
}

TEST(ImportErrors, AnInsertionFarFromTheLeafletsIsNamed) {
  ImportSource source = cone_source();
  source.chordae[1].insertion_mm.x() += 20.0;
  const Error error = problem(source);
  EXPECT_EQ(error.code, ErrorCode::BadGeometry);
  EXPECT_EQ(error.path, "/chordae/1/insertion_mm");
}

TEST(ImportErrors, SheetsThatDoNotReachTheAnnulusAreRefused) {
  ImportSource source = cone_source_with_gaps();
  source.leaflets = {cone(60, 120), cone(190, 350)};
  EXPECT_EQ(problem(source).path, "/leaflets");
  source = cone_source();
  source.leaflets[0].vertices_mm.col(2).array() -= 5.0;
  EXPECT_EQ(problem(source).path, "/leaflets");
}

TEST(ImportErrors, ACommissureOnOneSideOnlyIsRefused) {
  // The front, at 90 degrees, is bare; clockwise from there the posterior sheet comes first.
  ImportSource source = cone_source();
  source.leaflets = {cone(100, 170), cone(190, 440)};
  const Error error = problem(source);
  EXPECT_EQ(error.path, "/leaflets");
  EXPECT_NE(error.message.find("two commissures"), std::string::npos) << error.message;
}

TEST(ImportErrors, HostileNumbersAreRefused) {
  ImportSource source = cone_source();
  source.leaflets[0].faces(3, 1) = 1 << 30;
  EXPECT_EQ(problem(source).code, ErrorCode::BadReference);
  source = cone_source();
  source.leaflets[0].vertices_mm(5, 2) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(problem(source).code, ErrorCode::OutOfRange);
  source = cone_source();
  source.chordae[1].id = source.chordae[0].id;
  EXPECT_EQ(problem(source).path, "/chordae/1/id");
  source = cone_source();
  source.chordae[0].tip_mm.x() = std::numeric_limits<double>::infinity();
  EXPECT_EQ(problem(source).path, "/chordae/0");
  source = cone_source();
  source.annulus_mm.conservativeResize(5, 3);
  EXPECT_EQ(problem(source).path, "/annulus_mm");
  source = cone_source();
  source.leaflets.clear();
  EXPECT_EQ(problem(source).path, "/leaflets");
}

TEST(ImportErrors, EveryOptionOutOfRangeIsListed) {
  ImportOptions options;
  options.triangles = 10;
  options.branches = 0;
  options.branch_at = 1.0;
  options.slack = std::numeric_limits<double>::quiet_NaN();
  const Expected<Valve> valve = import_valve(cone_source(), options);
  ASSERT_FALSE(valve);
  ASSERT_EQ(valve.errors().size(), 4U);
  EXPECT_EQ(valve.errors()[0].path, "/triangles");
  EXPECT_EQ(valve.errors()[3].path, "/slack");
}

}  // namespace
}  // namespace coapt
