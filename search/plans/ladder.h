// The ladder from few closures a plan to many: nodes of the region by which plans are compared
// before they are finalists, and how well few of them rank plans as many do.
#pragma once

#include <iterator>
#include <vector>

namespace coapt {

/// Nodes of the region at each rung.
inline constexpr int kRungs[] = {1, 5, 17};
inline constexpr int kLastRung = static_cast<int>(std::size(kRungs)) - 1;
/// Nodes by which finalists are chosen.
inline constexpr int kChosenBy = kRungs[kLastRung];

/// One step of the ladder.
struct LadderStep {
  /// Nodes; from 0: geometry alone.
  int from = 0, to = 0;
  /// Over which the correlation was measured.
  int plans = 0;
  /// Of costs; NaN if not measured.
  double spearman = 0.0;
  /// Below 0.8: geometry alone is then no reason to leave a plan out; from few nodes plans climb
  /// more freely, from 17 more of them.
  bool skipped = false;
};

/// @param few, many costs of the same plans at `from` and `to` nodes.
LadderStep measure_ladder_step(int from, int to, const std::vector<double>& few,
                               const std::vector<double>& many);

}  // namespace coapt
