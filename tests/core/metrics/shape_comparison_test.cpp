#include "core/metrics/shape_comparison.h"

#include <gtest/gtest.h>

#include "tests/core/metrics/shape_scene.h"

namespace coapt {
namespace {

TEST(ShapeComparison, OfTheSameNodesIsTheirDistanceAsTheyStand) {
  const LeafletMesh reference = bowl();
  LeafletMesh closed = reference;
  closed.vertices_mm.rowwise() += Eigen::RowVector3d(0.3, 0.0, 0.4);
  const ShapeComparison comparison = compare_shapes(closed, reference);
  EXPECT_TRUE(comparison.node_to_node);
  EXPECT_FALSE(comparison.aligned);
  EXPECT_NEAR(comparison.distance.rms_mm, 0.5, 1e-12);
  EXPECT_NEAR(comparison.distance.p95_mm, 0.5, 1e-12);
  EXPECT_NEAR(comparison.distance.max_mm, 0.5, 1e-12);
  EXPECT_NEAR(comparison.rms_after_rigid_mm, 0.0, 1e-12);
}

TEST(ShapeComparison, OfTheSameNodesIsAlignedIfAskedFor) {
  const LeafletMesh reference = bowl();
  const LeafletMesh closed = moved(reference, motion_of(70.0, {1.0, 1.0, 0.0}, {5.0, 6.0, 7.0}));
  const ShapeComparison comparison = compare_shapes(closed, reference, Alignment::Rigid);
  EXPECT_TRUE(comparison.aligned);
  EXPECT_LT(comparison.distance.max_mm, 1e-9);
}

TEST(ShapeComparison, TakesQuadranglesSplitTheOtherWayForTheSameNodes) {
  Patch split;
  split.flip = true;
  EXPECT_TRUE(have_same_nodes(bowl(), bowl(split)));
  LeafletMesh renumbered = bowl();
  // By one: nearly all edges of a grid are still edges.
  for (int& vertex : renumbered.faces.reshaped())
    vertex = (vertex + 1) % static_cast<int>(renumbered.vertices_mm.rows());
  EXPECT_FALSE(have_same_nodes(bowl(), renumbered));
  EXPECT_FALSE(have_same_nodes(bowl(), bowl({-15.0, 15.0, -10.0, 10.0, 20, 30})));
}

TEST(ShapeComparison, OfOneSheetAboveAnotherIsTheHeightBetweenThemWithItsSign) {
  const LeafletMesh reference = plane({-20.0, 20.0, -20.0, 20.0, 8, 8}, 0.0);  // normals up
  for (const double height : {0.3, -0.3}) {
    const ShapeComparison comparison =
        compare_shapes(plane({-5.0, 5.0, -5.0, 5.0, 5, 5}, height), reference, Alignment::None);
    EXPECT_FALSE(comparison.node_to_node);
    EXPECT_NEAR(comparison.distance.rms_mm, 0.3, 1e-12);
    EXPECT_NEAR(comparison.distance.max_mm, 0.3, 1e-12);
    EXPECT_NEAR(comparison.mean_signed_mm, height, 1e-12);
    EXPECT_EQ(comparison.beyond_edge_share, 0.0);
  }
}

TEST(ShapeComparison, CountsNodesBeyondTheEdgeOfTheReferenceAndSaysHowMany) {
  // Columns of nodes at -5, -3, ..., 5; the reference ends at 0.
  const ShapeComparison comparison =
      compare_shapes(plane({-5.0, 5.0, -5.0, 5.0, 5, 5}, 0.0),
                     plane({-6.0, 0.0, -6.0, 6.0, 6, 6}, 0.0), Alignment::None);
  EXPECT_NEAR(comparison.beyond_edge_share, 0.5, 1e-12);
  EXPECT_NEAR(comparison.distance.max_mm, 5.0, 1e-12);
  EXPECT_NEAR(comparison.distance.rms_mm, std::sqrt((1.0 + 9.0 + 25.0) / 6.0), 1e-12);
  // Back: the reference's corners at (-6, +-6) from (-5, +-5).
  EXPECT_NEAR(comparison.back.max_mm, std::sqrt(2.0), 1e-12);
}

TEST(ShapeComparison, OfOneShapeOnTwoMeshesInTwoFramesIsTheMeshesOwnError) {
  const LeafletMesh fine = bowl({-15.0, 15.0, -10.0, 10.0, 60, 40});
  const LeafletMesh coarse = moved(bowl(), motion_of(100.0, {0.2, 0.4, 1.0}, {60.0, -20.0, 15.0}));
  const ShapeComparison comparison = compare_shapes(coarse, fine);
  EXPECT_FALSE(comparison.node_to_node);
  EXPECT_TRUE(comparison.aligned);
  EXPECT_TRUE(comparison.settled);
  EXPECT_LT(comparison.distance.max_mm, 1e-6);  // the coarse nodes are nodes of the fine mesh
  EXPECT_LT(comparison.back.max_mm, 0.06);      // curvature x (cell diagonal)^2 / 8
}

TEST(ShapeComparison, EndsWhereverItIsCancelled) {
  const LeafletMesh fine = bowl({-15.0, 15.0, -10.0, 10.0, 60, 40});
  for (const Alignment alignment : {Alignment::None, Alignment::Rigid})
    for (const int most : {0, 1, 20, 60}) {
      int asked = 0;
      const auto cancelled = [&] { return ++asked > most; };
      const ShapeComparison comparison = compare_shapes(bowl(), fine, alignment, cancelled);
      EXPECT_LT(asked, most + 30);
      EXPECT_LT(comparison.back.max_mm, 1e3);
    }
}

TEST(LeafletMesh, HasAPieceForEachSheetAndItsArea) {
  const LeafletMesh left = plane({0.0, 2.0, 0.0, 1.0, 2, 1}, 0.0);
  const LeafletMesh right = plane({0.0, 3.0, 0.0, 4.0, 3, 4}, 5.0);
  Points points(left.vertices_mm.rows() + 1 + right.vertices_mm.rows(), 3);
  points << left.vertices_mm, Eigen::RowVector3d(9.0, 9.0, 9.0), right.vertices_mm;
  Faces faces(left.faces.rows() + right.faces.rows(), 3);
  faces << left.faces,
      (right.faces.array() + static_cast<int>(left.vertices_mm.rows()) + 1).matrix();
  const LeafletMesh both = without_loose_vertices(in_pieces(points, faces));
  EXPECT_EQ(both.vertices_mm.rows(), points.rows() - 1);
  const std::vector<LeafletArea> areas = leaflet_areas(both);
  ASSERT_EQ(areas.size(), 2U);
  EXPECT_EQ(areas[0].name, "piece 1");
  EXPECT_NEAR(areas[0].area_mm2, 2.0, 1e-12);
  EXPECT_NEAR(areas[1].area_mm2, 12.0, 1e-12);
}

TEST(NodesInContact, AreThoseNearAnotherPartOfTheSurface) {
  // A sheet folded once around a half cylinder of radius 0.5 mm: its flanks, 20 mm long, lie 1 mm apart.
  const auto folded = [](double along) {
    const double arc = 0.5 * 3.141592653589793;
    if (along < 20.0) return Eigen::Vector2d(along, 0.0);
    if (along > 20.0 + arc) return Eigen::Vector2d(20.0 - (along - 20.0 - arc), 1.0);
    const double angle = (along - 20.0) / 0.5;
    return Eigen::Vector2d(20.0 + 0.5 * std::sin(angle), 0.5 - 0.5 * std::cos(angle));
  };
  const double length = 40.0 + 0.5 * 3.141592653589793;
  LeafletMesh sheet = plane({0.0, length, 0.0, 10.0, 200, 20}, 0.0);
  const Points flat = sheet.vertices_mm;
  for (Eigen::Index i = 0; i < flat.rows(); ++i) {
    const Eigen::Vector2d at = folded(flat(i, 0));
    sheet.vertices_mm.row(i) << at.x(), flat(i, 1), at.y();
  }
  const std::vector<bool> apart = nodes_in_contact(sheet, 0.9);
  EXPECT_EQ(std::count(apart.begin(), apart.end(), true), 0);
  const std::vector<bool> contact = nodes_in_contact(sheet, 1.1);
  for (Eigen::Index i = 0; i < flat.rows(); ++i) {
    const double from_fold = std::abs(flat(i, 0) - 0.5 * length);
    if (from_fold > 4.5) {
      EXPECT_TRUE(contact[static_cast<std::size_t>(i)]) << from_fold;
    } else if (from_fold < 0.7) {
      EXPECT_FALSE(contact[static_cast<std::size_t>(i)]) << from_fold;
    }
  }
}

}  // namespace
}  // namespace coapt
