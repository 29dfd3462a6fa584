// How far a search is, and why it ended.
#pragma once

#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "core/repair/plan.h"

namespace coapt {

/// Why a search ended.
enum class SearchStop {
  EvaluationLimit,
  Exhausted,      ///< no plan is left that bounds and expectations do not rule out
  NoImprovement,  ///< for as many closures as asked for
  TargetReached,
  TimeLimit,
  Cancelled
};

/// The best score (PlanEvaluations::guide()) known after so many closures.
struct Progress {
  int closures = 0;
  double cost = 0.0;
};

/// The plan that leads a search.
struct LeadingPlan {
  RepairPlan plan;
  std::vector<std::string> description;  ///< in surgical words, one line a step
  double cost = 0.0;                     ///< over its first nodes of the region
  int nodes = 0;                         ///< how many these are
  double leak_mm2 = 0.0;                 ///< as planned
};

/// What a search reports while it runs.
struct SearchProgress {
  int closures = 0, closures_planned = 0;
  /// Of plans as planned, so far; infinite before the first.
  double best_leak_mm2 = kUnknown;
  /// "searching", "ranking", ...
  std::string stage;
  /// Best so far of one closure a plan, and what random search is expected to have after as many
  /// closures; infinite while they are not known.
  double best_cost = kUnknown, random_cost = kUnknown;

  /// Null before the first; more nodes count more than less cost.
  std::shared_ptr<const LeadingPlan> leading;

  static constexpr double kUnknown = std::numeric_limits<double>::infinity();
};

}  // namespace coapt
