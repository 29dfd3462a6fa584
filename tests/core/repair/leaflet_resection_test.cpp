#include "core/repair/leaflet_resection.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/closure/closure.h"
#include "core/metrics/measure.h"
#include "core/repair/apply_plan.h"
#include "core/repair/leaflet_cut.h"
#include "core/repair/sewn_shape.h"
#include "core/valve/refine.h"
#include "tests/scenes/small_preset.h"

namespace coapt {
namespace {

LeafletResection triangle(double width_mm, double height = 0.7) {
  return {.width_mm = width_mm, .height = height};
}
LeafletResection strip(double width_mm, bool sliding = true) {
  return {.shape = ResectionShape::Quadrangular, .width_mm = width_mm, .sliding = sliding};
}

Valve repaired(const Valve& valve, const RepairPlan& plan) {
  const Expected<Valve> made = apply_plan(valve, plan);
  EXPECT_TRUE(made) << made.errors()[0].path << ' ' << made.errors()[0].message;
  return made ? *made : Valve{};
}

double area_mm2(const Valve& valve) {
  double sum = 0.0;
  for (const auto& face : valve.faces.rowwise()) {
    const Vec3 a = valve.rest_mm.row(face[0]), b = valve.rest_mm.row(face[1]),
               c = valve.rest_mm.row(face[2]);
    sum += 0.5 * (b - a).cross(c - a).norm();
  }
  return sum;
}

double length_mm(const Points& loop) {
  double sum = 0.0;
  for (Index i = 0; i < loop.rows(); ++i)
    sum += (loop.row((i + 1) % loop.rows()) - loop.row(i)).norm();
  return sum;
}

double leak(const Valve& valve) {
  const ClosureResult closed = close_valve(valve);
  EXPECT_EQ(closed.status, ClosureStatus::Converged) << valve.name;
  EXPECT_FALSE(closed.crossing) << valve.name;
  return measure(valve, closed).leak.area_mm2;
}

TEST(SewnShape, AStripTwoLongWhoseMiddleEdgeHalvesIsOneAndAHalfLong) {
  // Three squares of 1 mm in a row, each cut by a diagonal; the left side is held.
  Points strip_mm(8, 3);
  for (int i = 0; i < 4; ++i) {
    strip_mm.row(2 * i) = Vec3(i, 0.0, 0.0);
    strip_mm.row(2 * i + 1) = Vec3(i, 1.0, 0.0);
  }
  std::vector<EdgeLength> edges;
  for (int i = 0; i < 4; ++i) edges.push_back({{2 * i, 2 * i + 1}, 1.0});
  for (int i = 0; i < 3; ++i) {
    const double length = i == 1 ? 0.5 : 1.0;
    for (const int side : {0, 1}) edges.push_back({{2 * i + side, 2 * i + 2 + side}, length});
    edges.push_back({{2 * i, 2 * i + 3}, std::hypot(1.0, length)});
  }
  const Points sewn =
      sewn_shape(strip_mm, edges, {false, false, true, true, true, true, true, true});
  EXPECT_NEAR(sewn(6, 0), 2.5, 0.01);
  EXPECT_NEAR(sewn(7, 0), 2.5, 0.01);
  EXPECT_NEAR(sewn(7, 1), 1.0, 0.01);
}

TEST(LeafletCut, ATriangleIsAsWideAsItsHeightLeaves) {
  const Valve& valve = small_preset("human-normal");
  const LeafletCut cut(triangle(10.0, 0.8), leaflet_coordinates(valve), valve);
  EXPECT_DOUBLE_EQ(cut.width_mm(1.0), 10.0);
  EXPECT_DOUBLE_EQ(cut.width_mm(0.6), 5.0);
  EXPECT_DOUBLE_EQ(cut.width_mm(0.2), 0.0);
  EXPECT_DOUBLE_EQ(cut.width_mm(0.0), 0.0);
}

TEST(LeafletCut, TissueAndPlaceAreInversesOutsideTheCut) {
  const Valve& valve = small_preset("human-normal");
  const LeafletCut cut(strip(12.0), leaflet_coordinates(valve), valve);
  for (const double along : {0.1, 0.3, 0.49, 0.5})
    EXPECT_NEAR(cut.place_of(cut.tissue_at(along, 0.5, -1), 0.5), along, 1e-12);
  for (const double along : {0.5, 0.7, 0.95})
    EXPECT_NEAR(cut.place_of(cut.tissue_at(along, 0.5, 1), 0.5), along, 1e-12);
  EXPECT_EQ(cut.place_of(0.51, 0.5), 0.5);
  EXPECT_TRUE(cut.takes(0.51, 0.5));
  EXPECT_NEAR(cut.tissue_at(0.5, 0.5, 1) - cut.tissue_at(0.5, 0.5, -1), cut.width_along(0.5),
              1e-12);
}

/// Of the faces of a much finer mesh whose middles are cut out.
double counted_mm2(const Valve& fine, const LeafletCoordinates& coordinates,
                   const LeafletResection& step) {
  const LeafletCut cut(step, coordinates, fine);
  Valve taken = fine;
  Index count = 0;
  for (int f = 0; f < fine.faces.rows(); ++f) {
    const LeafletPoint middle = leaflet_point(fine, coordinates, {f, {1.0 / 3, 1.0 / 3, 1.0 / 3}});
    if (middle.leaflet == step.leaflet && cut.takes(middle.along, middle.height))
      taken.faces.row(count++) = fine.faces.row(f);
  }
  taken.faces.conservativeResize(count, 3);
  return area_mm2(taken);
}

TEST(LeafletResection, TakesTheAreaThatIsCounted) {
  for (const char* name : {"human-normal", "fibroelastic-flail", "barlow"}) {
    const Valve &valve = shared_preset(name), fine = *refine(*refine(valve));
    const LeafletCoordinates coordinates = leaflet_coordinates(fine);
    for (const LeafletResection& step : {triangle(10.0), triangle(15.0, 0.9), strip(12.0)}) {
      const double counted = counted_mm2(fine, coordinates, step);
      EXPECT_NEAR(area_mm2(valve) - area_mm2(repaired(valve, {{step}})), counted, 0.07 * counted)
          << name << ' ' << to_string(step.shape) << ' ' << step.width_mm;
    }
  }
}

TEST(LeafletResection, OfAStripTakesItsWidthTimesTheHeight) {
  // A strip of 3 mm, so narrow that the leaflet is as high everywhere in it.
  for (const char* name : {"human-normal", "barlow"}) {
    const Valve& valve = small_preset(name);
    const LeafletCut cut(strip(3.0), leaflet_coordinates(valve), valve);
    EXPECT_NEAR(area_mm2(valve) - area_mm2(repaired(valve, {{strip(3.0)}})), 3.0 * cut.height_mm(),
                0.05 * 3.0 * cut.height_mm())
        << name;
  }
}

TEST(LeafletResection, LeavesTheOtherLeafletAndTheMeshAsTheyWere) {
  const Valve& valve = small_preset("human-normal");
  const LeafletCoordinates coordinates = leaflet_coordinates(valve);
  const Valve cut = repaired(valve, {{strip(12.0)}});
  EXPECT_EQ(cut.faces, valve.faces);
  EXPECT_EQ(cut.annulus_mm, valve.annulus_mm);
  for (Index v = 0; v < valve.rest_mm.rows(); ++v) {
    const LeafletPoint at = leaflet_point(coordinates.around[v], coordinates.height[v]);
    if (at.leaflet == Leaflet::Posterior) continue;
    EXPECT_EQ(cut.rest_mm.row(v), valve.rest_mm.row(v)) << v;
  }
  EXPECT_EQ(repaired(valve, {{triangle(10.0)}}).annulus_mm, valve.annulus_mm);
}

TEST(LeafletResection, PlicationShortensTheAnnulusByTheWidth) {
  const Valve& valve = small_preset("human-normal");
  const Valve plicated = repaired(valve, {{strip(10.0, false)}});
  EXPECT_NEAR(length_mm(valve.annulus_mm) - length_mm(plicated.annulus_mm), 10.0, 0.5);
}

TEST(LeafletResection, CutsTheChordaeOfWhatIsTakenAndKeepsTheOthers) {
  const Valve& valve = small_preset("human-p2-prolapse");
  const LeafletCoordinates coordinates = leaflet_coordinates(valve);
  const LeafletCut cut(triangle(12.0), coordinates, valve);
  const Valve after = repaired(valve, {{triangle(12.0)}});
  ASSERT_EQ(after.chordae.size(), valve.chordae.size());
  int cut_chordae = 0;
  for (std::size_t c = 0; c < valve.chordae.size(); ++c) {
    int kept = 0, taken = 0;
    for (const ChordaSegment& segment : valve.chordae[c].segments) {
      if (!segment.inserts) continue;
      const LeafletPoint at = leaflet_point(valve, coordinates, segment.insertion);
      const bool is_taken = at.leaflet == Leaflet::Posterior && cut.takes(at.along, at.height);
      ++(is_taken ? taken : kept);
    }
    cut_chordae += taken > 0;
    EXPECT_EQ(after.chordae[c].ruptured, valve.chordae[c].ruptured || kept == 0)
        << valve.chordae[c].id;
    if (kept == 0) continue;
    EXPECT_EQ(std::count_if(after.chordae[c].segments.begin(), after.chordae[c].segments.end(),
                            [](const ChordaSegment& s) { return s.inserts; }),
              kept)
        << valve.chordae[c].id;
  }
  EXPECT_GT(cut_chordae, 0);
}

TEST(LeafletResection, APlaceIsOneOnWhatIsLeft) {
  // A chorda half a strip's width beside the cut's edge ends where the mesh has that tissue.
  const Valve& valve = small_preset("human-normal");
  const LeafletCoordinates coordinates = leaflet_coordinates(valve);
  const LeafletCut cut(strip(12.0), coordinates, valve);
  const Valve after = repaired(valve, {{strip(12.0)}});
  for (std::size_t c = 0; c < valve.chordae.size(); ++c) {
    const Chorda &was = valve.chordae[c], &is = after.chordae[c];
    if (was.segments.size() != is.segments.size() || is.ruptured) continue;
    for (std::size_t s = 0; s < is.segments.size(); ++s) {
      if (!is.segments[s].inserts) continue;
      const LeafletPoint from = leaflet_point(valve, coordinates, was.segments[s].insertion),
                         to = leaflet_point(valve, coordinates, is.segments[s].insertion);
      if (from.leaflet != Leaflet::Posterior) continue;
      EXPECT_NEAR(to.along, cut.place_of(from.along, from.height), 1e-6) << was.id;
    }
  }
}

TEST(LeafletResection, ItsOrderAmongTheStepsDoesNotMatter) {
  const Valve& valve = small_preset("human-p2-prolapse");
  const Annuloplasty ring{OwnRing{2}};
  const Neochorda chorda{valve.heads[0].id, {Leaflet::Posterior, 0.4, 1.0}, 20.0};
  const LeafletResection small{.leaflet = Leaflet::Anterior, .width_mm = 5.0};
  const Valve one = repaired(valve, {{strip(10.0, false), ring, chorda, small}}),
              other = repaired(valve, {{small, chorda, ring, strip(10.0, false)}});
  EXPECT_EQ(one.rest_mm, other.rest_mm);
  EXPECT_EQ(one.annulus_mm, other.annulus_mm);
  EXPECT_EQ(one.chordae, other.chordae);
}

TEST(LeafletResection, WithARingTheFlailScallopCloses) {
  for (const char* name : {"human-p2-prolapse", "fibroelastic-flail"}) {
    const Valve& valve = small_preset(name);
    const double before = leak(valve);
    for (const LeafletResection& step : {triangle(12.0), strip(12.0), strip(12.0, false)}) {
      const double after = leak(repaired(valve, {{step, Annuloplasty{OwnRing{2}}}}));
      EXPECT_LT(after, 0.5 * before) << name << ' ' << to_string(step.shape) << ' ' << step.sliding;
    }
  }
}

TEST(LeafletResection, WhatCannotBeDoneIsRefused) {
  const Valve& valve = small_preset("human-normal");
  const auto paths = [&](const RepairPlan& plan) {
    const Expected<Valve> made = apply_plan(valve, plan);
    std::vector<std::string> all;
    if (!made)
      for (const Error& error : made.errors()) all.push_back(error.path);
    return all;
  };
  using Paths = std::vector<std::string>;
  const double nan = std::nan("");
  EXPECT_EQ(paths({{LeafletResection{.along = 0.0, .width_mm = nan, .height = 1.0}}}),
            (Paths{"/steps/0/along", "/steps/0/width_mm", "/steps/0/height"}));
  EXPECT_EQ(paths({{LeafletResection{.leaflet = Leaflet::Anterior, .width_mm = 11.0}}}),
            Paths{"/steps/0/width_mm"});
  EXPECT_EQ(paths({{LeafletResection{.leaflet = Leaflet::Anterior,
                                     .shape = ResectionShape::Quadrangular}}}),
            Paths{"/steps/0/leaflet"});
  EXPECT_EQ(paths({{strip(30.0)}}), Paths{"/steps/0/width_mm"});         // a third of the annulus
  EXPECT_EQ(paths({{strip(16.0, false)}}), Paths{"/steps/0/width_mm"});  // too wide to gather
  EXPECT_EQ(paths({{LeafletResection{.along = 0.15, .width_mm = 20.0}}}),
            Paths{"/steps/0/width_mm"});  // too near to a commissure
  EXPECT_EQ(paths({{triangle(10.0), strip(10.0)}}), Paths{"/steps/1/leaflet"});
}

TEST(LeafletResection, AFinerMeshLosesAsMuch) {
  const Valve& valve = small_preset("human-normal");
  const Valve fine = *refine(valve);
  const double coarse_loss = area_mm2(valve) - area_mm2(repaired(valve, {{triangle(12.0)}}));
  const double fine_loss = area_mm2(fine) - area_mm2(repaired(fine, {{triangle(12.0)}}));
  EXPECT_NEAR(fine_loss, coarse_loss, 0.1 * coarse_loss);
}

}  // namespace
}  // namespace coapt
