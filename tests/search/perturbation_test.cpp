#include "search/perturbation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>
#include <tuple>

#include "tests/scenes/small_valve.h"

namespace coapt {
namespace {

std::tuple<double, double, double> units(const Perturbation& node) {
  return {node.length_mm, node.outwards_deg / 5.0, node.posterior_deg / 5.0};
}

TEST(RegionOfInterest, HasTheThesissNodesEachOnce) {
  const std::vector<Perturbation> nodes = region_of_interest();
  std::set<std::tuple<double, double, double>> distinct;
  for (const Perturbation& node : nodes) {
    EXPECT_LE(std::abs(node.length_mm), 1.0);
    EXPECT_LE(std::abs(node.outwards_deg), 5.0);
    EXPECT_LE(std::abs(node.posterior_deg), 5.0);
    EXPECT_EQ(std::fmod(node.length_mm, 0.25), 0.0);
    EXPECT_EQ(std::fmod(node.outwards_deg, 1.0), 0.0);
    distinct.insert(units(node));
  }
  EXPECT_EQ(nodes.size(), 1089u);  // 9 x 11 x 11
  EXPECT_EQ(distinct.size(), 1089u);
}

TEST(RegionOfInterest, StartsAtTheCentreAndGoesOnInOppositePairs) {
  const std::vector<Perturbation> nodes = region_of_interest();
  EXPECT_EQ(units(nodes[0]), std::tuple(0.0, 0.0, 0.0));
  for (std::size_t i = 1; i < nodes.size(); i += 2) {
    EXPECT_EQ(nodes[i].length_mm, -nodes[i + 1].length_mm);
    EXPECT_EQ(nodes[i].outwards_deg, -nodes[i + 1].outwards_deg);
    EXPECT_EQ(nodes[i].posterior_deg, -nodes[i + 1].posterior_deg);
  }
}

// Of a function like an orifice: zero up to a threshold, then rising. Mean over the first n nodes.
double mean_of_hinge(const std::vector<Perturbation>& nodes, std::size_t n, double threshold,
                     const std::tuple<double, double, double>& slope) {
  double sum = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    const auto [l, a, b] = units(nodes[i]);
    sum += std::max(
        0.0, std::get<0>(slope) * l + std::get<1>(slope) * a + std::get<2>(slope) * b - threshold);
  }
  return sum / static_cast<double>(n);
}

TEST(RegionOfInterest, SubsetsStandForTheWholeTheBetterTheLargerTheyAre) {
  const std::vector<Perturbation> nodes = region_of_interest();
  double worst_5 = 0.0, worst_17 = 0.0, worst_65 = 0.0;
  for (const double threshold : {-2.0, 0.0, 1.0, 3.0})
    for (const auto& slope :
         {std::tuple(8.0, 2.0, 1.0), std::tuple(4.0, -4.0, 2.0), std::tuple(5.0, 3.0, -3.0)}) {
      const double whole = mean_of_hinge(nodes, nodes.size(), threshold, slope);
      worst_5 = std::max(worst_5, std::abs(mean_of_hinge(nodes, 5, threshold, slope) - whole));
      worst_17 = std::max(worst_17, std::abs(mean_of_hinge(nodes, 17, threshold, slope) - whole));
      worst_65 = std::max(worst_65, std::abs(mean_of_hinge(nodes, 65, threshold, slope) - whole));
    }
  EXPECT_LT(worst_5, 0.8);  // mm2, of means up to 4
  EXPECT_LT(worst_17, 0.3);
  EXPECT_LT(worst_65, 0.1);
}

TEST(Perturb, TheUndisturbedNodeChangesNothing) {
  const Valve valve = small_valve();
  const Valve same = perturb(valve, {}, {});
  for (std::size_t h = 0; h < valve.heads.size(); ++h)
    EXPECT_NEAR((same.heads[h].tip_mm - valve.heads[h].tip_mm).norm(), 0.0, 1e-12);
}

TEST(Perturb, TipsMoveOnASphereAboutTheSuturesAnchor) {
  const Valve valve = small_valve();
  const RepairPlan plan{{PapillaryApproximation{
      .side = Side::Anterolateral, .anchor = Anchor::SaddlePeak, .suture_length_mm = 30.0}}};
  const Valve disturbed = perturb(valve, plan, {0.5, 3.0, -4.0});
  const Vec3 anchor(0.0, 14.0, 0.0);
  const Vec3 before = valve.heads[0].tip_mm - anchor, after = disturbed.heads[0].tip_mm - anchor;
  EXPECT_NEAR(after.norm(), before.norm() + 0.5, 1e-12);
  const double angle = std::acos(before.dot(after) / (before.norm() * after.norm()));
  EXPECT_NEAR(angle * 180.0 / std::numbers::pi, 5.0, 1e-9);  // 3, 4, 5
}

TEST(Perturb, WithoutASutureTheMuscleSwingsAboutItsTrigone) {
  const Valve valve = small_valve();
  const Valve disturbed = perturb(valve, {}, {-1.0, 0.0, 5.0});
  const Vec3 anchor = valve.annulus_mm.row(1);
  EXPECT_NEAR((disturbed.heads[1].tip_mm - anchor).norm(),
              (valve.heads[1].tip_mm - anchor).norm() - 1.0, 1e-12);
}

TEST(Perturb, BothMusclesGoOutwardsAndBackwardsTogether) {
  // The small valve is symmetric about x = 0.
  const Valve valve = small_valve();
  const Valve outwards = perturb(valve, {}, {0.0, 5.0, 0.0});
  EXPECT_LT(outwards.heads[0].tip_mm.x(), valve.heads[0].tip_mm.x() - 1.0);
  EXPECT_GT(outwards.heads[1].tip_mm.x(), valve.heads[1].tip_mm.x() + 1.0);
  const Valve disturbed = perturb(valve, {}, {0.25, 2.0, 3.0});
  const Vec3 left = disturbed.heads[0].tip_mm, right = disturbed.heads[1].tip_mm;
  EXPECT_NEAR((Vec3(-left.x(), left.y(), left.z()) - right).norm(), 0.0, 1e-12);
  EXPECT_LT(perturb(valve, {}, {0.0, 0.0, 5.0}).heads[0].tip_mm.y(),
            valve.heads[0].tip_mm.y() - 1.0);
}

}  // namespace
}  // namespace coapt
