#include "io/json/scene_json.h"

#include <gtest/gtest.h>

#include <limits>

#include "core/metrics/measure.h"
#include "core/repair/apply_plan.h"
#include "io/json/plan_json.h"
#include "tests/scenes/small_preset.h"

namespace coapt {
namespace {

Vec3 row(const Json& flat, std::size_t i) {
  return {flat.at(3 * i).get<double>(), flat.at(3 * i + 1).get<double>(),
          flat.at(3 * i + 2).get<double>()};
}

Vec3 vector(const Json& json) { return row(json, 0); }

struct Closed {
  Valve valve;
  RepairPlan plan;
  ClosureResult closure;
  ValveMeasure measured;
  Json scene;
};

Closed closed(const std::string& preset, const RepairPlan& plan, int frames) {
  Closed result{*apply_plan(small_preset(preset), plan), plan, {}, {}, {}};
  result.closure = close_valve(result.valve, {.motion = frames > 0});
  result.measured = measure(result.valve, result.closure);
  result.scene =
      scene_to_json({result.valve, result.closure, result.measured.leak, result.plan, frames});
  return result;
}

TEST(SceneJson, HasEachVertexFaceAndHeadOfTheValve) {
  const auto [valve, plan, closure, measured, scene] = closed("human-functional-mr", {}, 0);
  const auto vertices = static_cast<std::size_t>(valve.rest_mm.rows());
  EXPECT_EQ(scene["rest_mm"].size(), 3 * vertices);
  EXPECT_EQ(scene["closed_mm"].size(), 3 * vertices);
  EXPECT_EQ(scene["faces"].size(), static_cast<std::size_t>(valve.faces.size()));
  EXPECT_EQ(scene["segments"].size(), static_cast<std::size_t>(valve.faces.rows()));
  EXPECT_EQ(scene["strain"]["radial"].size(), static_cast<std::size_t>(valve.faces.rows()));
  EXPECT_EQ(scene["leaflet_coordinates"]["around"].size(), vertices);
  EXPECT_EQ(scene["heads"].size(), valve.heads.size());
  EXPECT_TRUE(scene["motion_mm"].empty());
  for (std::size_t i = 0; i < vertices; ++i)
    EXPECT_LT(
        (row(scene["closed_mm"], i) - Vec3(closure.closed_mm.row(static_cast<Eigen::Index>(i))))
            .cwiseAbs()
            .maxCoeff(),
        0.0006);
}

TEST(SceneJson, ChordaeEndWhereTheyInsertAndBranchWhereTheyBranch) {
  const auto [valve, plan, closure, measured, scene] = closed("human-normal", {}, 0);
  ASSERT_EQ(scene["chordae"].size(), valve.chordae.size());
  for (std::size_t c = 0; c < valve.chordae.size(); ++c)
    for (std::size_t s = 0; s < valve.chordae[c].segments.size(); ++s) {
      const ChordaSegment& segment = valve.chordae[c].segments[s];
      const Json& json = scene["chordae"][c]["segments"][s];
      EXPECT_EQ(json.contains("face"), segment.inserts);
      if (!segment.inserts) continue;
      const Vec3 end = position(segment.insertion, valve.faces, closure.closed_mm);
      EXPECT_LT((vector(json["end_mm"]) - end).norm(), 0.001);
    }
}

TEST(SceneJson, ItsLeakAndSectionsAreThoseOfTheMeasures) {
  const auto [valve, plan, closure, measured, scene] = closed("human-functional-mr", {}, 0);
  ASSERT_EQ(scene["leak"].size(), measured.leak.openings.size());
  ASSERT_FALSE(scene["leak"].empty());
  for (std::size_t i = 0; i < scene["leak"].size(); ++i) {
    const Json& json = scene["leak"][i];
    const LeakOpening& opening = measured.leak.openings[i];
    EXPECT_NEAR(json["area_mm2"].get<double>(), opening.area_mm2, 0.001);
    EXPECT_EQ(json["points_mm"].size(), static_cast<std::size_t>(opening.surface.points_mm.size()));
    EXPECT_EQ(json["faces"].size(), static_cast<std::size_t>(opening.surface.faces.size()));
    EXPECT_EQ(json["outline"], Json(opening.surface.outline));
  }
  ASSERT_EQ(scene["sections"].size(), 37u);
  int same = 0;
  for (const CoaptationSection& section : measured.coaptation.sections)
    for (const Json& json : scene["sections"])
      if (std::abs(json["along"].get<double>() - section.along) < 1e-9) {
        EXPECT_NEAR(json["height_mm"].get<double>(), section.height_mm, 0.11);
        EXPECT_NEAR(json["distance_mm"].get<double>(), section.distance_mm, 0.0006);
        ++same;
      }
  EXPECT_EQ(same, 9);
}

TEST(SceneJson, TheMotionBeginsOpenAndEndsClosedWithAsManyFramesAsAskedForAtMost) {
  const auto [valve, plan, closure, measured, scene] = closed("human-normal", {}, 5);
  ASSERT_EQ(scene["motion_mm"].size(), 5u);
  const auto vertices = static_cast<std::size_t>(valve.rest_mm.rows());
  for (std::size_t i = 0; i < vertices; ++i) {
    EXPECT_EQ(row(scene["motion_mm"].front(), i), row(scene["rest_mm"], i));
    EXPECT_EQ(row(scene["motion_mm"].back(), i), row(scene["closed_mm"], i));
  }
  const auto states = closure.motion_mm.size();
  const auto all = scene_to_json({valve, closure, measured.leak, plan, 1000})["motion_mm"];
  EXPECT_EQ(all.size(), states);
}

TEST(SceneJson, ASutureRunsFromTheMeanTipToItsAnchor) {
  PapillaryApproximation suture;
  suture.side = Side::Posteromedial;
  suture.anchor = Anchor::SaddlePeak;
  suture.suture_length_mm = 30.0;
  const auto [valve, plan, closure, measured, scene] = closed("human-functional-mr", {{suture}}, 0);
  ASSERT_EQ(scene["sutures"].size(), 1u);
  const Json& json = scene["sutures"][0];
  EXPECT_EQ(json["side"], "posteromedial");
  EXPECT_NEAR((vector(json["tip_mm"]) - vector(json["anchor_mm"])).norm(), 30.0, 0.01);
}

TEST(SceneJson, TiesAndSeamsArePointsOfTheLeaflets) {
  const RepairPlan repair = {{EdgeToEdge{EdgeDevice::Stitch, 0.3, 4.0}, LeafletResection{}}};
  const auto [valve, plan, closure, measured, scene] = closed("human-p2-prolapse", repair, 3);
  ASSERT_EQ(scene["ties"].size(), 3u);
  EXPECT_EQ(scene["ties"][0]["anterior"]["face"], valve.ties[0].anterior.face);
  EXPECT_GE(scene["ties"][0]["tension_n"], 0.0);
  ASSERT_EQ(scene["seams"].size(), 1u);
  EXPECT_EQ(scene["seams"][0].back()["weights"].size(), 3u);
  // Knots of ties are no nodes of the motion.
  const auto without = closed("human-p2-prolapse", {{LeafletResection{}}}, 3);
  EXPECT_EQ(scene["motion_mm"][0].size(), without.scene["motion_mm"][0].size());
}

TEST(SceneJson, OfAClosureThatFlewApartOnlyTheOpenValveIsThere) {
  auto [valve, plan, closure, measured, scene] = closed("human-normal", {}, 0);
  closure.closed_mm(3, 1) = std::numeric_limits<double>::quiet_NaN();
  closure.tension_n[0][0] = std::numeric_limits<double>::infinity();
  scene = scene_to_json({valve, closure, measure(valve, closure).leak, plan, 0});
  EXPECT_TRUE(scene["closed_mm"].is_null());
  EXPECT_TRUE(scene["strain"].is_null());
  EXPECT_TRUE(scene["leak"].empty());
  EXPECT_TRUE(scene["sections"].empty());
  EXPECT_TRUE(scene["chordae"][0]["segments"][0]["tension_n"].is_null());
  EXPECT_FALSE(scene["rest_mm"].empty());
}

}  // namespace
}  // namespace coapt
