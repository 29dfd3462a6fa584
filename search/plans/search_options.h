// What a caller may set for a search.
#pragma once

#include <algorithm>
#include <cstdint>

#include "core/closure/closure.h"
#include "search/plans/objective.h"
#include "search/plans/rules.h"

namespace coapt {

/// Accepted ranges are those of search_option_table.h.
struct SearchOptions {
  /// Closures spent on searching; fewer if nothing is left to try.
  int evaluations = 2000;
  /// As a share of these, closures spent after that on plans that trade leak, opening and durability otherwise (front_search.h).
  double front_share = 0.3;
  std::uint64_t seed = 1;
  /// 0: all cores. Does not change the result.
  int threads = 0;
  /// How many ranked plans to report.
  int plans = 5;
  /// Nodes of the region of interest, of the first plan; the others have kBeforeTheRegion (ranking.h) at most. Of plans of one's own:
  /// of each.
  int region_points = 1089;
  /// Close the reported plans also under errors of single sutures and further remodelling.
  bool evidence = true;
  /// Open plans in diastole, too, from their second node on.
  bool openings = true;
  /// Times that the mesh is refined for the verdict on each reported plan; 0: its own mesh.
  int fine_levels = 1;
  /// Draws of the model's own values (model_draw.h) under which each reported plan is closed as
  /// planned; 0: none.
  int model_draws = 8;
  /// Acceptable plans in the order of their cost, as weights price them, instead of that of plan_order.h.
  bool rank_by_price = false;
  /// Stop earlier when this much time is gone, the last 40 % of it spent on ranking; 0: no limit.
  double seconds = 0.0;
  /// Stop searching after so many closures without a better plan; 0: never.
  int no_improvement = 0;
  /// Stop searching when mean + sd of a plan's leak over 17 nodes is not above this; -1: never.
  double target_mm2 = -1.0;
  SearchRules rules;
  CostWeights weights;
  ClosureOptions closure;
};

/// Plans that a search compares to the end, however few it reports: which comes first does not depend on that.
inline constexpr int kFewestCompared = 5;

inline int compared_plans(const SearchOptions& options) {
  return std::max(options.plans, kFewestCompared);
}

}  // namespace coapt
