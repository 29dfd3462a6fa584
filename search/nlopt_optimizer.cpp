#include "search/nlopt_optimizer.h"

#include <nlopt.h>

#include <algorithm>
#include <cassert>
#include <memory>

#include "search/threads.h"

namespace coapt {
namespace {

constexpr double kMostOfRange = 0.49;

nlopt_algorithm algorithm_of(LocalMethod method) {
  switch (method) {
    case LocalMethod::Bobyqa:
      return NLOPT_LN_BOBYQA;
    case LocalMethod::Sbplx:
      return NLOPT_LN_SBPLX;
    case LocalMethod::NelderMead:
      return NLOPT_LN_NELDERMEAD;
  }
  return NLOPT_LN_BOBYQA;
}

struct Call {
  const BoundedProblem& problem;
  const PointCostAt& cost;
  nlopt_opt optimizer;
  Thrown thrown{};  // by cost(): must not pass through NLopt's C code
};

double cost_at(unsigned size, const double* x, double* /*gradient*/, void* data) {
  auto& call = *static_cast<Call*>(data);
  std::vector<double> inside(
      x, x + size);  // BOBYQA may leave its bounds by one unit in the last place
  for (std::size_t k = 0; k < inside.size(); ++k)
    inside[k] = std::clamp(inside[k], call.problem.lower[k], call.problem.upper[k]);
  std::optional<double> value;
  if (call.thrown.returns([&] { value = call.cost(inside); }) && value) return *value;
  nlopt_force_stop(call.optimizer);
  return 0.0;
}

}  // namespace

void minimise(const BoundedProblem& problem, const PointCostAt& cost, std::uint64_t seed) {
  nlopt_srand(
      static_cast<unsigned long>(seed));  // its generator is per thread, seeded by the clock
  const std::unique_ptr<nlopt_opt_s, decltype(&nlopt_destroy)> optimizer(
      nlopt_create(algorithm_of(problem.method), static_cast<unsigned>(problem.start.size())),
      nlopt_destroy);
  Call call{problem, cost, optimizer.get()};
  // BOBYQA takes no first step beyond half a range, and calls nothing then.
  std::vector<double> first_step = problem.first_step;
  for (std::size_t k = 0; k < first_step.size(); ++k)
    if (const double range = problem.upper[k] - problem.lower[k]; range > 0.0)
      first_step[k] = std::min(first_step[k], kMostOfRange * range);
  std::vector<double> tolerance = first_step;
  for (double& t : tolerance) t *= problem.tolerance;
  nlopt_set_min_objective(optimizer.get(), cost_at, &call);
  nlopt_set_lower_bounds(optimizer.get(), problem.lower.data());
  nlopt_set_upper_bounds(optimizer.get(), problem.upper.data());
  nlopt_set_initial_step(optimizer.get(), first_step.data());
  nlopt_set_xtol_abs(optimizer.get(), tolerance.data());
  nlopt_set_maxeval(optimizer.get(), problem.most_calls);
  std::vector<double> point = problem.start;
  double value = 0.0;
  // On a plateau the caller has what was evaluated; any other refusal is a bug here.
  [[maybe_unused]] const nlopt_result result =
      nlopt_optimize(optimizer.get(), point.data(), &value);
  assert(result > 0 || result == NLOPT_FORCED_STOP || result == NLOPT_ROUNDOFF_LIMITED);
  call.thrown.rethrow();
}

}  // namespace coapt
