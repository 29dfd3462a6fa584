#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/valve/leaflet_point.h"
#include "core/valve/parametric.h"
#include "tests/scenes/small_valve.h"

namespace coapt {
namespace {

Valve skirt(int triangles) {
  ParametricValve dimensions;
  dimensions.triangles = triangles;
  Expected<Valve> valve = make_parametric_valve(dimensions);
  EXPECT_TRUE(valve);
  return *valve;
}

Vec3 rest_position(const Valve& valve, const LeafletPoint& point) {
  return position(locate(valve, leaflet_coordinates(valve), point), valve.faces, valve.rest_mm);
}

TEST(LeafletCoordinates, LandmarksAreQuarterTurns) {
  const Valve valve = small_valve();
  const std::vector<double> around = annulus_around(valve);
  // Eight vertices at equal angles of an ellipse: each quarter holds two edges, mirror images of
  // the next quarter's, so only the landmarks' own values are round.
  EXPECT_DOUBLE_EQ(around[0], 0.0);
  EXPECT_DOUBLE_EQ(around[2], 0.25);
  EXPECT_DOUBLE_EQ(around[4], 0.5);
  EXPECT_DOUBLE_EQ(around[6], 0.75);
  // First edge (18, 0) to (9 sqrt 2, 7 sqrt 2), second on to (0, 14).
  const double h = std::sqrt(0.5);
  const double first = std::hypot(18.0 * (1.0 - h), 14.0 * h);
  const double second = std::hypot(18.0 * h, 14.0 * (1.0 - h));
  EXPECT_NEAR(around[1], 0.25 * first / (first + second), 1e-15);
}

TEST(LeafletCoordinates, AnnulusPointsAreLinearInArcLengthAndWrap) {
  const Valve valve = small_valve();
  EXPECT_NEAR((annulus_point_mm(valve, 0.25) - Vec3(0, 14, 0)).norm(), 0.0, 1e-12);
  EXPECT_NEAR((annulus_point_mm(valve, -0.25) - Vec3(0, -14, 0)).norm(), 0.0, 1e-12);
  EXPECT_NEAR((annulus_point_mm(valve, 3.5) - Vec3(-18, 0, 0)).norm(), 0.0, 1e-12);
  const std::vector<double> around = annulus_around(valve);
  const Vec3 middle = 0.5 * (valve.annulus_mm.row(7) + valve.annulus_mm.row(0));
  EXPECT_NEAR((annulus_point_mm(valve, 0.5 * (around[7] + 1.0)) - middle).norm(), 0.0, 1e-12);
}

TEST(LeafletCoordinates, HeightOfAConeOfRingsDependsOnTheRingAlone) {
  // A regular cone with the annulus at height 0 and the edge at 1; by symmetry its middle ring has
  // one height, which the widths of the rings (each narrower than the one above) move off the half.
  Valve valve = small_valve();
  for (int i = 0; i < 24; ++i) valve.rest_mm.row(i).y() *= 18.0 / 14.0;
  valve.annulus_mm = valve.rest_mm.topRows(8);
  const LeafletCoordinates coordinates = leaflet_coordinates(valve);
  for (std::size_t i = 0; i < 8; ++i) {
    EXPECT_EQ(coordinates.height[i], 0.0);
    EXPECT_EQ(coordinates.height[16 + i], 1.0);
    EXPECT_NEAR(coordinates.height[8 + i], coordinates.height[8], 1e-12);
    EXPECT_GT(coordinates.height[8 + i], 0.3);
    EXPECT_LT(coordinates.height[8 + i], 0.7);
  }
}

TEST(LeafletCoordinates, AroundTurnsOnceAndKeepsTheOrderOfColumns) {
  const Valve valve = skirt(650);
  const LeafletCoordinates coordinates = leaflet_coordinates(valve);
  const auto columns = valve.annulus.size();
  const std::size_t rows = coordinates.around.size() / columns;
  for (std::size_t row = 0; row < rows; ++row) {
    double turned = 0.0;
    for (std::size_t i = 0; i < columns; ++i) {
      const double here = coordinates.around[row * columns + i];
      const double next = coordinates.around[row * columns + (i + 1) % columns];
      const double step = next - here - std::round(next - here);
      EXPECT_GT(step, 0.0) << "row " << row << " column " << i;
      turned += step;
    }
    EXPECT_NEAR(turned, 1.0, 1e-12);
  }
}

TEST(LeafletCoordinates, ConventionOfTheLeaflets) {
  EXPECT_DOUBLE_EQ(around({Leaflet::Anterior, 0.0, 1.0}), 0.5);
  EXPECT_DOUBLE_EQ(around({Leaflet::Anterior, 0.5, 1.0}), 0.25);
  EXPECT_DOUBLE_EQ(around({Leaflet::Anterior, 1.0, 1.0}), 0.0);
  EXPECT_DOUBLE_EQ(around({Leaflet::Posterior, 0.0, 1.0}), 0.5);
  EXPECT_DOUBLE_EQ(around({Leaflet::Posterior, 0.5, 1.0}), 0.75);
  EXPECT_DOUBLE_EQ(around({Leaflet::Posterior, 1.0, 1.0}), 0.0);
  const Valve valve = skirt(650);
  EXPECT_LT(rest_position(valve, {Leaflet::Posterior, 0.2, 0.8}).x(), -3.0);
  EXPECT_GT(rest_position(valve, {Leaflet::Anterior, 0.8, 0.8}).x(), 3.0);
  EXPECT_GT(rest_position(valve, {Leaflet::Anterior, 0.5, 0.2}).y(), 3.0);
  EXPECT_LT(rest_position(valve, {Leaflet::Posterior, 0.5, 0.2}).y(), -3.0);
}

TEST(LeafletCoordinates, LocatingAPointAndReadingItsCoordinatesIsTheIdentity) {
  const Valve valve = skirt(650);
  const LeafletCoordinates coordinates = leaflet_coordinates(valve);
  for (const Leaflet leaflet : {Leaflet::Anterior, Leaflet::Posterior}) {
    for (const double along : {0.03, 0.31, 0.5, 0.77, 0.98}) {
      for (const double height : {0.02, 0.4, 0.9}) {
        const Insertion place = locate(valve, coordinates, {leaflet, along, height});
        double sum = 0.0;
        for (const double weight : place.weights) {
          EXPECT_GE(weight, 0.0);
          sum += weight;
        }
        EXPECT_NEAR(sum, 1.0, 1e-12);
        const LeafletPoint back = leaflet_point(valve, coordinates, place);
        EXPECT_EQ(back.leaflet, leaflet);
        EXPECT_NEAR(back.along, along, 1e-9);
        EXPECT_NEAR(back.height, height, 1e-9);
      }
    }
  }
}

TEST(LeafletCoordinates, TheFreeEdgeIsFound) {
  const Valve valve = skirt(650);
  const LeafletCoordinates coordinates = leaflet_coordinates(valve);
  const Insertion place = locate(valve, coordinates, {Leaflet::Posterior, 0.43, 1.0});
  EXPECT_NEAR(leaflet_point(valve, coordinates, place).height, 1.0, 1e-12);
  EXPECT_NEAR(leaflet_point(valve, coordinates, place).along, 0.43, 1e-9);
}

TEST(LeafletCoordinates, MirrorImagesLieAtMirroredPlaces) {
  // The parametric skirt's geometry is symmetric about x = 0, its diagonals are not: the difference
  // is discretisation alone.
  const Valve valve = skirt(2600);
  for (const Leaflet leaflet : {Leaflet::Anterior, Leaflet::Posterior}) {
    for (const double along : {0.1, 0.3, 0.45}) {
      for (const double height : {0.3, 0.7, 1.0}) {
        Vec3 left = rest_position(valve, {leaflet, along, height});
        const Vec3 right = rest_position(valve, {leaflet, 1.0 - along, height});
        left.x() = -left.x();
        EXPECT_LT((left - right).norm(), 0.3) << along << ' ' << height;
      }
    }
  }
}

TEST(LeafletCoordinates, APointIsTheSamePlaceOnFineAndCoarseMeshes) {
  // Within a sixth of the coarse mesh's mean edge.
  const Valve coarse = skirt(650), fine = skirt(2600);
  double edges = 0.0;
  for (Eigen::Index f = 0; f < coarse.faces.rows(); ++f)
    for (int k = 0; k < 3; ++k)
      edges += (coarse.rest_mm.row(coarse.faces(f, k)) -
                coarse.rest_mm.row(coarse.faces(f, (k + 1) % 3)))
                   .norm();
  const double edge = edges / (3.0 * static_cast<double>(coarse.faces.rows()));
  double worst = 0.0;
  for (const Leaflet leaflet : {Leaflet::Anterior, Leaflet::Posterior})
    for (const double along : {0.05, 0.2, 0.35, 0.5, 0.65, 0.8, 0.95})
      for (const double height : {0.1, 0.5, 0.8, 1.0})
        worst = std::max(worst, (rest_position(coarse, {leaflet, along, height}) -
                                 rest_position(fine, {leaflet, along, height}))
                                    .norm());
  RecordProperty("worst_mm", std::to_string(worst));
  EXPECT_LT(worst, edge / 6.0) << "edge " << edge;
}

TEST(LeafletCoordinates, DoNotChangeWhenTheValveIsMoved) {
  const Valve valve = small_valve();
  Valve moved = valve;
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(0.7, Vec3(1.0, 2.0, -0.5).normalized()).toRotationMatrix();
  const Eigen::RowVector3d shift(3.0, -8.0, 5.0);
  moved.rest_mm = (valve.rest_mm * turn.transpose()).rowwise() + shift;
  moved.annulus_mm = (valve.annulus_mm * turn.transpose()).rowwise() + shift;
  const LeafletCoordinates a = leaflet_coordinates(valve), b = leaflet_coordinates(moved);
  for (std::size_t i = 0; i < a.around.size(); ++i) {
    const double around = a.around[i] - b.around[i];
    EXPECT_NEAR(around - std::round(around), 0.0, 1e-12);
    EXPECT_NEAR(a.height[i], b.height[i], 1e-12);
  }
}

}  // namespace
}  // namespace coapt
