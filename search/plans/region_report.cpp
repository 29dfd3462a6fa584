#include "search/plans/region_report.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>

#include "core/metrics/quantile.h"
#include "core/repair/approximation.h"
#include "core/valve/counted.h"

namespace coapt {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
constexpr double kRounding_mm2 = 1e-9;
constexpr int kMiddleLength = kRegionLengths / 2, kMiddleAngle = kRegionAngles / 2;

double mean_of(std::span<const double> values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// Over n.
double variance_of(std::span<const double> values) {
  const double mean = mean_of(values);
  double sum = 0.0;
  for (const double value : values) sum += (value - mean) * (value - mean);
  return sum / static_cast<double>(values.size());
}

LeakStatistics statistics(double nominal, const std::vector<double>& values) {
  if (values.size() < 2)
    return {nominal, kUnknown, kUnknown, kUnknown, kUnknown, kUnknown, kUnknown, kUnknown};
  const auto below = [&values](double limit) {
    const auto count = std::count_if(values.begin(), values.end(),
                                     [limit](double value) { return value < limit; });
    return static_cast<double>(count) / static_cast<double>(values.size());
  };
  return {.nominal = nominal,
          .mean = mean_of(values),
          .sd = std::sqrt(variance_of(values)),
          .p95 = quantile(values, 0.95),
          .worst = *std::max_element(values.begin(), values.end()),
          .below_5 = below(5.0),
          .below_10 = below(10.0),
          .below_20 = below(20.0)};
}

/// The closures of one plan that count, by index of disturbance.
class Closures {
 public:
  Closures(const PlanRecord& plan, int nodes) : plan_(plan), nodes_(nodes) {}

  /// Null if it is not closed, or a node of the region that does not count.
  const PlanClosure* at(int disturbance) const {
    const bool region = disturbance < kRegion.count;
    if (disturbance > 0 && region && disturbance >= nodes_) return nullptr;
    const auto found = plan_.closures.find(disturbance);
    return found == plan_.closures.end() ? nullptr : &found->second;
  }
  double leak(int disturbance) const {
    const PlanClosure* closure = at(disturbance);
    return closure != nullptr && trusted(*closure) ? closure->leak_mm2 : kUnknown;
  }
  /// Whether it was closed and failed, or leaks more than a competent valve.
  bool leaks(int disturbance) const {
    return at(disturbance) != nullptr && !(leak(disturbance) <= kTraceLeak_mm2);
  }
  bool any(const DisturbanceSet& set) const {
    for (int d = set.first; d < set.first + set.count; ++d)
      if (at(d) != nullptr) return true;
    return false;
  }

 private:
  const PlanRecord& plan_;
  int nodes_;
};

/// Of the trusted closures.
template <class Value>
std::vector<double> values_of(const Closures& closures, const DisturbanceSet& set,
                              const Value& value) {
  std::vector<double> values;
  for (int d = set.first; d < set.first + set.count; ++d)
    if (!std::isnan(closures.leak(d))) values.push_back(value(*closures.at(d)));
  return values;
}

/// Of an axis through the middle of the region: how many nodes from there the first leak lies,
/// either way; `reach` if none does, NaN if none is closed.
template <class NodeAt>
double first_leak(const Closures& closures, int reach, const NodeAt& node_at) {
  bool closed = false;
  for (int way = 1; way <= reach; ++way)
    for (const int node : {node_at(way), node_at(-way)}) {
      if (closures.leaks(node)) return way;
      closed = closed || closures.at(node) != nullptr;
    }
  return closed ? reach : kUnknown;
}

LeakMargin leak_margin(const Closures& closures) {
  if (closures.leaks(0)) return {};
  LeakMargin margin{kUnknown, kUnknown, kUnknown};
  margin.suture_length_mm =
      kRegionLength_mm / kMiddleLength * first_leak(closures, kMiddleLength, [](int way) {
        return region_node(kMiddleLength + way, kMiddleAngle, kMiddleAngle);
      });
  const double outwards = first_leak(closures, kMiddleAngle, [](int way) {
    return region_node(kMiddleLength, kMiddleAngle + way, kMiddleAngle);
  });
  const double posterior = first_leak(closures, kMiddleAngle, [](int way) {
    return region_node(kMiddleLength, kMiddleAngle, kMiddleAngle + way);
  });
  margin.angle_deg = kRegionAngle_deg / kMiddleAngle * std::fmin(outwards, posterior);
  for (int d = 1; d < kRegion.count; ++d) {
    if (closures.at(d) == nullptr) continue;
    const double share = closures.leaks(d) ? region_share(disturbances()[d]) : 1.0;
    margin.share = std::fmin(margin.share, share);
  }
  return margin;
}

/// @param leak_at of (length, outwards).
template <class LeakAt>
LeakMap leak_map(const std::string& muscle, const LeakAt& leak_at) {
  LeakMap map{muscle, {}};
  for (int length = 0; length < kRegionLengths; ++length) {
    map.leak_mm2.emplace_back();
    for (int outwards = 0; outwards < kRegionAngles; ++outwards)
      map.leak_mm2.back().push_back(leak_at(length, outwards));
  }
  return map;
}

std::vector<LeakMap> leak_maps(const Closures& closures, const RepairPlan& plan) {
  std::vector<LeakMap> maps = {leak_map("both", [&closures](int length, int outwards) {
    std::vector<double> leaks;
    for (int posterior = 0; posterior < kRegionAngles; ++posterior)
      if (const double leak = closures.leak(region_node(length, outwards, posterior));
          !std::isnan(leak))
        leaks.push_back(leak);
    return leaks.empty() ? kUnknown : mean_of(leaks);
  })};
  for (const Side side : {Side::Anterolateral, Side::Posteromedial}) {
    const DisturbanceSet& alone =
        side == Side::Anterolateral ? kAnterolateralAlone : kPosteromedialAlone;
    if (suture_of(plan, side) != nullptr && closures.any(alone))
      maps.push_back(leak_map(to_string(side), [&](int length, int outwards) {
        return closures.leak(slice_node(side, length, outwards));
      }));
  }
  return maps;
}

std::vector<RemodellingCurve> remodelling_curves(const Closures& closures) {
  std::vector<RemodellingCurve> curves;
  if (!closures.any(kRemodelling)) return curves;
  for (const RemodellingRay& ray : remodelling_rays()) {
    curves.push_back({ray.direction, {}});
    for (const int index : ray.indices) curves.back().leak_mm2.push_back(closures.leak(index));
  }
  return curves;
}

/// Leaks of the whole grid, by length, outwards, posterior; empty if it is not closed.
std::vector<double> whole_grid(const Closures& closures) {
  std::vector<double> grid, known;
  for (int place = 0; place < kRegion.count; ++place) {
    const int node = region_node(place / (kRegionAngles * kRegionAngles),
                                 place / kRegionAngles % kRegionAngles, place % kRegionAngles);
    if (closures.at(node) == nullptr) return {};
    grid.push_back(closures.leak(node));
    if (!std::isnan(grid.back())) known.push_back(grid.back());
  }
  if (known.empty()) return {};
  const double mean = mean_of(known);
  for (double& leak : grid)
    if (std::isnan(leak)) leak = mean;
  return grid;
}

RegionIndices region_indices(const Closures& closures) {
  RegionIndices indices;
  indices.first.fill(kUnknown);
  indices.total.fill(kUnknown);
  const std::vector<double> grid = whole_grid(closures);
  if (grid.empty()) return indices;
  const auto [lowest, highest] = std::minmax_element(grid.begin(), grid.end());
  if (*highest - *lowest < kRounding_mm2) return indices;
  constexpr std::array<int, 3> kCounts = {kRegionLengths, kRegionAngles, kRegionAngles};
  constexpr std::array<int, 3> kStrides = {kRegionAngles * kRegionAngles, kRegionAngles, 1};
  const double variance = variance_of(grid);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const int count = kCounts[axis], stride = kStrides[axis], others = kRegion.count / count;
    std::vector<double> along(count, 0.0);
    std::vector<double> across(others, 0.0);
    for (int place = 0; place < kRegion.count; ++place) {
      const int other = place / (stride * count) * stride + place % stride;
      const double leak = grid[place];
      along[place / stride % count] += leak / others;
      across[other] += leak / count;
    }
    indices.first[axis] = variance_of(along) / variance;
    indices.total[axis] = std::max(0.0, 1.0 - variance_of(across) / variance);
  }
  return indices;
}

}  // namespace

RegionReport region_report(const PlanRecord& plan, int nodes) {
  const Closures closures(plan, nodes);
  RegionReport report;
  for (int d = 0; d < kRegion.count; ++d) {
    report.closures += closures.at(d) != nullptr;
    report.failures += closures.at(d) != nullptr && !trusted(*closures.at(d));
  }
  const auto leak = [](const PlanClosure& closure) { return closure.leak_mm2; };
  const PlanClosure* planned = closures.at(0);
  const double nominal = planned == nullptr ? kUnknown : leak(*planned);
  report.leak_mm2 = leak_statistics(plan, nodes);
  std::vector<double> independent = values_of(closures, kIndependent, leak);
  if (!std::isnan(closures.leak(0))) independent.push_back(nominal);
  report.independent_leak_mm2 = statistics(nominal, independent);
  report.margin_to_leak = leak_margin(closures);
  report.maps = leak_maps(closures, plan.plan);
  report.remodelling = remodelling_curves(closures);
  report.indices = region_indices(closures);
  return report;
}

std::string why_margin_unknown(const RegionReport& report) {
  const bool length = std::isfinite(report.margin_to_leak.suture_length_mm),
             angle = std::isfinite(report.margin_to_leak.angle_deg);
  if (length && angle) return "";
  if (report.closures < 2) return "no error of execution was closed";
  const std::string closed =
      "the " + counted(report.closures - 1, "error") + " of execution closed";
  if (length) return "no error of angle alone is among " + closed;
  if (angle) return "no error of suture length alone is among " + closed;
  return "neither an error of suture length alone nor one of angle alone is among " + closed;
}

LeakStatistics leak_statistics(const PlanRecord& plan, int nodes) {
  const Closures closures(plan, nodes);
  const auto leak = [](const PlanClosure& closure) { return closure.leak_mm2; };
  const PlanClosure* planned = closures.at(0);
  return statistics(planned == nullptr ? kUnknown : leak(*planned),
                    values_of(closures, kRegion, leak));
}

}  // namespace coapt
