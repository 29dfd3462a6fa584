#include "search/perturbation.h"

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <numbers>

namespace coapt {
namespace {

constexpr int kLengths = 9, kAngles = 11;
constexpr double kAngleStep_deg = 1.0;

/// The grid in units of its half widths. Opposite nodes are at i and size - 1 - i.
std::vector<Vec3> unit_grid() {
  std::vector<Vec3> grid;
  for (int l = 0; l < kLengths; ++l)
    for (int a = 0; a < kAngles; ++a)
      for (int b = 0; b < kAngles; ++b)
        grid.emplace_back(2.0 * l / (kLengths - 1) - 1.0, 2.0 * a / (kAngles - 1) - 1.0,
                          2.0 * b / (kAngles - 1) - 1.0);
  return grid;
}

Perturbation node_at(int index) {
  const int l = index / (kAngles * kAngles), a = index / kAngles % kAngles, b = index % kAngles;
  return {kLengthStep_mm * (l - kLengths / 2), kAngleStep_deg * (a - kAngles / 2),
          kAngleStep_deg * (b - kAngles / 2)};
}

}  // namespace

Vec3 disturbed_tip(const Vec3& tip, const Vec3& anchor, double outwards_sign,
                   const Perturbation& node) {
  const Vec3 line = tip - anchor;
  const Vec3 direction = line.normalized();
  const Vec3 lateral = outwards_sign * Vec3::UnitX();
  const Vec3 outwards = (lateral - direction.dot(lateral) * direction).normalized();
  const Vec3 across = direction.cross(outwards);
  const Vec3 posterior = across.y() < 0.0 ? across : Vec3(-across);
  const Vec3 swing =
      (node.outwards_deg * outwards + node.posterior_deg * posterior) * (std::numbers::pi / 180.0);
  const double angle = swing.norm();
  const Vec3 turned =
      angle > 0.0 ? Vec3(std::cos(angle) * direction + std::sin(angle) / angle * swing) : direction;
  return anchor + (line.norm() + node.length_mm) * turned;
}

std::vector<Perturbation> region_of_interest() {
  const std::vector<Vec3> grid = unit_grid();
  const std::size_t size = grid.size(), middle = size / 2;
  // Mean distance to the full grid, and the sum of distances to the nodes taken so far.
  std::vector<double> to_all(size, 0.0), to_taken(size, 0.0);
  for (std::size_t i = 0; i < size; ++i) {
    for (const Vec3& other : grid) to_all[i] += (grid[i] - other).norm();
    to_all[i] /= static_cast<double>(size);
    to_taken[i] = grid[i].norm();
  }
  std::vector<Perturbation> order = {node_at(static_cast<int>(middle))};
  std::vector<bool> taken(middle, false);  // of the pairs (i, size - 1 - i)
  while (order.size() < size) {
    const double next = static_cast<double>(order.size() + 2);
    std::size_t best = 0;
    double lowest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < middle; ++i) {
      if (taken[i]) continue;
      const double change =
          4.0 * to_all[i] / next - 4.0 * (to_taken[i] + grid[i].norm()) / (next * next);
      if (change >= lowest) continue;
      lowest = change;
      best = i;
    }
    taken[best] = true;
    order.push_back(node_at(static_cast<int>(best)));
    order.push_back(node_at(static_cast<int>(size - 1 - best)));
    for (std::size_t i = 0; i < size; ++i)
      to_taken[i] += (grid[i] - grid[best]).norm() + (grid[i] + grid[best]).norm();
  }
  return order;
}

}  // namespace coapt
