// Landmarks that a person saw, on the cone: its sheets meet at 0 and 180 degrees, its front is at 90.
#include "io/mesh/given_landmarks.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "tests/io/mesh/cone_scene.h"

namespace coapt {
namespace {

double angle_deg(const Valve& valve, int annulus_index) {
  const Vec3 at = valve.rest_mm.row(valve.annulus[static_cast<std::size_t>(annulus_index)]);
  return std::atan2(at.y(), at.x()) * 180.0 / std::numbers::pi;
}

GivenLandmarks seen() {
  return {.anterolateral_commissure_mm = on_cone(165, 0),
          .posteromedial_commissure_mm = on_cone(20, 0),
          .saddle_peak_mm = on_cone(100, 0),
          .mid_posterior_mm = on_cone(-80, 0)};
}

void expect_seen(const Valve& valve) {
  const double station_deg = 360.0 / static_cast<double>(valve.annulus.size());
  const Landmarks& marks = valve.landmarks;
  EXPECT_NEAR(angle_deg(valve, marks.posteromedial_commissure), 20.0, station_deg);
  EXPECT_NEAR(angle_deg(valve, marks.anterolateral_commissure), 165.0, station_deg);
  EXPECT_NEAR(angle_deg(valve, marks.saddle_peak), 100.0, station_deg);
  EXPECT_NEAR(angle_deg(valve, marks.mid_posterior), -80.0, station_deg);
}

TEST(GivenLandmarks, AreWhereTheyWereSeen) {
  for (ImportSource source : {cone_source(), cone_source_with_gaps()}) {
    source.landmarks = seen();
    const Expected<ImportedValve> done = import_with_decisions(source, {});
    ASSERT_TRUE(done) << done.errors()[0].path << ' ' << done.errors()[0].message;
    expect_seen(done->valve);
    const ImportDecision& told = done->decisions[done->decisions.size() - 2];
    EXPECT_EQ(told.subject + ": " + told.value,
              "landmarks: anterolateral commissure, posteromedial commissure, saddle peak, "
              "mid-posterior as given");
  }
}

TEST(GivenLandmarks, GoWithTheFilesUnitsAndFrame) {
  ImportSource source = cone_source();
  source.landmarks = seen();
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(1.0, Vec3(1, 2, 3).normalized()).matrix();
  const auto moved = [&](const Vec3& p) { return Vec3(0.1 * (turn * p + Vec3(30, -50, 80))); };
  const auto move = [&](Points& points) {
    for (Eigen::Index i = 0; i < points.rows(); ++i)
      points.row(i) = moved(points.row(i)).transpose();
  };
  move(source.leaflets[0].vertices_mm);
  move(source.annulus_mm);
  for (ImportedChorda& chorda : source.chordae) {
    chorda.tip_mm = moved(chorda.tip_mm);
    chorda.insertion_mm = moved(chorda.insertion_mm);
  }
  for_each_given(source.landmarks, moved);
  const Expected<ImportedValve> done = import_with_decisions(source, {});
  ASSERT_TRUE(done) << done.errors()[0].path << ' ' << done.errors()[0].message;
  EXPECT_EQ(done->unit, LengthUnit::Centimetre);
  expect_seen(done->valve);
  // What was given comes back in the valve's frame.
  for (const auto vertex : done->input.leaflets[0].vertices_mm.rowwise())
    EXPECT_LT(std::hypot(vertex.x(), vertex.y()), kTop_mm + 0.01);
  EXPECT_EQ(done->input.chordae.size(), source.chordae.size());
}

TEST(GivenLandmarks, FarFromTheAnnulusAreRefused) {
  ImportSource source = cone_source();
  source.landmarks.saddle_peak_mm = Vec3(0, kTop_mm + 12.0, 0);
  source.landmarks.mid_posterior_mm = Vec3(0, std::nan(""), 0);
  const Expected<ImportedValve> done = import_with_decisions(source, {});
  ASSERT_FALSE(done);
  ASSERT_EQ(done.errors().size(), 2U);
  EXPECT_EQ(done.errors()[0].path, "/landmarks/saddle_peak_mm");
  EXPECT_TRUE(done.errors()[0].message.starts_with("lies 12 mm")) << done.errors()[0].message;
  EXPECT_EQ(done.errors()[1].path, "/landmarks/mid_posterior_mm");
}

ImportDecision told_of(const GivenLandmarks& landmarks, const std::string& about) {
  ImportSource source = cone_source_with_gaps();
  source.landmarks = landmarks;
  const Expected<ImportedValve> done = import_with_decisions(source, {});
  if (!done) return {"refused", done.errors()[0].path, done.errors()[0].message, true};
  for (const ImportDecision& told : done->decisions)
    if (told.subject == "landmarks" && told.value.find(about) != std::string::npos) return told;
  return {};
}

TEST(GivenLandmarks, ThatAreDoubtfulAreLookedAt) {
  GivenLandmarks near = {.anterolateral_commissure_mm = on_cone(178, 0),
                         .posteromedial_commissure_mm = on_cone(1, 0),
                         .saddle_peak_mm = on_cone(92, 0)};
  EXPECT_FALSE(told_of(near, "as given").look);
  EXPECT_FALSE(told_of(near, "commissures").look);
  near.anterolateral_commissure_mm = on_cone(150, 0);
  const ImportDecision off = told_of(near, "commissures");
  EXPECT_TRUE(off.look);
  EXPECT_NE(off.reason.find("10 mm along the annulus from where the sheets meet"),
            std::string::npos)
      << off.reason;
  const ImportDecision moved =
      told_of({.saddle_peak_mm = on_cone(90, 0.4)}, "saddle peak as given");
  EXPECT_TRUE(moved.look);
  EXPECT_NE(moved.reason.find("the saddle peak was moved by"), std::string::npos) << moved.reason;
  const ImportDecision alone =
      told_of({.posteromedial_commissure_mm = on_cone(0, 0)}, "posteromedial commissure");
  EXPECT_EQ(alone.value, "posteromedial commissure not used");
  EXPECT_TRUE(alone.look);
}

TEST(GivenLandmarks, CommissuresWhoseSidesAreExchangedAreRefused) {
  const ImportDecision swapped = told_of({.anterolateral_commissure_mm = on_cone(0, 0),
                                          .posteromedial_commissure_mm = on_cone(180, 0)},
                                         "");
  EXPECT_EQ(swapped.value, "/landmarks/anterolateral_commissure_mm");
  EXPECT_TRUE(swapped.reason.starts_with("lies on the posteromedial side")) << swapped.reason;
}

TEST(GivenLandmarks, ASaddlePeakBehindIsRefused) {
  const ImportDecision behind = told_of({.saddle_peak_mm = on_cone(-90, 0)}, "");
  EXPECT_EQ(behind.subject, "refused");
  EXPECT_EQ(behind.value, "/landmarks/saddle_peak_mm");
  EXPECT_NE(behind.reason.find("from the anterior annulus between the commissures"),
            std::string::npos)
      << behind.reason;
}

TEST(GivenLandmarks, CommissuresThatLeaveALeafletNoRoomAreRefused) {
  ImportSource source = cone_source();
  source.landmarks.posteromedial_commissure_mm = on_cone(80, 0);
  source.landmarks.anterolateral_commissure_mm = on_cone(100, 0);
  const Expected<ImportedValve> done = import_with_decisions(source, {});
  ASSERT_FALSE(done);
  EXPECT_EQ(done.errors()[0].path, "/landmarks/anterolateral_commissure_mm");
}

}  // namespace
}  // namespace coapt
