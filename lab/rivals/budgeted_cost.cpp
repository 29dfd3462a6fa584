#include "lab/rivals/budgeted_cost.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

namespace coapt::rivals {
namespace {

double greatest_finite(const std::vector<double>& costs) {
  double greatest = std::numeric_limits<double>::lowest();
  for (const double cost : costs)
    if (std::isfinite(cost)) greatest = std::max(greatest, cost);
  return greatest;
}

/// Possible plans, each once.
int plan_count(const LatticeTable& table) {
  std::set<std::size_t> plans;
  for (std::size_t i = 0; i < table.costs.size(); ++i)
    if (std::isfinite(table.costs[i]))
      plans.insert(table.plans.empty() ? i : static_cast<std::size_t>(table.plans[i]));
  return static_cast<int>(plans.size());
}

}  // namespace

int value_of(double share, int count) {
  if (!(share > 0.0)) return 0;  // NaN too
  return static_cast<int>(std::min(share * count, count - 1.0));
}

double share_of(int value, int count) { return (value + 0.5) / count; }

BudgetedCost::BudgetedCost(const LatticeTable& table, int budget,
                           std::function<void(const Improvement&)> on_improvement)
    : table_(table),
      most_evaluations_(std::min(budget, plan_count(table))),
      most_calls_(kMostCallsPerEvaluation * budget),
      on_improvement_(std::move(on_improvement)),
      cost_of_impossible_(greatest_finite(table.costs)),
      known_(table.costs.size(), false) {
  assert(budget <= static_cast<int>(kMostCombinations));  // else the calls may overflow
}

std::optional<double> BudgetedCost::operator()(const std::vector<double>& shares) {
  if (ended()) return std::nullopt;
  ++calls_;
  std::vector<int> at;
  for (std::size_t k = 0; k < shares.size(); ++k)
    at.push_back(value_of(shares[k], table_.variables[k].count));
  const std::size_t index = index_of(table_, at);
  const double cost = table_.costs[index];
  const std::size_t plan =
      table_.plans.empty() ? index : static_cast<std::size_t>(table_.plans[index]);
  if (std::isfinite(cost) && !known_[plan]) {
    known_[plan] = true;
    ++evaluations_;
    if ((improvements_.empty() || cost < improvements_.back().cost)) {
      improvements_.push_back({evaluations_, cost});
      if (on_improvement_) on_improvement_(improvements_.back());
    }
  }
  return std::isfinite(cost) ? cost : cost_of_impossible_;
}

}  // namespace coapt::rivals
