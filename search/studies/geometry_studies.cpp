#include "search/studies/geometry_studies.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace coapt {
namespace {

constexpr int kMostDilation_percent = 30;
constexpr std::array<double, 5> kHeights_percent = {100.0, 75.0, 50.0, 25.0, 0.0};
constexpr int kRingNodes = 4;

/// Calls visit(transverse, posterior, apical) in the order of DisplacementGrid::area_mm2.
template <class Visit>
void for_each_node(int nodes, const Visit& visit) {
  for (int t = 0; t < nodes; ++t)
    for (int p = 0; p < nodes; ++p)
      for (int a = 0; a < nodes; ++a) visit(t, p, a);
}

}  // namespace

AnnulusStudy study_annulus(OrificeTable& table) {
  AnnulusStudy study;
  study.height_percent.assign(kHeights_percent.begin(), kHeights_percent.end());
  for (int d = 0; d <= kMostDilation_percent; ++d) study.dilation_percent.push_back(d);
  std::vector<Configuration> wanted;
  for (const double height : study.height_percent)
    for (const double dilation : study.dilation_percent) {
      Configuration configuration;
      configuration.change.ap_dilation_percent = dilation;
      configuration.change.annular_height_percent = height;
      wanted.push_back(configuration);
    }
  const std::vector<OrificeSample> closed = table.at(wanted);
  auto next = closed.begin();
  for (std::size_t h = 0; h < study.height_percent.size(); ++h) {
    study.area_mm2.emplace_back();
    for (std::size_t d = 0; d < study.dilation_percent.size(); ++d)
      study.area_mm2.back().push_back((next++)->area_mm2);
  }
  return study;
}

double DisplacementGrid::at(int transverse, int posterior, int apical) const {
  return area_mm2[(transverse * nodes + posterior) * nodes + apical];
}

Vec3 DisplacementGrid::displacement_mm(std::size_t index) const {
  const auto i = static_cast<int>(index);
  return step_mm * Vec3(i / (nodes * nodes), i / nodes % nodes, i % nodes);
}

DisplacementGrid displacement_grid(OrificeTable& table, Displaced displaced, int nodes,
                                   double step_mm, int ring_sizes_below) {
  DisplacementGrid grid{displaced, ring_sizes_below, nodes, step_mm, {}};
  std::vector<Configuration> wanted;
  for (int i = 0; i < nodes * nodes * nodes; ++i)
    wanted.push_back(displacement(displaced, grid.displacement_mm(i), ring_sizes_below));
  for (const OrificeSample& sample : table.at(wanted)) grid.area_mm2.push_back(sample.area_mm2);
  return grid;
}

PapillaryStudy study_papillary(OrificeTable& table, int nodes) {
  PapillaryStudy study;
  for (std::size_t k = 0; k < kDisplaced.size(); ++k)
    study.grids[k] =
        displacement_grid(table, kDisplaced[k], nodes, kMostDisplacement_mm / (nodes - 1));
  return study;
}

std::array<double, 7> largest_orifices(const DisplacementGrid& grid) {
  std::array<double, 7> largest;
  largest.fill(-std::numeric_limits<double>::infinity());
  for_each_node(grid.nodes, [&](int t, int p, int a) {
    const std::array<bool, 3> moved = {t > 0, p > 0, a > 0};
    for (std::size_t k = 0; k < kAxes.size(); ++k) {
      bool along = true;
      for (std::size_t axis = 0; axis < 3; ++axis) along &= kAxes[k][axis] || !moved[axis];
      if (along) largest[k] = std::max(largest[k], grid.at(t, p, a));
    }
  });
  return largest;
}

std::vector<Vec3> gradients(const DisplacementGrid& grid) {
  std::vector<Vec3> gradient;
  for_each_node(grid.nodes, [&](int t, int p, int a) {
    Vec3 slope;
    for (int k = 0; k < 3; ++k) {
      std::array<int, 3> low = {t, p, a}, high = {t, p, a};
      low[k] = std::max(0, low[k] - 1);
      high[k] = std::min(grid.nodes - 1, high[k] + 1);
      slope(k) = (grid.at(high[0], high[1], high[2]) - grid.at(low[0], low[1], low[2])) /
                 (grid.step_mm * (high[k] - low[k]));
    }
    gradient.push_back(slope);
  });
  return gradient;
}

Vec3 mean_gradient(const DisplacementGrid& grid) {
  Vec3 sum = Vec3::Zero();
  const std::vector<Vec3> slopes = gradients(grid);
  for (const Vec3& slope : slopes) sum += slope;
  return sum / static_cast<double>(slopes.size());
}

Synergy synergy(const PapillaryStudy& study) {
  const DisplacementGrid& al = study.grids[0];
  const DisplacementGrid& pm = study.grids[1];
  const DisplacementGrid& both = study.grids[2];
  std::array<int, 3> counted = {0, 0, 0}, above = {0, 0, 0};
  double together = 0.0, apart = 0.0, increases = 0.0;
  int compared = 0;
  for_each_node(both.nodes, [&](int t, int p, int a) {
    const double sum = al.at(t, p, a) + pm.at(t, p, a);
    const double least_mm = both.step_mm * std::min({t, p, a});
    if (t + p + a == 0) return;
    for (std::size_t k = 0; k < counted.size() && static_cast<double>(k) <= least_mm; ++k) {
      ++counted[k];
      if (both.at(t, p, a) > sum) ++above[k];
    }
    together += both.at(t, p, a);
    apart += sum;
    if (sum < kRatioFrom_mm2) return;
    increases += both.at(t, p, a) / sum - 1.0;
    ++compared;
  });
  const auto share = [&](std::size_t k) { return static_cast<double>(above[k]) / counted[k]; };
  return {share(0), share(1), share(2), increases / compared, together / apart - 1.0};
}

RingStudy study_ring(OrificeTable& table) {
  RingStudy study;
  for (std::size_t k = 0; k < kDisplaced.size(); ++k)
    for (std::size_t sizes = 0; sizes < study.grids[k].size(); ++sizes)
      study.grids[k][sizes] =
          displacement_grid(table, kDisplaced[k], kRingNodes,
                            kMostDisplacement_mm / (kRingNodes - 1), static_cast<int>(sizes));
  return study;
}

std::vector<double> ring_ratios(const RingStudy& study, Displaced displaced, int sizes_below) {
  const auto& grids = study.grids[static_cast<int>(displaced)];
  const std::vector<double>& proper = grids[0].area_mm2;
  const std::vector<double>& ring = grids[sizes_below].area_mm2;
  std::vector<double> ratios;
  for (std::size_t i = 0; i < proper.size(); ++i)
    ratios.push_back(proper[i] >= kRatioFrom_mm2 ? ring[i] / proper[i]
                                                 : std::numeric_limits<double>::quiet_NaN());
  return ratios;
}

double largest_ring_ratio(const RingStudy& study, Displaced displaced, int sizes_below) {
  double largest = std::numeric_limits<double>::quiet_NaN();
  for (const double ratio : ring_ratios(study, displaced, sizes_below))
    largest = std::fmax(largest, ratio);
  return largest;
}

}  // namespace coapt
