#include "io/exchange/abaqus_valve.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "io/exchange/abaqus_input.h"
#include "io/json/valve_json.h"
#include "tests/io/exchange/abaqus_cone.h"

namespace coapt {
namespace {

TEST(AbaqusValve, HasLeafletsAnnulusAndChordaeOfTheInput) {
  const Expected<Valve> valve = read_abaqus_valve(abaqus_cone(), {"cone", {"by hand"}});
  ASSERT_TRUE(valve) << valve.errors().front().path << ' ' << valve.errors().front().message;
  EXPECT_EQ(valve->name, "cone");
  EXPECT_EQ(valve->rest_mm.rows(), 24);
  EXPECT_EQ(valve->faces.rows(), 32);
  ASSERT_EQ(valve->leaflets.size(), 2u);
  EXPECT_EQ(valve->leaflets[0].name, "a");
  EXPECT_DOUBLE_EQ(valve->leaflets[0].thickness_mm, 0.65);
  EXPECT_DOUBLE_EQ(valve->leaflets[0].tissue.c0_kpa, 1.0);
  EXPECT_DOUBLE_EQ(valve->leaflets[1].tissue.c1_kpa, 0.188);
  EXPECT_DOUBLE_EQ(valve->leaflets[1].tissue.c2, 14.8);
  EXPECT_DOUBLE_EQ(valve->pressure_kpa, 3.0);
  EXPECT_DOUBLE_EQ(valve->tissue.density_g_per_mm3, 1e-3);
  EXPECT_EQ(valve->annulus.size(), 8u);
  EXPECT_NEAR(annulus_position_mm(*valve, 0).x(), 14.75, 1e-6);
  EXPECT_NEAR(annulus_position_mm(*valve, 0).z(), 0.5, 1e-12);
  ASSERT_EQ(valve->heads.size(), 1u);
  ASSERT_EQ(valve->chordae.size(), 1u);
  const std::vector<ChordaSegment>& segments = valve->chordae[0].segments;
  ASSERT_EQ(segments.size(), 3u);  // the node half way is no branch point
  EXPECT_NEAR(segments[0].rest_length_mm, 2.0 * std::sqrt(9.0 + 1.0 + 36.0), 1e-9);
  EXPECT_NEAR(segments[0].modulus_kpa, 3.0 * 15.0 * 1e3, 1e-6);
  EXPECT_NEAR(0.25 * std::numbers::pi * segments[0].diameter_mm * segments[0].diameter_mm, 0.3,
              1e-12);
  EXPECT_TRUE(segments[1].inserts && segments[2].inserts);
  EXPECT_NEAR(
      (position(segments[2].insertion, valve->faces, valve->rest_mm) - Vec3(valve->rest_mm.row(16)))
          .norm(),
      0.0, 1e-12);
}

TEST(AbaqusValve, TouchesAtTheRatioOfTheShortestDiagonal) {
  // The outer rows: chords of 15 and 12 mm, 5 mm apart along the cone; the inner ones are shorter.
  const Expected<Valve> valve = read_abaqus_valve(abaqus_cone(), {});
  ASSERT_TRUE(valve);
  const Vec3 a = valve->rest_mm.row(8), b = valve->rest_mm.row(17);
  EXPECT_NEAR(valve->tissue.thickness_mm, 0.05 * (a - b).norm(), 1e-7);  // decimals of the file
}

TEST(AbaqusValve, WithoutARatioTouchesAtTheThicknessOfItsThinnestLeaflet) {
  std::string text = abaqus_cone();
  const std::string ratio = ", MAXRATIO=0.05";
  text.erase(text.find(ratio), ratio.size());
  const Expected<Valve> valve = read_abaqus_valve(text, {"cone", {"by hand"}});
  ASSERT_TRUE(valve);
  EXPECT_DOUBLE_EQ(valve->tissue.thickness_mm, 0.5);
}

TEST(AbaqusValve, ReadsBackFromItsFileBitForBit) {
  const Expected<Valve> valve = read_abaqus_valve(abaqus_cone(), {});
  ASSERT_TRUE(valve);
  const std::string text = write_valve(*valve);
  const Expected<Valve> again = read_any_valve(text);
  ASSERT_TRUE(again) << again.errors().front().path << ' ' << again.errors().front().message;
  EXPECT_EQ(write_valve(*again), text);
  const Expected<Valve> mitral = read_valve(text);
  ASSERT_FALSE(mitral);
  EXPECT_EQ(mitral.errors().front().path, "/schema");
}

TEST(AbaqusValve, NamesTheLineThatCannotBeRead) {
  const Expected<AbaqusModel> model = read_abaqus("*NODE\n1, 0., 0., 0.\n2, 0., x, 0.\n");
  ASSERT_FALSE(model);
  EXPECT_EQ(model.errors().front().path, "/lines/3");
  EXPECT_EQ(model.errors().front().code, ErrorCode::WrongType);
}

TEST(AbaqusValve, RefusesWhatMightChangeTheModel) {
  for (const char* more : {"*SPRING, ELSET=A\n", "*STEP\n", "*DSLOAD\nFace, HP, 1.\n"}) {
    const Expected<Valve> valve = read_abaqus_valve(abaqus_cone(more), {});
    ASSERT_FALSE(valve) << more;
    EXPECT_EQ(valve.errors().front().code, ErrorCode::Unsupported) << more;
  }
  const Expected<AbaqusModel> brick = read_abaqus("*ELEMENT, TYPE=C3D8\n1,1,2,3,4,5,6,7,8\n");
  ASSERT_FALSE(brick);
  EXPECT_EQ(brick.errors().front().code, ErrorCode::Unsupported);
}

TEST(AbaqusValve, SaysWhatIsMissing) {
  EXPECT_EQ(read_abaqus_valve("", {}).errors().front().path, "/pressure");
  std::string no_ring = abaqus_cone();
  no_ring.replace(no_ring.find("Annulus,3,3,0.5\n"), 16, "");
  EXPECT_EQ(read_abaqus_valve(no_ring, {}).errors().front().path, "/boundary");
}

}  // namespace
}  // namespace coapt
