#include "search/perturbation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <tuple>

namespace coapt {
namespace {

std::tuple<double, double, double> unit_tuple(const Perturbation& node) {
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
    distinct.insert(unit_tuple(node));
  }
  EXPECT_EQ(nodes.size(), 1089u);  // 9 x 11 x 11
  EXPECT_EQ(distinct.size(), 1089u);
}

TEST(RegionOfInterest, StartsAtTheCentreAndGoesOnInOppositePairs) {
  const std::vector<Perturbation> nodes = region_of_interest();
  EXPECT_EQ(unit_tuple(nodes[0]), std::tuple(0.0, 0.0, 0.0));
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
    const auto [l, a, b] = unit_tuple(nodes[i]);
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

}  // namespace
}  // namespace coapt
