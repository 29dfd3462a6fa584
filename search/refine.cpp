#include "search/refine.h"

#include <algorithm>
#include <cmath>

#include "search/nlopt_optimizer.h"

namespace coapt {
namespace {

constexpr double kFirstStepShare = 0.25;  // of a parameter's range; later rounds halve it
constexpr double kLeastFirstStep = 2.0;   // lattice steps: several pixels of orifice each
constexpr double kToleranceShare = 0.25;  // of the first step: then the neighbours take over
constexpr int kCallsPerTrial = 10;        // most of them asked for before

/// SplitMix64 (Steele, Lea and Flood 2014): the same numbers everywhere.
std::uint64_t next_random(std::uint64_t& state) {
  state += 0x9e3779b97f4a7c15ULL;
  std::uint64_t z = state;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
  return z ^ (z >> 31);
}

std::int64_t point_count(const Strategy& strategy) {
  std::int64_t count = 1;
  for (const Parameter& parameter : strategy.parameters) count *= lattice_size(parameter);
  return count;
}

std::vector<int> point_at(const Strategy& strategy, std::int64_t index) {
  std::vector<int> at;
  for (const Parameter& parameter : strategy.parameters) {
    at.push_back(static_cast<int>(index % lattice_size(parameter)));
    index /= lattice_size(parameter);
  }
  return at;
}

/// One call of refine().
class Refinement {
 public:
  Refinement(StrategySearch& search, int quota, std::uint64_t seed, const TryPoint& try_point)
      : search_(search), left_(quota), seed_(seed), try_point_(try_point) {}

  bool done() const { return left_ == 0 || stopped_ || is_exhausted(search_); }

  /// Cost at a lattice point, known or tried now; nothing when there is no trial left.
  std::optional<double> visit(const std::vector<int>& at) {
    if (const auto known = search_.costs.find(at); known != search_.costs.end())
      return known->second;
    if (left_ == 0 || stopped_) return std::nullopt;
    std::optional<Trial> trial = try_point_(search_.strategy, at);
    if (!trial) {
      stopped_ = true;
      return std::nullopt;
    }
    --left_;
    search_.costs.emplace(at, trial->cost);
    search_.history.push_back(trial->cost);
    const double cost = trial->cost;
    if (!search_.best || cost < search_.best->cost) {
      search_.best = std::move(trial);
      search_.best_at = at;
    }
    return cost;
  }

  void descend_from(const std::vector<int>& at) {
    const auto& parameters = search_.strategy.parameters;
    BoundedProblem problem;
    problem.tolerance = kToleranceShare;
    problem.most_calls = kCallsPerTrial * left_;
    for (std::size_t k = 0; k < parameters.size(); ++k) {
      const Parameter& p = parameters[k];
      problem.lower.push_back(p.lower_mm);
      problem.upper.push_back(p.upper_mm);
      problem.start.push_back(
          std::clamp(p.lower_mm + at[k] * p.lattice_mm, p.lower_mm, p.upper_mm));
      problem.first_step.push_back(
          std::max(kLeastFirstStep * p.lattice_mm,
                   std::ldexp(kFirstStepShare * (p.upper_mm - p.lower_mm), -search_.rounds)));
    }
    const PointCost cost = [&](const std::vector<double>& x) {
      std::vector<int> snapped(x.size());
      for (std::size_t k = 0; k < x.size(); ++k) snapped[k] = lattice_index(parameters[k], x[k]);
      return visit(snapped);
    };
    minimise(problem, cost, seed_);
  }

  /// Moves to better neighbours as long as there are any.
  void poll() {
    for (bool improved = true; improved && !done();) {
      const std::vector<int> centre = search_.best_at;
      for (std::size_t k = 0; k < centre.size(); ++k)
        for (const int direction : {-1, 1}) {
          std::vector<int> at = centre;
          at[k] += direction;
          if (at[k] >= 0 && at[k] < lattice_size(search_.strategy.parameters[k])) visit(at);
        }
      improved = search_.best_at != centre;
    }
  }

  /// A point that has not been tried. @pre not exhausted.
  std::vector<int> untried() {
    const std::int64_t count = point_count(search_.strategy);
    auto index = static_cast<std::int64_t>(next_random(seed_) % static_cast<std::uint64_t>(count));
    while (search_.costs.count(point_at(search_.strategy, index)) > 0) index = (index + 1) % count;
    return point_at(search_.strategy, index);
  }

 private:
  StrategySearch& search_;
  int left_;
  bool stopped_ = false;
  std::uint64_t seed_;
  const TryPoint& try_point_;
};

}  // namespace

bool is_exhausted(const StrategySearch& search) {
  return static_cast<std::int64_t>(search.costs.size()) == point_count(search.strategy);
}

void try_start(StrategySearch& search, const TryPoint& try_point) {
  std::vector<int> at;
  for (const Parameter& parameter : search.strategy.parameters)
    at.push_back(lattice_index(parameter, parameter.start_mm));
  Refinement(search, 1, 0, try_point).visit(at);
}

void refine(StrategySearch& search, int quota, std::uint64_t seed, const TryPoint& try_point) {
  Refinement refinement(search, quota, seed, try_point);
  if (!refinement.done()) refinement.descend_from(search.best_at);
  if (!refinement.done()) refinement.poll();
  while (!refinement.done()) {
    const std::vector<int> start = refinement.untried();
    refinement.visit(start);
    if (!refinement.done()) refinement.descend_from(start);
    if (!refinement.done()) refinement.poll();
  }
  ++search.rounds;
}

}  // namespace coapt
