#include "core/metrics/rigid_fit.h"

#include <gtest/gtest.h>

#include "tests/core/metrics/shape_scene.h"

namespace coapt {
namespace {

SurfaceTree tree_of(const LeafletMesh& mesh) { return {mesh.vertices_mm, mesh.faces}; }

double largest_distance_mm(const Points& a, const Points& b) {
  return (a - b).rowwise().norm().maxCoeff();
}

TEST(RigidFit, ToPointsFindsTheMotionBackAndNeverAMirrorImage) {
  const Points there = bowl().vertices_mm;
  const RigidMotion motion = motion_of(130.0, {1.0, 2.0, -0.5}, {40.0, -7.0, 3.0});
  const RigidMotion found = fit_to_points(there, moved(there, motion));
  EXPECT_LT((found.rotation - motion.rotation).norm(), 1e-12);
  EXPECT_LT((found.shift_mm - motion.shift_mm).norm(), 1e-10);
  Points mirrored = there;
  mirrored.col(0) *= -1.0;
  EXPECT_NEAR(fit_to_points(there, mirrored).rotation.determinant(), 1.0, 1e-12);
}

TEST(RigidFit, ToASurfaceFindsTheMotionBackToANanometre) {
  const LeafletMesh mesh = bowl();
  const RigidMotion away = motion_of(6.0, {0.3, -1.0, 0.8}, {1.0, -0.7, 1.5});
  const SurfaceFit fit = fit_to_surface(moved(mesh.vertices_mm, away), tree_of(mesh));
  EXPECT_TRUE(fit.settled);
  EXPECT_LT(fit.rms_mm, 1e-9);
  EXPECT_LT(largest_distance_mm(moved(moved(mesh.vertices_mm, away), fit.motion), mesh.vertices_mm),
            1e-9);
}

TEST(RigidFit, OfAPartOfTheSurfaceFindsThePlaceWhereItWasCutOut) {
  const LeafletMesh whole = bowl();
  const LeafletMesh part = bowl({-9.0, 6.0, -7.0, 5.0, 15, 12});
  const RigidMotion away = motion_of(4.0, {1.0, 0.2, 0.5}, {0.5, 0.4, -1.0});
  const SurfaceFit fit = fit_to_surface(moved(part.vertices_mm, away), tree_of(whole));
  EXPECT_LT(largest_distance_mm(moved(moved(part.vertices_mm, away), fit.motion), part.vertices_mm),
            1e-9);
}

TEST(RigidFit, IsNotPulledByWhatLiesBeyondTheEdgeOfTheSurface) {
  const LeafletMesh whole = bowl();
  const LeafletMesh part = bowl({-15.0, 8.0, -10.0, 10.0, 23, 20});
  const RigidMotion away = motion_of(3.0, {0.1, 1.0, 0.3}, {0.3, 0.2, 0.8});
  const SurfaceFit fit = fit_to_surface(moved(whole.vertices_mm, away), tree_of(part));
  EXPECT_LT(
      largest_distance_mm(moved(moved(whole.vertices_mm, away), fit.motion), whole.vertices_mm),
      1e-9);
  EXPECT_GT(fit.rms_mm, 1.0);
}

TEST(RigidFit, FindsAMeshThatComesFromAnotherFrame) {
  const LeafletMesh mesh = bowl({-15.0, 15.0, -10.0, 10.0, 15, 10});
  for (const double angle_deg : {90.0, 120.0, 180.0}) {
    const RigidMotion away = motion_of(angle_deg, {0.5, -0.2, 1.0}, {100.0, 250.0, -80.0});
    const LeafletMesh there = moved(mesh, away);
    const SurfaceFit fit = fit_mesh_to_surface(there.vertices_mm, there.faces, tree_of(mesh));
    EXPECT_LT(largest_distance_mm(moved(there.vertices_mm, fit.motion), mesh.vertices_mm), 1e-9)
        << angle_deg;
  }
}

TEST(RigidFit, SettlesBetweenShapesThatDiffer) {
  const LeafletMesh whole = bowl();
  LeafletMesh bumpy = bowl({-16.0, 14.0, -11.0, 9.5, 25, 17});
  for (Eigen::Index i = 0; i < bumpy.vertices_mm.rows(); ++i)
    bumpy.vertices_mm(i, 2) += 0.4 * std::sin(1.3 * static_cast<double>(i));
  const LeafletMesh away = moved(bumpy, motion_of(5.0, {0.2, 0.9, 0.4}, {0.8, -0.5, 1.0}));
  const SurfaceFit fit = fit_to_surface(away.vertices_mm, tree_of(whole));
  EXPECT_TRUE(fit.settled) << fit.rounds;
  EXPECT_LT(fit.rms_mm, 0.5);
  EXPECT_LT(largest_distance_mm(moved(away.vertices_mm, fit.motion), bumpy.vertices_mm), 0.5);
}

TEST(RigidFit, SlidesNowhereAlongAPlane) {
  const SurfaceTree tree = tree_of(plane({-20.0, 20.0, -20.0, 20.0, 8, 8}, 0.0));
  const Points above = plane({-5.0, 5.0, -5.0, 5.0, 5, 5}, 0.75).vertices_mm;
  const SurfaceFit fit = fit_to_surface(above, tree);
  EXPECT_NEAR(fit.motion.shift_mm.x(), 0.0, 1e-9);
  EXPECT_NEAR(fit.motion.shift_mm.y(), 0.0, 1e-9);
  EXPECT_NEAR(fit.motion.shift_mm.z(), -0.75, 1e-9);
}

}  // namespace
}  // namespace coapt
