#include "core/metrics/figure_error.h"

#include <algorithm>
#include <cmath>

namespace coapt {
namespace {

constexpr double kMeasuredOn = 650.0;  // triangles

/// At so many triangles: floor + share of the value.
struct FigureError {
  double floor = 0.0, share = 0.0;
};

FigureError mesh_error(Figure figure) {
  switch (figure) {
    case Figure::Coaptation:
      return {0.9, 0.0};
    case Figure::Tension:
      return {0.0, 0.07};
    case Figure::Opening:
      return {0.0, 0.05};
    case Figure::Gradient:
      return {0.0, 0.1};
    case Figure::LeafletRatio:
      return {0.0, 0.05};
    case Figure::CircumferentialStrain:
      return {0.0, 0.09};
    case Figure::RadialStrain:
      return {0.0, 0.06};
  }
  return {};
}

}  // namespace

std::optional<Interval> figure_interval(Figure figure, double value, int triangles) {
  if (!std::isfinite(value)) return std::nullopt;
  const auto [floor, share] = mesh_error(figure);
  const double error = (floor + share * value) * kMeasuredOn / triangles;
  return Interval{std::max(0.0, value - error), value + error};
}

}  // namespace coapt
