#include "core/opened/flow_load.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/scenes/small_preset.h"

namespace coapt {
namespace {

constexpr double kJetShare = 0.87;  // over the throat

/// Of leaflets on a surface of revolution; `place` gives (distance from the axis, z) by height.
template <class Place>
std::pair<FlowLoad, std::vector<double>> load_on(const Place& place) {
  Valve valve = shared_preset("human-normal", 1300);
  const LeafletCoordinates coordinates = leaflet_coordinates(valve);
  Points points = valve.rest_mm;
  for (Index v = 0; v < points.rows(); ++v) {
    const double angle = 2.0 * std::numbers::pi * coordinates.around[static_cast<std::size_t>(v)];
    const Vec2 at = place(coordinates.height[static_cast<std::size_t>(v)]);
    points.row(v) << at.x() * std::cos(angle), at.x() * std::sin(angle), at.y();
  }
  for (std::size_t i = 0; i < valve.annulus.size(); ++i)
    valve.annulus_mm.row(static_cast<Index>(i)) = points.row(valve.annulus[i]);
  valve.tissue.thickness_mm = 1.0;
  std::vector<double> heights;  // of the faces' middles
  for (const auto& face : valve.faces.rowwise()) {
    double sum = 0.0;
    for (const int v : face) sum += coordinates.height[static_cast<std::size_t>(v)];
    heights.push_back(sum / 3.0);
  }
  return {flow_load(valve, coordinates.height, points), heights};
}

TEST(Bernoulli, AMetreASecondTakesFourMillimetresOfMercury) {
  EXPECT_NEAR(bernoulli_mmhg(450.0, 450.0), 0.5 * 1060.0 / 133.322, 1e-9);
}

TEST(FlowLoad, FallsAlongAConeAsTheAreaDoes) {
  const auto [load, heights] = load_on([](double h) { return Vec2(18.0 - 6.0 * h, -15.0 * h); });
  EXPECT_NEAR(load.jet_mm2,
              kJetShare * (std::numbers::pi * 12.0 * 12.0 - 0.5 * 2.0 * std::numbers::pi * 12.0),
              8.0);
  for (std::size_t f = 0; f < heights.size(); ++f) {
    const double radius = 18.0 - 6.0 * heights[f];
    EXPECT_NEAR(load.share[f], 1.0 - std::pow(kJetShare * 144.0 / (radius * radius), 2.0), 0.06)
        << heights[f];
  }
}

TEST(FlowLoad, NothingActsBehindTheWaistOfAnHourglass) {
  const auto [load, heights] =
      load_on([](double h) { return Vec2(10.0 + 6.0 * std::abs(2.0 * h - 1.0), -16.0 * h); });
  for (std::size_t f = 0; f < heights.size(); ++f) {
    if (heights[f] > 0.7) {
      EXPECT_EQ(load.share[f], 0.0);
    } else if (heights[f] < 0.3) {
      EXPECT_GT(load.share[f], 0.5);
    }
  }
}

}  // namespace
}  // namespace coapt
