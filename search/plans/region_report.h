// What the closures of one plan under all its disturbances say: how it leaks when the hand varies,
// how far it is from leaking, which axis decides, how it bears further remodelling.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "search/plans/plan_evaluations.h"

namespace coapt {

/// mm2, of the region of interest, its undisturbed node included; leaflets with their half
/// thickness. All but `nominal` are NaN if fewer than two nodes are closed and trusted: that says
/// nothing about a region.
struct LeakStatistics {
  double nominal = 0.0;         ///< undisturbed, trusted or not; NaN if not closed
  double mean = 0.0, sd = 0.0;  ///< sd over n
  double p95 = 0.0;             ///< see quantile()
  double worst = 0.0;
  double below_5 = 0.0, below_10 = 0.0, below_20 = 0.0;  ///< shares of the trusted nodes
};

/// How far the first node lies that leaks more than kTraceLeak_mm2 (or whose closure failed),
/// along each axis of the region alone, worst direction. As far as the region goes (1 mm, 5
/// degrees) if none on that axis leaks, or only one at its end; 0 if the plan itself does. NaN
/// where no node beside the plan itself is closed on that axis. Where few nodes of an axis are
/// closed, one in between may leak unseen.
struct LeakMargin {
  double suture_length_mm = 0.0;
  double angle_deg = 0.0;  ///< outwards or backwards, whichever leaks first
  /// Of the way to the border (region_share()), any direction: 1 if no node leaks.
  double share = 0.0;
};

/// Mean leak by suture length (rows, -1 to 1 mm) and angle outwards (columns, -5 to 5 degrees),
/// mm2; NaN where nothing was closed and trusted. Of the whole region: mean over the angles
/// backwards. Of one muscle alone: as closed.
struct LeakMap {
  std::string muscle;                         ///< "both", "anterolateral", "posteromedial"
  std::vector<std::vector<double>> leak_mm2;  ///< [9][11]
};

struct RemodellingCurve {
  std::string direction;
  std::vector<double> leak_mm2;  ///< at 0, 1, ... 6 mm; NaN where not closed or not trusted
};

/// Shares of the leak's variance over the whole region: exact for the full grid (Sobol 2001). For
/// failed nodes stands the mean of the trusted ones. NaN if the grid is not closed or nothing
/// varies.
struct RegionIndices {
  std::array<double, 3> first{}, total{};  ///< suture length, outwards, posterior
};

struct RegionReport {
  LeakStatistics leak_mm2;
  /// Of the nodes that count; failures are left out of the statistics.
  int closures = 0, failures = 0;
  LeakMargin margin_to_leak;
  std::vector<LeakMap> maps;  ///< of both first; of each sutured muscle, if those were closed
  std::vector<RemodellingCurve> remodelling;  ///< empty if none was closed
  RegionIndices indices;
  /// Two sutures, each with its own error: kIndependent and the plan as planned. NaN if not closed.
  LeakStatistics independent_leak_mm2;
};

/// @param nodes how many of the region's nodes count, [1, 1089]: of its first, those that are
/// closed.
RegionReport region_report(const PlanRecord& plan, int nodes);

/// Why a part of its margin is not known, in a sentence; empty: all of it is.
std::string why_margin_unknown(const RegionReport& report);

/// Its leak_mm2 alone.
LeakStatistics leak_statistics(const PlanRecord& plan, int nodes);

}  // namespace coapt
