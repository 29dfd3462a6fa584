#include "core/closure/insertion_zone.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/scenes/sheets.h"

namespace coapt {
namespace {

constexpr double kZone_mm = 2.0;

/// 24 x 24 mm in cells of this edge.
Valve grid_of(double edge_mm) {
  std::vector<double> lines;
  for (int i = 0; i * edge_mm <= 24.0 + 1e-9; ++i) lines.push_back(i * edge_mm);
  return grid_sheet(lines, lines, [](int, int) { return false; });
}

/// The point (x, y) as an insertion.
Insertion at(const Valve& valve, double x, double y) {
  for (int f = 0; f < valve.faces.rows(); ++f) {
    const Vec3 a = valve.rest_mm.row(valve.faces(f, 0)), b = valve.rest_mm.row(valve.faces(f, 1)),
               c = valve.rest_mm.row(valve.faces(f, 2));
    Eigen::Matrix2d edges;
    edges << (b - a).head<2>(), (c - a).head<2>();
    const Eigen::Vector2d w = edges.inverse() * (Eigen::Vector2d(x, y) - a.head<2>());
    if (w.minCoeff() >= -1e-12 && w.sum() <= 1.0 + 1e-12) return {f, {1.0 - w.sum(), w[0], w[1]}};
  }
  return {};
}

struct Moments {
  double sum = 0.0;
  Vec3 mean = Vec3::Zero();
  double second_mm2 = 0.0;  ///< mean squared distance from the mean
};

Moments moments(const Valve& valve, const std::vector<NodeShare>& zone) {
  Moments m;
  for (const NodeShare& share : zone) {
    m.sum += share.weight;
    m.mean += share.weight * valve.rest_mm.row(share.node).transpose();
  }
  for (const NodeShare& share : zone)
    m.second_mm2 +=
        share.weight * (valve.rest_mm.row(share.node).transpose() - m.mean).squaredNorm();
  return m;
}

TEST(InsertionZone, HasTheMeanOfItsDiscOnEveryMesh) {
  for (const double edge : {3.0, 2.0, 1.0, 0.5}) {
    const Valve valve = grid_of(edge);
    const Moments m = moments(valve, insertion_zone(valve, at(valve, 11.3, 12.6), kZone_mm));
    EXPECT_NEAR(m.sum, 1.0, 1e-12);
    EXPECT_LT((m.mean - Vec3(11.3, 12.6, 0.0)).norm(), 0.02) << edge;
  }
}

TEST(InsertionZone, TendsToTheSecondMomentOfItsCone) {
  // Of the cone 1 - d / r: integral of d^3 (1 - d / r) over that of d (1 - d / r) = 0.3 r^2.
  const Valve valve = grid_of(0.25);
  const Moments m = moments(valve, insertion_zone(valve, at(valve, 12.1, 11.9), kZone_mm));
  EXPECT_NEAR(m.second_mm2, 0.3 * kZone_mm * kZone_mm, 0.03);
}

TEST(InsertionZone, AtTheEdgeHasTheMeanOfHalfADisc) {
  // Distance from the edge: integral of 2 d^2 (1 - d / r) over that of pi d (1 - d / r) = r / pi.
  const Valve valve = grid_of(0.5);
  const Moments m = moments(valve, insertion_zone(valve, at(valve, 12.1, 0.0), kZone_mm));
  EXPECT_NEAR(m.mean.x(), 12.1, 0.01);
  EXPECT_NEAR(m.mean.y(), kZone_mm / M_PI, 0.01);
}

TEST(InsertionZone, OfNoRadiusIsTheFace) {
  const Valve valve = grid_of(3.0);
  const Insertion insertion = at(valve, 10.0, 8.0);
  const auto zone = insertion_zone(valve, insertion, 0.0);
  EXPECT_EQ(zone.size(), 3u);
  EXPECT_LT((moments(valve, zone).mean - Vec3(10.0, 8.0, 0.0)).norm(), 1e-12);
}

TEST(InsertionZone, LeavesOutALeafletThatLiesOnIt) {
  Valve valve = grid_of(1.0);
  const Index vertices = valve.rest_mm.rows(), faces = valve.faces.rows();
  Points both(2 * vertices, 3);
  both << valve.rest_mm, valve.rest_mm.rowwise() + Vec3(0, 0, 0.3).transpose();
  Faces twice(2 * faces, 3);
  twice << valve.faces, (valve.faces.array() + static_cast<int>(vertices)).matrix();
  const Insertion insertion = at(valve, 12.2, 12.2);
  valve.rest_mm = both;
  valve.faces = twice;
  for (const NodeShare& share : insertion_zone(valve, insertion, kZone_mm))
    EXPECT_LT(share.node, vertices);
}

}  // namespace
}  // namespace coapt
