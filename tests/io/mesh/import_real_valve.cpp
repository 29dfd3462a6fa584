// The import of the anatomical valve that examples/valves is built from.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <fstream>
#include <iterator>
#include <numbers>

#include "core/closure/closure.h"
#include "core/metrics/measure.h"
#include "io/mesh/import_readers.h"
#include "io/mesh/import_valve.h"

namespace coapt {
namespace {

std::string content(const std::string& name) {
  std::ifstream file(std::string(COAPT_SOURCE_DIR "/examples/valves/source/bodyparts3d/") + name,
                     std::ios::binary);
  EXPECT_TRUE(file) << name;
  return {std::istreambuf_iterator<char>(file), {}};
}

ImportSource real_source() {
  ImportSource source;
  source.name = "bodyparts3d";
  for (const char* sheet : {"anterior_leaflet_sheet.obj", "posterior_leaflet_sheet.obj"}) {
    source.leaflets.push_back(*read_mesh(content(sheet), "obj"));
  }
  source.annulus_mm = *read_points_csv(content("annulus_centerline.csv"));
  source.chordae = *read_chordae(content("chordae.csv"), "csv");
  return source;
}

TEST(ImportRealValve, LandmarksAreWhereAnAnatomistPutsThem) {
  const auto valve = import_valve(real_source(), {});
  ASSERT_TRUE(valve);
  EXPECT_EQ(valve->faces.rows(), 720);
  EXPECT_EQ(valve->chordae.size(), 24U);
  EXPECT_EQ(valve->heads.size(), 4U);
  // Degrees from the anterior direction; about -50 and +45 in the source's notes.
  const auto degrees = [&](int vertex) {
    return std::atan2(valve->rest_mm(vertex, 0), valve->rest_mm(vertex, 1)) * 180.0 /
           std::numbers::pi;
  };
  EXPECT_NEAR(degrees(valve->landmarks.anterolateral_commissure), -50.0, 8.0);
  EXPECT_NEAR(degrees(valve->landmarks.posteromedial_commissure), 45.0, 8.0);
  EXPECT_NEAR(degrees(valve->landmarks.saddle_peak), 0.0, 20.0);
}

TEST(ImportRealValve, RotationAndTranslationOfTheInputChangeNothing) {
  const ImportSource source = real_source();
  ImportSource moved = source;
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(2.1, Vec3(0.3, -0.8, 0.5).normalized()).toRotationMatrix();
  const Eigen::RowVector3d shift(120.0, -340.0, 77.0);
  const auto move = [&](Points& points) { points = (points * turn.transpose()).rowwise() + shift; };
  for (TriangleMesh& mesh : moved.leaflets) move(mesh.vertices_mm);
  move(moved.annulus_mm);
  for (ImportedChorda& chorda : moved.chordae) {
    chorda.insertion_mm = turn * chorda.insertion_mm + shift.transpose();
    chorda.tip_mm = turn * chorda.tip_mm + shift.transpose();
  }
  moved.annulus_mm = moved.annulus_mm.colwise().reverse().eval();
  const auto there = import_valve(source, {}), here = import_valve(moved, {});
  ASSERT_TRUE(there);
  ASSERT_TRUE(here);
  EXPECT_EQ(there->faces, here->faces);
  EXPECT_EQ(there->segments, here->segments);
  EXPECT_LT((there->rest_mm - here->rest_mm).cwiseAbs().maxCoeff(), 1e-6);
  ASSERT_EQ(there->chordae.size(), here->chordae.size());
  for (std::size_t c = 0; c < there->chordae.size(); ++c) {
    EXPECT_EQ(there->chordae[c].id, here->chordae[c].id);
    EXPECT_NEAR(there->chordae[c].segments[0].rest_length_mm,
                here->chordae[c].segments[0].rest_length_mm, 1e-6);
  }
}

TEST(ImportRealValve, ItsAnnulusIsFoundWithoutItsTrace) {
  ImportSource source = real_source();
  const Points traced_mm = source.annulus_mm;
  source.annulus_mm.resize(0, 3);
  const auto valve = import_valve(source, {});
  ASSERT_TRUE(valve) << valve.errors()[0].message;
  double square_mm2 = 0.0;
  for (const auto& p : valve->annulus_mm.rowwise()) {
    const Vec3 there = valve->patient->axes * Vec3(p.transpose()) + valve->patient->origin_mm;
    double best = 1e300;
    for (const auto& q : traced_mm.rowwise())
      best = std::min(best, (Vec3(q.transpose()) - there).squaredNorm());
    square_mm2 += best / static_cast<double>(valve->annulus_mm.rows());
  }
  EXPECT_LT(std::sqrt(square_mm2), 1.5);
  EXPECT_LT(measure(*valve, close_valve(*valve)).leak.area_mm2, 5.0);
}

TEST(ImportRealValve, ItClosesWithoutCrossingAndLeaksLittle) {
  const auto valve = import_valve(real_source(), {});
  ASSERT_TRUE(valve);
  const ClosureResult closure = close_valve(*valve);
  EXPECT_EQ(closure.status, ClosureStatus::Converged);
  EXPECT_FALSE(closure.crossing);
  EXPECT_LT(measure(*valve, closure).leak.area_mm2, 5.0);  // 4.2; 2.7 on 2,596 triangles
}

}  // namespace
}  // namespace coapt
