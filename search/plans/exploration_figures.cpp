#include <algorithm>

#include "search/plans/exploration.h"
#include "search/studies/rank_correlation.h"

namespace coapt {
namespace {

constexpr double kLeastCorrelation = 0.8;

}  // namespace

std::vector<Progress> Exploration::random_progress() const {
  std::vector<double> costs;
  for (const PlanRecord* plan : random_) costs.push_back(desk_.cost(*plan, 1));
  std::sort(costs.begin(), costs.end());
  const auto n = costs.size();
  std::vector<Progress> expected;
  for (std::size_t drawn = 1; drawn <= n; ++drawn) {
    // The chance that the k-th cheapest is the cheapest of those drawn.
    double mean = 0.0, chance = static_cast<double>(drawn) / static_cast<double>(n);
    for (std::size_t k = 0; k + drawn <= n; ++k) {
      mean += chance * costs[k];
      chance *= static_cast<double>(n - drawn - k) / static_cast<double>(n - 1 - k);
    }
    expected.push_back({static_cast<int>(drawn), mean});
  }
  return expected;
}

std::vector<LadderStep> Exploration::ladder() const {
  std::vector<LadderStep> steps;
  const auto add = [&](int from, int to, const std::vector<const PlanRecord*>& plans) {
    std::vector<double> few, many;
    for (const PlanRecord* plan : plans) {
      few.push_back(from == 0 ? plan->lowest_cost : desk_.cost(*plan, from));
      if (from == kRungs[0]) few.back() = guessed_[few.size() - 1];
      many.push_back(desk_.cost(*plan, to));
    }
    const double correlation = rank_correlation(few, many);
    steps.push_back(
        {from, to, static_cast<int>(plans.size()), correlation, correlation < kLeastCorrelation});
  };
  add(0, kRungs[0], random_);
  for (std::size_t r = 0; r + 1 < std::size(kRungs); ++r) add(kRungs[r], kRungs[r + 1], measured_);
  return steps;
}

}  // namespace coapt
