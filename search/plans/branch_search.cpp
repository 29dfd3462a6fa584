#include "search/plans/branch_search.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "search/nlopt_optimizer.h"

namespace coapt {
namespace {

constexpr double kFirstStepShare = 0.25;  // of a parameter's range; later rounds halve it
constexpr double kLeastFirstStep = 2.0;   // lattice steps: several pixels of orifice each
constexpr double kToleranceShare = 0.25;  // of the first step: then the neighbours take over
constexpr int kCallsPerClosure = 10;      // most of them asked for before
constexpr LocalMethod kMethods[] = {LocalMethod::Bobyqa, LocalMethod::Sbplx,
                                    LocalMethod::NelderMead};

/// One call of refine().
class Refinement {
 public:
  Refinement(BranchSearch& search, int quota, std::uint64_t seed, const TryPoint& try_point)
      : search_(search),
        left_(quota),
        calls_left_(kCallsPerClosure * quota),
        try_point_(try_point) {
    std::seed_seq mix{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32),
                      static_cast<std::uint32_t>(search.rounds)};
    engine_.seed(mix);
  }

  bool done() const { return left_ <= 0 || calls_left_ <= 0 || stopped_ || is_exhausted(search_); }

  /// Cost at a lattice point, known or tried now; nothing when there is no trial left.
  std::optional<double> visit(const LatticePoint& at) {
    --calls_left_;
    if (const auto known = search_.costs.find(at); known != search_.costs.end())
      return known->second;
    if (left_ <= 0 || stopped_) return std::nullopt;
    const std::optional<PointCost> tried = try_point_(*search_.branch, at);
    if (!tried) {
      stopped_ = true;
      return std::nullopt;
    }
    left_ -= tried->closures;
    add_point(search_, at, *tried);
    return tried->cost;
  }

  void descend_from(const LatticePoint& at) {
    const std::vector<Parameter>& parameters = search_.branch->parameters;
    BoundedProblem problem;  // in lattice steps
    problem.method = kMethods[search_.rounds % std::ssize(kMethods)];
    problem.tolerance = kToleranceShare;
    problem.most_calls = calls_left_;
    for (std::size_t k = 0; k < parameters.size(); ++k) {
      const double last = parameters[k].count - 1;
      problem.lower.push_back(0.0);
      problem.upper.push_back(last);
      problem.start.push_back(at[k]);
      problem.first_step.push_back(
          std::max(kLeastFirstStep, std::ldexp(kFirstStepShare * last, -search_.rounds)));
    }
    const std::uint64_t seed = engine_();
    const PointCostAt cost = [&](const std::vector<double>& x) {
      LatticePoint snapped;
      for (std::size_t k = 0; k < x.size(); ++k)
        snapped.push_back(
            std::clamp(static_cast<int>(std::lround(x[k])), 0, parameters[k].count - 1));
      return visit(snapped);
    };
    minimise(problem, cost, seed);
  }

  /// Moves to better neighbours as long as there are any.
  void poll() {
    for (bool improved = true; improved && !done();) {
      const LatticePoint centre = search_.best;
      if (centre.empty()) return;
      for (std::size_t k = 0; k < centre.size(); ++k)
        for (const int direction : {-1, 1}) {
          LatticePoint at = centre;
          at[k] += direction;
          if (at[k] >= 0 && at[k] < search_.branch->parameters[k].count) visit(at);
        }
      improved = search_.best != centre;
    }
  }

  /// A point that has not been tried. @pre not exhausted.
  LatticePoint untried() {
    const std::int64_t count = point_count(*search_.branch);
    auto number = static_cast<std::int64_t>(engine_() % static_cast<std::uint64_t>(count));
    while (search_.costs.contains(point_at(*search_.branch, number))) number = (number + 1) % count;
    return point_at(*search_.branch, number);
  }

 private:
  BranchSearch& search_;
  int left_, calls_left_;
  bool stopped_ = false;
  std::mt19937_64 engine_;
  const TryPoint& try_point_;
};

}  // namespace

bool is_exhausted(const BranchSearch& search) {
  return static_cast<std::int64_t>(search.costs.size()) == point_count(*search.branch);
}

void add_point(BranchSearch& search, const LatticePoint& at, const PointCost& cost) {
  if (!cost.is_bound && cost.cost < search.best_cost) {
    search.best = at;
    search.best_cost = cost.cost;
  }
  search.costs.emplace(at, cost.cost);
}

void refine(BranchSearch& search, int quota, std::uint64_t seed, const TryPoint& try_point) {
  Refinement refinement(search, quota, seed, try_point);
  if (!refinement.done())
    refinement.descend_from(search.best.empty() ? start_of(*search.branch) : search.best);
  if (!refinement.done()) refinement.poll();
  while (!refinement.done()) {
    const LatticePoint start = refinement.untried();
    refinement.visit(start);
    if (!refinement.done()) refinement.descend_from(start);
    if (!refinement.done()) refinement.poll();
  }
  ++search.rounds;
}

}  // namespace coapt
