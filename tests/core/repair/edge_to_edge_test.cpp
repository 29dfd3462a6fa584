#include "core/repair/edge_to_edge.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/closure/closure.h"
#include "core/metrics/measure.h"
#include "core/presets/human_presets.h"
#include "core/presets/presets.h"
#include "core/repair/apply_plan.h"
#include "core/valve/annulus_frame.h"
#include "core/valve/refine.h"
#include "core/valve/validate.h"
#include "tests/scenes/small_preset.h"

namespace coapt {
namespace {

Valve repaired(const Valve& valve, const EdgeToEdge& step) {
  const Expected<Valve> made = apply_plan(valve, {{step}});
  return made ? *made : Valve{};
}

double distance_mm(const Valve& valve, const Tie& tie, const Points& points) {
  return (position(tie.anterior, valve.faces, points) -
          position(tie.posterior, valve.faces, points))
      .norm();
}

TEST(EdgeToEdge, AStitchOfFourMillimetresIsThreeTiesTwoMillimetresApart) {
  const Valve& valve = small_preset("human-normal");
  const Valve stitched = repaired(valve, {EdgeDevice::Stitch, 0.5, 4.0});
  ASSERT_EQ(stitched.ties.size(), 3u);
  EXPECT_EQ(stitched.ties[0].id, "edge-to-edge-1-1");
  for (const auto part : {&Tie::anterior, &Tie::posterior})
    for (std::size_t i = 1; i < 3; ++i) {
      const Vec3 a = position(stitched.ties[i - 1].*part, stitched.faces, stitched.rest_mm),
                 b = position(stitched.ties[i].*part, stitched.faces, stitched.rest_mm);
      EXPECT_NEAR((a - b).norm(), 2.0, 0.2);
    }
  EXPECT_EQ(stitched.ties[1].rest_length_mm, valve.tissue.thickness_mm);
  EXPECT_EQ(stitched.annulus_mm, valve.annulus_mm);
}

TEST(EdgeToEdge, AClosedCommissureIsStitchedFromWhereTheLeafletsMeet) {
  const Valve& valve = small_preset("human-normal");
  const LeafletCoordinates coordinates = leaflet_coordinates(valve);
  for (const Side side : {Side::Anterolateral, Side::Posteromedial}) {
    const bool first = side == Side::Anterolateral;
    const Valve closed = repaired(valve, commissural_closure(valve, coordinates, side, 8.0));
    ASSERT_EQ(closed.ties.size(), 5u);
    const Tie& outermost = first ? closed.ties.front() : closed.ties.back();
    const Vec3 meets =
        rest_position_mm(valve, coordinates, {Leaflet::Anterior, first ? 0.0 : 1.0, 1.0});
    // Less than an edge of this mesh.
    EXPECT_LT((position(outermost.anterior, closed.faces, closed.rest_mm) - meets).norm(), 3.0);
    EXPECT_LT((position(outermost.posterior, closed.faces, closed.rest_mm) - meets).norm(), 3.0);
  }
}

TEST(EdgeToEdge, SuturesOfACleftJoinItsTwoEdgesFromTheRootOn) {
  HumanValve human = human_normal();
  human.dimensions.cleft_depth_mm = 8.0;
  const Valve cleft = *make_human_valve(human);
  const EdgeToEdge step{EdgeDevice::CleftSuture, 1.0 / 3.0, 10.0};
  const Valve sutured = repaired(cleft, step);
  ASSERT_EQ(sutured.ties.size(), 5u);
  double before = 0.0;
  for (const Tie& tie : sutured.ties) {
    for (const Insertion& end : {tie.anterior, tie.posterior}) {
      const Segment segment = sutured.segments[static_cast<std::size_t>(end.face)];
      EXPECT_TRUE(segment == Segment::P1 || segment == Segment::P2) << to_string(segment);
    }
    const double apart = distance_mm(sutured, tie, sutured.rest_mm);
    EXPECT_GT(apart, before) << "the cleft widens towards its mouth";
    before = apart;
  }
  const Valve both = repaired(sutured, {EdgeDevice::CleftSuture, 2.0 / 3.0, 10.0});
  EXPECT_LT(measure(both, close_valve(both)).leak.area_mm2,
            0.3 * measure(cleft, close_valve(cleft)).leak.area_mm2);
}

TEST(EdgeToEdge, AClipHasRowsOfTiesOverItsGraspAndDrawsTheAnnulusIn) {
  const Valve& valve = small_preset("human-normal");
  const Valve clipped =
      repaired(valve, {.device = EdgeDevice::Clip, .width_mm = 4.0, .grasp_mm = 6.0, .rows = 3});
  ASSERT_EQ(clipped.ties.size(), 9u);
  for (const std::size_t row : {1u, 2u}) {
    const Vec3 edge = position(clipped.ties[1].anterior, clipped.faces, clipped.rest_mm),
               above = position(clipped.ties[1 + 3 * row].anterior, clipped.faces, clipped.rest_mm);
    EXPECT_NEAR((edge - above).norm(), 3.0 * static_cast<double>(row), 0.3);
  }
  EXPECT_NEAR(ap_diameter_mm(clipped), 0.89 * ap_diameter_mm(valve), 0.01);
  EXPECT_NEAR(transverse_diameter_mm(clipped), transverse_diameter_mm(valve), 1e-9);
}

TEST(EdgeToEdge, TiesAtVerticesHaveWeightsOfOneAtMost) {
  for (const char* name : {"porcine-2", "porcine-5"}) {
    const Expected<Valve> valve = make_preset(name);
    ASSERT_TRUE(valve);
    EXPECT_TRUE(apply_plan(*valve, {{EdgeToEdge{.device = EdgeDevice::Clip}}})) << name;
  }
}

TEST(EdgeToEdge, TheLargestOfSeveralClipsDrawsTheAnnulusInUnlessARingHoldsIt) {
  const Valve& valve = small_preset("human-functional-mr");
  EdgeToEdge weak{.device = EdgeDevice::Clip, .along = 0.4, .annulus_drawn_in_percent = 5.0};
  EdgeToEdge strong{.device = EdgeDevice::Clip, .along = 0.6, .annulus_drawn_in_percent = 13.0};
  const Valve both = *apply_plan(valve, {{weak, strong}});
  EXPECT_NEAR(ap_diameter_mm(both), 0.87 * ap_diameter_mm(valve), 0.01);
  const Annuloplasty ring{CatalogueRing{"generic-classic", 30.0}};
  EXPECT_EQ(apply_plan(valve, {{strong, ring}})->annulus_mm,
            apply_plan(valve, {{ring}})->annulus_mm);
  weak.annulus_drawn_in_percent = 0.0;
  EXPECT_EQ(apply_plan(valve, {{weak}})->annulus_mm, valve.annulus_mm);
}

TEST(EdgeToEdge, HoldsTheEdgesTogetherInTheClosedValve) {
  for (const char* name : {"human-p2-prolapse", "fibroelastic-flail", "secondary-mr"}) {
    const Valve& valve = small_preset(name);
    const ClosureResult before = close_valve(valve);
    for (const EdgeDevice device : {EdgeDevice::Stitch, EdgeDevice::Clip}) {
      const Valve held = repaired(valve, {device, 0.5, 6.0});
      const ClosureResult closed = close_valve(held);
      EXPECT_EQ(closed.status, ClosureStatus::Converged) << name;
      EXPECT_FALSE(closed.crossing) << name;
      ASSERT_EQ(closed.tie_tension_n.size(), held.ties.size());
      for (std::size_t i = 0; i < held.ties.size(); ++i) {
        // What the zones' means are apart by: slack, or its stretch at its tension.
        EXPECT_LT(distance_mm(held, held.ties[i], closed.closed_mm),
                  held.ties[i].rest_length_mm + closed.tie_tension_n[i] / 5.0 + 1.5)
            << name << ' ' << i;
        EXPECT_GE(closed.tie_tension_n[i], 0.0);
      }
      EXPECT_LT(measure(held, closed).leak.area_mm2, 0.8 * measure(valve, before).leak.area_mm2)
          << name;
    }
  }
}

TEST(EdgeToEdge, BothMethodsGiveTheSameClosedValve) {
  const Valve held = repaired(small_preset("human-p2-prolapse"), {EdgeDevice::Stitch, 0.5, 4.0});
  ClosureOptions thesis;
  thesis.method = Method::Thesis;
  const double fast = measure(held, close_valve(held)).leak.area_mm2;
  EXPECT_NEAR(measure(held, close_valve(held, thesis)).leak.area_mm2, fast, 3.0);
}

TEST(EdgeToEdge, IsTheSameInAnyOrderOfStepsAndOnAFinerMesh) {
  const Valve& valve = small_preset("human-normal");
  const EdgeToEdge lateral{EdgeDevice::Stitch, 0.3, 3.0}, medial{EdgeDevice::Clip, 0.7, 5.0};
  const Valve one = *apply_plan(valve, {{lateral, medial}}),
              other = *apply_plan(valve, {{medial, lateral}});
  EXPECT_EQ(one.ties, other.ties);
  const Valve fine = *refine(one);
  for (std::size_t i = 0; i < one.ties.size(); ++i)
    EXPECT_NEAR((position(one.ties[i].anterior, one.faces, one.rest_mm) -
                 position(fine.ties[i].anterior, fine.faces, fine.rest_mm))
                    .norm(),
                0.0, 1e-9);
}

TEST(EdgeToEdge, WhatIsOutOfRangeIsRefused) {
  const Valve& valve = small_preset("human-normal");
  const auto paths = [&](const EdgeToEdge& step) {
    const Expected<Valve> made = apply_plan(valve, {{step}});
    std::vector<std::string> all;
    if (!made)
      for (const Error& error : made.errors()) all.push_back(error.path);
    return all;
  };
  using Paths = std::vector<std::string>;
  EXPECT_EQ(paths({EdgeDevice::Stitch, 0.0, 1.0}), (Paths{"/steps/0/along", "/steps/0/width_mm"}));
  EXPECT_EQ(paths({EdgeDevice::Clip, std::nan(""), 4.0}), (Paths{"/steps/0/along"}));
  EXPECT_EQ(paths({.device = EdgeDevice::Clip,
                   .grasp_mm = 13.0,
                   .rows = 0,
                   .annulus_drawn_in_percent = std::nan("")}),
            (Paths{"/steps/0/grasp_mm", "/steps/0/rows", "/steps/0/annulus_drawn_in_percent"}));
}

TEST(Ties, ThatAreNoneAreNamed) {
  Valve valve = repaired(small_preset("human-normal"), {EdgeDevice::Stitch, 0.5, 4.0});
  valve.ties[0].anterior.face = -1;
  valve.ties[1].rest_length_mm = 0.0;
  valve.ties[2].id = valve.ties[1].id;
  std::vector<std::string> paths;
  for (const Error& error : validate(valve)) paths.push_back(error.path);
  EXPECT_EQ(paths, (std::vector<std::string>{"/ties/0/anterior/face", "/ties/1/rest_length_mm",
                                             "/ties/2/id"}));
}

}  // namespace
}  // namespace coapt
