// How the orifice answers to changes of geometry: figures 4.5 to 4.9, tables 4.1 and 4.2 of the
// thesis.
#pragma once

#include <array>
#include <vector>

#include "search/studies/orifice_table.h"

namespace coapt {

/// Anteroposterior dilation x annular height, trigones, tips and transverse diameter held
/// (figure 4.5).
struct AnnulusStudy {
  std::vector<double> dilation_percent, height_percent;
  std::vector<std::vector<double>> area_mm2;  ///< [height][dilation]
};

/// 0 to 30 % by 1 % x 100, 75, 50, 25, 0 %.
AnnulusStudy study_annulus(OrificeTable& table);

/// Orifice over displacements 0, step, ... most_mm along each axis: transverse, posterior, apical.
struct DisplacementGrid {
  Displaced displaced = Displaced::Anterolateral;
  int ring_sizes_below = 0;
  int nodes = 7;  ///< along each axis
  double step_mm = 1.0;
  std::vector<double> area_mm2;  ///< [(transverse * nodes + posterior) * nodes + apical]

  double at(int transverse, int posterior, int apical) const;
  Vec3 displacement_mm(std::size_t index) const;  ///< of area_mm2[index]
};

DisplacementGrid displacement_grid(OrificeTable& table, Displaced displaced, int nodes,
                                   double step_mm, int ring_sizes_below = 0);

/// T, P, A, T + P, T + A, P + A, all: which axes a displacement uses. Order of table 4.1.
inline constexpr std::array<std::array<bool, 3>, 7> kAxes = {{{true, false, false},
                                                              {false, true, false},
                                                              {false, false, true},
                                                              {true, true, false},
                                                              {true, false, true},
                                                              {false, true, true},
                                                              {true, true, true}}};
inline constexpr std::array<const char*, 7> kAxesNames = {"T",     "P",     "A",  "T + P",
                                                          "T + A", "P + A", "All"};

/// 0 to 6 mm along each axis, for each of kDisplaced (figures 4.6 to 4.8).
struct PapillaryStudy {
  std::array<DisplacementGrid, 3> grids;  ///< order of kDisplaced
};

/// `nodes` along each axis, at least 2; the thesis has 7.
PapillaryStudy study_papillary(OrificeTable& table, int nodes = 7);

/// Table 4.1, one row of it: the largest orifice with displacement along those axes or fewer, in
/// the order of kAxes.
std::array<double, 7> largest_orifices(const DisplacementGrid& grid);

/// Central differences (one-sided at the border), mm2 per mm, order of DisplacementGrid::area_mm2.
std::vector<Vec3> gradients(const DisplacementGrid& grid);

/// Their mean over the grid.
Vec3 mean_gradient(const DisplacementGrid& grid);

/// Both displaced against the sum of the same displacement of either alone.
struct Synergy {
  double share = 0.0;  ///< of the configurations with any displacement: both > sum
  double share_from_1mm = 0.0, share_from_2mm = 0.0;  ///< at least so much along each axis
  double mean_increase = 0.0;   ///< mean of both / sum - 1 where the sum is at least 1 mm2
  double total_increase = 0.0;  ///< of all orifices together: sum of both / sum of sums - 1
};
Synergy synergy(const PapillaryStudy& study);

/// Rings U1 to U3 x displacements 0 to 6 mm by 2 mm (figure 4.9, table 4.2).
struct RingStudy {
  std::array<std::array<DisplacementGrid, 4>, 3> grids;  ///< [kDisplaced][sizes below, 0 to 3]
};

RingStudy study_ring(OrificeTable& table);

/// Orifice under a ring over that under the properly sized annulus; nothing is said (NaN) where the
/// latter is below kRatioFrom_mm2. Order of DisplacementGrid::area_mm2.
inline constexpr double kRatioFrom_mm2 = 1.0;
std::vector<double> ring_ratios(const RingStudy& study, Displaced displaced, int sizes_below);

/// Table 4.2: the largest of those; NaN if there is none.
double largest_ring_ratio(const RingStudy& study, Displaced displaced, int sizes_below);

}  // namespace coapt
