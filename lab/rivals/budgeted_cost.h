// What a rival may ask: a lattice's costs, behind a cache and a budget.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "lab/rivals/lattice_table.h"

namespace coapt::rivals {

/// The best cost so far, found by the evaluation of this number (from 1).
struct Improvement {
  int evaluations = 0;
  double cost = 0.0;

  bool operator==(const Improvement&) const = default;
};

/// Value that a share in [0, 1] of a variable's range stands for: `count` bins of equal width.
int value_of(double share, int count);
/// The middle of its bin.
double share_of(int value, int count);

/// A call of a plan that was asked before is free, as behind the cache that anybody puts before a
/// simulator that costs seconds; so is an impossible one, which needs no simulation.
class BudgetedCost {
 public:
  /// A rival that stalls on what it knows ends at so many calls times its budget.
  static constexpr int kMostCallsPerEvaluation = 20;

  /// @pre `table` outlives it.
  BudgetedCost(const LatticeTable& table, int budget,
               std::function<void(const Improvement&)> on_improvement = {});

  /// Nothing when the budget, the combinations or the calls are used up. An impossible combination
  /// costs the greatest finite cost of the table, because optimisers that interpolate break on
  /// infinities: a rival's user would know such a bound. @param shares one for each variable,
  /// outside of [0, 1] clamped.
  std::optional<double> operator()(const std::vector<double>& shares);

  bool ended() const { return evaluations_ == most_evaluations_ || calls_ == most_calls_; }
  int evaluations() const { return evaluations_; }
  int calls() const { return calls_; }
  const std::vector<Improvement>& improvements() const { return improvements_; }

 private:
  const LatticeTable& table_;
  int most_evaluations_;
  int most_calls_;
  std::function<void(const Improvement&)> on_improvement_;
  double cost_of_impossible_;
  std::vector<bool> known_;  // of each plan, or of each combination
  int evaluations_ = 0;
  int calls_ = 0;
  std::vector<Improvement> improvements_;
};

}  // namespace coapt::rivals
