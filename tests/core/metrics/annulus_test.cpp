#include "core/metrics/annulus.h"

#include <gtest/gtest.h>

#include <numbers>

#include "tests/scenes/sheets.h"

namespace coapt {
namespace {

constexpr int kCorners = 400;

/// An ellipse of 40 x 28 mm on a saddle of the given height, its peaks anterior and posterior.
Valve elliptic_annulus(double saddle_height_mm) {
  Valve valve = disc_with_hole(1.0, 0.5, kCorners, 1);
  for (int i = 0; i < kCorners; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / kCorners;
    valve.annulus_mm.row(i) << 20.0 * std::cos(angle), 14.0 * std::sin(angle),
        -0.5 * saddle_height_mm * std::cos(2.0 * angle);
  }
  return valve;
}

TEST(Annulus, AnEllipseHasItsAxesAreaAndCircumference) {
  const AnnulusMeasure measure = measure_annulus(elliptic_annulus(0.0));
  EXPECT_NEAR(measure.ap_mm, 28.0, 1e-9);
  EXPECT_NEAR(measure.al_pm_mm, 40.0, 1e-9);
  EXPECT_NEAR(measure.saddle_height_mm, 0.0, 1e-9);
  EXPECT_NEAR(measure.area_mm2,
              0.5 * kCorners * 20.0 * 14.0 * std::sin(2.0 * std::numbers::pi / kCorners), 1e-9);
  EXPECT_NEAR(measure.circumference_mm, 107.647, 0.01);  // Ramanujan's second formula
}

TEST(Annulus, ASaddleHasItsHeightAndTheProjectedDimensionsOfTheEllipse) {
  const AnnulusMeasure measure = measure_annulus(elliptic_annulus(6.0));
  EXPECT_NEAR(measure.saddle_height_mm, 6.0, 1e-6);
  EXPECT_NEAR(measure.ap_mm, 28.0, 1e-6);
  EXPECT_NEAR(measure.al_pm_mm, 40.0, 1e-6);
  EXPECT_NEAR(measure.area_mm2, measure_annulus(elliptic_annulus(0.0)).area_mm2, 1e-6);
  EXPECT_GT(measure.circumference_mm, 107.7);
}

TEST(Annulus, TheTransverseDiameterIsTheSameWhereverCommissuresLie) {
  Valve askew = elliptic_annulus(0.0);
  askew.landmarks.anterolateral_commissure += 3;
  EXPECT_NEAR(measure_annulus(askew).al_pm_mm, 40.0, 1e-9);
  EXPECT_EQ(measure_annulus(askew).al_pm_mm, transverse_diameter_mm(askew));
}

TEST(Annulus, RigidMotionChangesNothing) {
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
  motion.translate(Vec3(-3.0, 40.0, 12.0));
  motion.rotate(Eigen::AngleAxisd(3.0, Vec3(1.0, 0.3, 0.2).normalized()));
  const AnnulusMeasure here = measure_annulus(elliptic_annulus(6.0));
  const AnnulusMeasure there = measure_annulus(moved(elliptic_annulus(6.0), motion));
  EXPECT_NEAR(here.ap_mm, there.ap_mm, 1e-9);
  EXPECT_NEAR(here.al_pm_mm, there.al_pm_mm, 1e-9);
  EXPECT_NEAR(here.area_mm2, there.area_mm2, 1e-9);
  EXPECT_NEAR(here.circumference_mm, there.circumference_mm, 1e-9);
  EXPECT_NEAR(here.saddle_height_mm, there.saddle_height_mm, 1e-9);
}

TEST(Annulus, ThePlanesAxesAreThoseOfTheValve) {
  const AnnulusFrame plane = annulus_frame(elliptic_annulus(6.0), AnnulusAxis::Commissures);
  EXPECT_LT((plane.x - Vec3::UnitX()).norm(), 1e-9);
  EXPECT_LT((plane.y - Vec3::UnitY()).norm(), 1e-9);
  EXPECT_LT((plane.normal - Vec3::UnitZ()).norm(), 1e-9);
}

}  // namespace
}  // namespace coapt
