#include "search/studies/configuration_frame.h"

#include <algorithm>
#include <cmath>

namespace coapt {
namespace {

constexpr double kOnLattice = 1e-6;  // of the lattice's step

/// A coordinate of one tip, or of both.
struct Axis {
  int coordinate = 0;
  bool anterolateral = false, posteromedial = false;
  double beyond = 0.0;  ///< the lattice point below, in lattice steps
};

void add(Configuration& configuration, const Axis& axis, double by_mm) {
  if (axis.anterolateral) configuration.change.anterolateral_mm[axis.coordinate] += by_mm;
  if (axis.posteromedial) configuration.change.posteromedial_mm[axis.coordinate] += by_mm;
}

}  // namespace

std::vector<ConfigurationShare> predicted_from(const Configuration& configuration) {
  const Vec3& anterolateral = configuration.change.anterolateral_mm;
  const Vec3& posteromedial = configuration.change.posteromedial_mm;
  const bool alike = anterolateral == posteromedial;
  Configuration corner = configuration;
  std::vector<Axis> axes;
  const auto look_along = [&](Axis axis, double at_mm) {
    const double steps = at_mm / kFrameStep_mm, whole = std::floor(steps + kOnLattice);
    axis.beyond = steps - whole;
    add(corner, axis, kFrameStep_mm * whole - at_mm);
    if (axis.beyond > kOnLattice) axes.push_back(axis);
  };
  for (int k = 0; k < 3; ++k) {
    look_along({k, true, alike}, anterolateral[k]);
    if (!alike) look_along({k, false, true}, posteromedial[k]);
  }
  if (axes.empty()) return {};
  // From the cell's lowest corner to its highest, along the axis gone farthest first: these corners span
  // the simplex that the configuration lies in.
  std::stable_sort(axes.begin(), axes.end(),
                   [](const Axis& a, const Axis& b) { return a.beyond > b.beyond; });
  std::vector<ConfigurationShare> shares = {{corner, 1.0 - axes.front().beyond}};
  for (std::size_t i = 0; i < axes.size(); ++i) {
    add(corner, axes[i], kFrameStep_mm);
    shares.push_back({corner, axes[i].beyond - (i + 1 < axes.size() ? axes[i + 1].beyond : 0.0)});
  }
  std::erase_if(shares, [](const ConfigurationShare& s) { return s.share <= kOnLattice; });
  return shares;
}

}  // namespace coapt
