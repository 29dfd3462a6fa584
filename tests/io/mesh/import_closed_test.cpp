// Imports of leaflets that were imaged closed.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <utility>

#include "core/closure/closure.h"
#include "core/presets/presets.h"
#include "core/valve/leaflet_coordinates.h"
#include "core/valve/leaflet_of.h"
#include "core/valve/leaflet_point.h"
#include "io/mesh/hanging_profile.h"
#include "io/mesh/import_valve.h"

namespace coapt {
namespace {

/// A strip 10 mm wide that falls from (., 15, 0) by 12 mm over 16 mm: 20 mm long.
TriangleMesh falling_strip() {
  TriangleMesh strip;
  constexpr int kRows = 10;
  strip.vertices_mm.resize(2 * (kRows + 1), 3);
  for (int row = 0; row <= kRows; ++row)
    for (int side = 0; side < 2; ++side)
      strip.vertices_mm.row(2 * row + side) << 10.0 * side - 5.0, 15.0 - 1.6 * row, -1.2 * row;
  strip.faces.resize(2 * kRows, 3);
  for (int row = 0; row < kRows; ++row) {
    strip.faces.row(2 * row) << 2 * row, 2 * row + 2, 2 * row + 1;
    strip.faces.row(2 * row + 1) << 2 * row + 1, 2 * row + 2, 2 * row + 3;
  }
  return strip;
}

TEST(ExposedLeaflet, IsAsLongAsItsSection) {
  const auto exposed = exposed_leaflet(falling_strip(), Vec3(1.0, 15.5, 0.0), 3.0);
  ASSERT_TRUE(exposed);
  EXPECT_NEAR(exposed->length_mm, 20.5, 1e-9);  // with the half millimetre to the annulus
  EXPECT_NEAR((exposed->end_mm - Vec3(1.0, -1.0, -12.0)).norm(), 0.0, 1e-9);
}

TEST(ExposedLeaflet, IsNoneWhereNoSectionBeginsAtTheAnnulus) {
  EXPECT_FALSE(exposed_leaflet(falling_strip(), Vec3(1.0, 20.0, 0.0), 3.0));
  EXPECT_FALSE(exposed_leaflet(falling_strip(), Vec3(7.0, 15.0, 0.0), 3.0));
}

/// Faces that belong to one leaflet; commissural ones by where they are.
TriangleMesh closed_leaflet(const Valve& valve, const Points& closed_mm, Leaflet leaflet) {
  TriangleMesh mesh;
  std::map<int, int> kept;
  std::vector<Eigen::RowVector3i> faces;
  const LeafletCoordinates coordinates = leaflet_coordinates(valve);
  for (Eigen::Index f = 0; f < valve.faces.rows(); ++f) {
    const auto first = static_cast<std::size_t>(valve.faces(f, 0));
    if ((coordinates.around[first] < 0.5) != (leaflet == Leaflet::Anterior)) continue;
    Eigen::RowVector3i face;
    for (int k = 0; k < 3; ++k)
      face[k] = kept.emplace(valve.faces(f, k), static_cast<int>(kept.size())).first->second;
    faces.push_back(face);
  }
  mesh.faces.resize(std::ssize(faces), 3);
  for (std::size_t i = 0; i < faces.size(); ++i)
    mesh.faces.row(static_cast<Eigen::Index>(i)) = faces[i];
  mesh.vertices_mm.resize(std::ssize(kept), 3);
  for (const auto& [from, to] : kept) mesh.vertices_mm.row(to) = closed_mm.row(from);
  return mesh;
}

/// human-normal, closed: its leaflets with what coaptation hides.
ImportSource closed_source() {
  const Valve valve = *make_preset("human-normal");
  const Points closed_mm = close_valve(valve).closed_mm;
  ImportSource source;
  source.leaflets = {closed_leaflet(valve, closed_mm, Leaflet::Anterior),
                     closed_leaflet(valve, closed_mm, Leaflet::Posterior)};
  source.annulus_mm = valve.annulus_mm;
  source.tissue = valve.tissue;  // by which the open leaflets are shorter
  return source;
}

ImportOptions closed_options(double hidden_mm) {
  ImportOptions options;
  options.closed = true;
  options.hidden_mm = hidden_mm;
  options.chordae_seed = 0;
  return options;
}

double height_mm(const Valve& valve, Leaflet leaflet) {
  const LeafletCoordinates coordinates = leaflet_coordinates(valve);
  const auto at = [&](double height) {
    const Insertion point = locate(valve, coordinates, {leaflet, 0.5, height});
    return position(point, valve.faces, valve.rest_mm);
  };
  return (at(1.0) - at(0.0)).norm();  // such leaflets hang straight
}

TEST(ImportClosed, OpenLeafletsAreAsTallAsTheValvesOwn) {
  const Expected<Valve> valve = import_valve(closed_source(), closed_options(0.0));
  ASSERT_TRUE(valve);
  const Valve own = *make_preset("human-normal");
  for (const Leaflet leaflet : {Leaflet::Anterior, Leaflet::Posterior})
    EXPECT_NEAR(height_mm(*valve, leaflet), height_mm(own, leaflet), 1.0) << to_string(leaflet);
  EXPECT_EQ(valve->tissue.reference, TissueReference::InVivo);
  const ClosureResult closed = close_valve(*valve);
  EXPECT_EQ(closed.status, ClosureStatus::Converged);
  EXPECT_FALSE(closed.crossing);
}

TEST(ImportClosed, HiddenHeightIsAddedWhereALeafletEndsAtTheOther) {
  const Valve bare = *import_valve(closed_source(), closed_options(0.0));
  const Valve taller = *import_valve(closed_source(), closed_options(4.0));
  const auto added_mm = [&](Leaflet leaflet) {
    return height_mm(taller, leaflet) - height_mm(bare, leaflet);
  };
  EXPECT_NEAR(added_mm(Leaflet::Posterior), 4.0, 0.1);
  EXPECT_NEAR(added_mm(Leaflet::Anterior), 0.0, 0.1);  // seen to its end, below the posterior one
}

TEST(ImportClosed, TheSaddleOrientsTheValve) {
  ImportSource turned = closed_source();
  const auto over = [](Points& points) {
    points.col(1) *= -1.0;
    points.col(2) *= -1.0;
  };
  for (TriangleMesh& mesh : turned.leaflets) over(mesh.vertices_mm);
  over(turned.annulus_mm);
  const Valve valve = *import_valve(closed_source(), closed_options(0.0));
  const Valve again = *import_valve(turned, closed_options(0.0));
  EXPECT_LT((again.rest_mm - valve.rest_mm).cwiseAbs().maxCoeff(), 1e-6);
  for (auto point : turned.annulus_mm.rowwise()) point.z() = 0.0;
  EXPECT_EQ(import_valve(turned, closed_options(0.0)).errors().front().path, "/tips");
}

TEST(ImportClosed, WhatItNeedsIsNamed) {
  const auto first_path = [](ImportSource source, const ImportOptions& options) {
    const Expected<Valve> valve = import_valve(std::move(source), options);
    return valve ? std::string("imported") : valve.errors().front().path;
  };
  ImportOptions undrawn = closed_options(3.0);
  undrawn.chordae_seed.reset();
  EXPECT_EQ(first_path(closed_source(), undrawn), "/closed");
  EXPECT_EQ(first_path(closed_source(), closed_options(15.5)), "/hidden_mm");
  EXPECT_EQ(first_path(closed_source(), closed_options(std::nan(""))), "/hidden_mm");
  ImportSource one = closed_source();
  one.leaflets.pop_back();
  EXPECT_EQ(first_path(one, closed_options(3.0)), "/leaflets");
}

}  // namespace
}  // namespace coapt
