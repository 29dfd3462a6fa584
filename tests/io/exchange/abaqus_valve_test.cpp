#include "io/exchange/abaqus_valve.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "io/exchange/abaqus_input.h"
#include "io/json/valve_json.h"

namespace coapt {
namespace {

/// A cone of eight columns and two rows: nodes 1 to 8 on the annulus (radius 15 mm), 9 to 16, 17 to
/// 24 at the free edge; two leaflets of four columns. Node 100 is a papillary point, 101 half way to
/// the branch point 102, from where trusses lead to the nodes 17 and 18. Normals point inwards and
/// down: to the ventricle.
std::string cone(const std::string& more = "") {
  std::string text = "*PART, NAME=Leaflet\n** a comment\n*NODE, NSET=All\n";
  for (int ring = 0; ring < 3; ++ring)
    for (int i = 0; i < 8; ++i) {
      const double angle = 0.25 * std::numbers::pi * i, r = 15.0 - 3.0 * ring;
      text += std::to_string(8 * ring + i + 1) + ", " + std::to_string(r * std::cos(angle)) + ", " +
              std::to_string(r * std::sin(angle)) + ", " + std::to_string(-4.0 * ring) + " \n";
    }
  text += "100, 0., 0., -30.\n101, 3., 1., -24.\n102, 6., 2., -18.\n";
  for (int half = 0; half < 2; ++half) {
    text += std::string("*element, type=S4R, elset=") + (half ? "B" : "A") + "_Leaflet_Elements\n";
    for (int ring = 0; ring < 2; ++ring)
      for (int i = 4 * half; i < 4 * half + 4; ++i) {
        const int a = 8 * ring + i + 1, b = 8 * ring + (i + 1) % 8 + 1;
        text += std::to_string(8 * ring + i + 1) + "," + std::to_string(a) + "," +
                std::to_string(a + 8) + "," + std::to_string(b + 8) + "," + std::to_string(b) +
                "\n";
      }
  }
  text +=
      "*ELEMENT, TYPE=T3D2, ELSET=Chordae\n50,100,101\n51,101,102\n52,102,17\n53,102,18\n"
      "*NSET, NSET=Annulus, GENERATE\n1,8,1\n"
      "*DISTRIBUTION, NAME=Axes, LOCATION=ELEMENT, TABLE=T\n,1.,0.,0.,0.,1.,0.\n"
      "1,0.,1.,0.,0.,0.,1.\n"
      "*ORIENTATION, NAME=Ori, SYSTEM=RECTANGULAR\nAxes\n3, 0.\n"
      "*SHELL SECTION, ELSET=A_Leaflet_Elements, ORIENTATION=Ori, MATERIAL=VUANISO_ISO_A\n.65,5\n"
      "*SHELL SECTION, ELSET=B_Leaflet_Elements, MATERIAL=VUANISO_ISO_B\n.5,5\n"
      "*SOLID SECTION, ELSET=Chordae, MATERIAL=Cord\n0.3,\n*END PART\n"
      "*SURFACE, TYPE=ELEMENT, NAME=Face, MAXRATIO=0.05\n"
      "Instance.A_Leaflet_Elements, SPOS\nInstance.B_Leaflet_Elements, SPOS\n"
      "*MATERIAL, NAME=Cord\n*DENSITY\n1e-9\n*HYPERELASTIC, OGDEN, N=2\n10., 50., 5., 20., 0., 0.\n"
      "*MATERIAL, NAME=VUANISO_ISO_A\n*DENSITY\n1e-9,\n"
      "*ANISOTROPIC HYPERELASTIC, USER, FORMULATION=INVARIANT, PROPERTIES=4\n"
      "0.001, 20., 0.000124, 4.5\n"
      "*MATERIAL, NAME=VUANISO_ISO_B\n*DENSITY\n1e-9,\n"
      "*ANISOTROPIC HYPERELASTIC, USER, FORMULATION=INVARIANT, PROPERTIES=4\n"
      "0.002, 20., 0.000188, 14.8\n"
      "*STEP, NAME=One\n*BOUNDARY\nAnnulus,3,3,0.5\nInstance.1,1,1,-0.25\nInstance.100,1,3\n"
      "*DSLOAD\nFace, P, 0.003\n" +
      more + "*END STEP\n";
  return text;
}

TEST(AbaqusValve, HasLeafletsAnnulusAndChordaeOfTheInput) {
  const Expected<Valve> valve = read_abaqus_valve(cone(), {"cone", {"by hand"}});
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
  const Expected<Valve> valve = read_abaqus_valve(cone(), {});
  ASSERT_TRUE(valve);
  const Vec3 a = valve->rest_mm.row(8), b = valve->rest_mm.row(17);
  EXPECT_NEAR(valve->tissue.thickness_mm, 0.05 * (a - b).norm(), 1e-7);  // decimals of the file
}

TEST(AbaqusValve, WithoutARatioTouchesAtTheThicknessOfItsThinnestLeaflet) {
  std::string text = cone();
  const std::string ratio = ", MAXRATIO=0.05";
  text.erase(text.find(ratio), ratio.size());
  const Expected<Valve> valve = read_abaqus_valve(text, {"cone", {"by hand"}});
  ASSERT_TRUE(valve);
  EXPECT_DOUBLE_EQ(valve->tissue.thickness_mm, 0.5);
}

TEST(AbaqusValve, ReadsBackFromItsFileBitForBit) {
  const Expected<Valve> valve = read_abaqus_valve(cone(), {});
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
    const Expected<Valve> valve = read_abaqus_valve(cone(more), {});
    ASSERT_FALSE(valve) << more;
    EXPECT_EQ(valve.errors().front().code, ErrorCode::Unsupported) << more;
  }
  const Expected<AbaqusModel> brick = read_abaqus("*ELEMENT, TYPE=C3D8\n1,1,2,3,4,5,6,7,8\n");
  ASSERT_FALSE(brick);
  EXPECT_EQ(brick.errors().front().code, ErrorCode::Unsupported);
}

TEST(AbaqusValve, SaysWhatIsMissing) {
  EXPECT_EQ(read_abaqus_valve("", {}).errors().front().path, "/pressure");
  std::string no_ring = cone();
  no_ring.replace(no_ring.find("Annulus,3,3,0.5\n"), 16, "");
  EXPECT_EQ(read_abaqus_valve(no_ring, {}).errors().front().path, "/boundary");
}

}  // namespace
}  // namespace coapt
