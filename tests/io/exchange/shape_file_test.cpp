#include "io/exchange/shape_file.h"

#include <gtest/gtest.h>

#include "core/closed/closed_shape.h"
#include "io/exchange/formats.h"
#include "io/json/scene_json.h"
#include "tests/io/exchange/still_valve.h"

namespace coapt {
namespace {

/// Two triangles of different leaflets and a vertex that no face has.
constexpr const char* kTwoLabels =
    "# vtk DataFile Version 4.2\nother program\nASCII\nDATASET POLYDATA\nPOINTS 5 double\n0 0 0\n1 "
    "0 0\n"
    "9 9 9\n1 1 0\n0 1 0\nPOLYGONS 2 8\n3 0 1 3\n3 0 3 4\nCELL_DATA 2\nSCALARS leaflet int 1\n"
    "LOOKUP_TABLE default\n4\n2\nSCALARS other double 1\nLOOKUP_TABLE default\n0.5\n0.5\n";

TEST(ShapeFile, TakesLeafletsFromTheArrayThatNumbersThem) {
  const Expected<LeafletMesh> mesh = read_shape(kTwoLabels, "vtk");
  ASSERT_TRUE(mesh);
  EXPECT_EQ(mesh->vertices_mm.rows(), 4);
  EXPECT_EQ(mesh->names, (std::vector<std::string>{"leaflet 2", "leaflet 4"}));
  EXPECT_EQ(mesh->leaflets, (std::vector<int>{1, 0}));
  const Expected<LeafletMesh> other = read_shape(kTwoLabels, "vtk", {"other", ""});
  ASSERT_TRUE(other);
  EXPECT_EQ(other->names, (std::vector<std::string>{"other 0.5"}));
}

TEST(ShapeFile, IsTurnedToLpsWhereItSaysRas) {
  std::string ras = kTwoLabels;
  ras.replace(ras.find("other program"), 13, "3D Slicer output. SPACE=RAS");
  const Expected<LeafletMesh> lps = read_shape(kTwoLabels, "vtk"), turned = read_shape(ras, "vtk");
  ASSERT_TRUE(lps && turned);
  EXPECT_EQ(turned->vertices_mm.leftCols(2), -lps->vertices_mm.leftCols(2));
  EXPECT_EQ(turned->vertices_mm.col(2), lps->vertices_mm.col(2));
}

TEST(ShapeFile, NamesTheArraysThatThereAreIfOneIsMissing) {
  const Expected<LeafletMesh> mesh = read_shape(kTwoLabels, "vtk", {"parts", ""});
  ASSERT_FALSE(mesh);
  EXPECT_EQ(mesh.errors()[0].code, ErrorCode::BadReference);
  EXPECT_NE(mesh.errors()[0].message.find("available: leaflet, other"), std::string::npos);
}

TEST(ShapeFile, OfAnotherFormatIsUnsupported) {
  const Expected<LeafletMesh> mesh = read_shape("", "step");
  ASSERT_FALSE(mesh);
  EXPECT_EQ(mesh.errors()[0].code, ErrorCode::Unsupported);
}

TEST(ShapeFile, ReadsBackWhatIsExportedWithItsLeaflets) {
  const ClosedValve closed = still_valve();
  const LeafletMesh shape = shape_of(closed);
  for (const char* format : {"vtk", "ply", "obj"}) {
    const Expected<std::string> bytes =
        write_valve_file(closed, *format_of_path(std::string("a.") + format), {});
    ASSERT_TRUE(bytes);
    const Expected<LeafletMesh> again = read_shape(*bytes, format);
    ASSERT_TRUE(again) << format;
    EXPECT_TRUE(have_same_nodes(shape, *again)) << format;
    EXPECT_LT((again->vertices_mm - shape.vertices_mm).rowwise().norm().maxCoeff(), 1e-5) << format;
    if (std::string(format) == "vtk") {
      EXPECT_EQ(again->names, shape.names);
      EXPECT_EQ(again->leaflets, shape.leaflets);
    }
  }
}

TEST(ShapeFile, ReadsTheClosedStateOfAScene) {
  const ClosedValve closed = still_valve();
  const std::string scene =
      scene_to_json({closed.valve, closed.closure, {}, closed.plan, 0}).dump();
  EXPECT_TRUE(is_scene_text(scene));
  EXPECT_FALSE(is_scene_text("{\"schema\": \"coapt.valve/1\"}"));
  EXPECT_FALSE(is_scene_text("nothing"));
  const Expected<LeafletMesh> mesh = read_scene_shape(scene);
  ASSERT_TRUE(mesh);
  EXPECT_TRUE(have_same_nodes(*mesh, shape_of(closed)));
}

TEST(ShapeFile, RefusesMoreThanItsLimits) {
  const auto reads = [](std::string_view bytes, const char* format, const MeshLimits& limits) {
    return bool(read_shape(bytes, format, {.limits = limits}));
  };
  EXPECT_TRUE(reads(kTwoLabels, "vtk", {5, 2}));
  EXPECT_FALSE(reads(kTwoLabels, "vtk", {4, 2})) << "the loose vertex counts, too";
  EXPECT_FALSE(reads(kTwoLabels, "vtk", {5, 1}));
  const std::string scene =
      "{\"schema\": \"coapt.scene/1\", \"closed_mm\": [0, 0, 0, 1, 0, 0, 0, 1, 0], \"faces\": [0, "
      "1, 2]}";
  EXPECT_TRUE(read_scene_shape(scene, {3, 1}));
  EXPECT_FALSE(read_scene_shape(scene, {1, 1})) << "16 values, and 12 are accepted";
}

TEST(ShapeFile, RefusesScenesWithoutAShape) {
  const auto error_of = [](const std::string& text) {
    const Expected<LeafletMesh> mesh = read_scene_shape(text);
    EXPECT_FALSE(mesh) << text;
    return mesh ? Error{} : mesh.errors()[0];
  };
  EXPECT_EQ(error_of("{").code, ErrorCode::InvalidJson);
  EXPECT_EQ(error_of("{\"schema\": 3}").path, "/schema");
  EXPECT_EQ(
      error_of("{\"schema\": \"coapt.scene/1\", \"closed_mm\": null, \"faces\": [0, 1, 2]}").path,
      "/closed_mm");
  EXPECT_EQ(
      error_of("{\"schema\": \"coapt.scene/1\", \"closed_mm\": [0, 0, 0], \"faces\": [0, 0, 1]}")
          .code,
      ErrorCode::BadReference);
}

}  // namespace
}  // namespace coapt
