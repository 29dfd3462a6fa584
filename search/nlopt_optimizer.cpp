#include "search/nlopt_optimizer.h"

#include <algorithm>
#include <exception>
#include <nlopt.hpp>

namespace coapt {
namespace {

constexpr double kMostOfRange = 0.49;

nlopt::algorithm algorithm_of(LocalMethod method) {
  switch (method) {
    case LocalMethod::Bobyqa:
      return nlopt::LN_BOBYQA;
    case LocalMethod::Sbplx:
      return nlopt::LN_SBPLX;
    case LocalMethod::NelderMead:
      return nlopt::LN_NELDERMEAD;
  }
  return nlopt::LN_BOBYQA;
}

struct Context {
  const BoundedProblem& problem;
  const PointCostAt& cost;
  nlopt::opt& optimizer;
  std::exception_ptr thrown;  // by cost(): must not pass through NLopt's C code
};

double call(const std::vector<double>& x, std::vector<double>&, void* data) {
  auto& context = *static_cast<Context*>(data);
  std::vector<double> inside = x;  // BOBYQA may leave its bounds by one unit in the last place
  for (std::size_t k = 0; k < x.size(); ++k)
    inside[k] = std::clamp(x[k], context.problem.lower[k], context.problem.upper[k]);
  try {
    if (const std::optional<double> value = context.cost(inside)) return *value;
  } catch (...) {
    context.thrown = std::current_exception();
  }
  context.optimizer.force_stop();
  return 0.0;
}

}  // namespace

void minimise(const BoundedProblem& problem, const PointCostAt& cost, std::uint64_t seed) {
  nlopt_srand(
      static_cast<unsigned long>(seed));  // its generator is per thread, seeded by the clock
  nlopt::opt optimizer(algorithm_of(problem.method), static_cast<unsigned>(problem.start.size()));
  Context context{problem, cost, optimizer, nullptr};
  // BOBYQA takes no first step beyond half a range, and calls nothing then.
  std::vector<double> first_step = problem.first_step;
  for (std::size_t k = 0; k < first_step.size(); ++k)
    if (const double range = problem.upper[k] - problem.lower[k]; range > 0.0)
      first_step[k] = std::min(first_step[k], kMostOfRange * range);
  std::vector<double> tolerance = first_step;
  for (double& t : tolerance) t *= problem.tolerance;
  optimizer.set_min_objective(call, &context);
  optimizer.set_lower_bounds(problem.lower);
  optimizer.set_upper_bounds(problem.upper);
  optimizer.set_initial_step(first_step);
  optimizer.set_xtol_abs(tolerance);
  optimizer.set_maxeval(problem.most_calls);
  std::vector<double> point = problem.start;
  double value = 0.0;
  try {
    optimizer.optimize(point, value);
  } catch (const nlopt::forced_stop&) {
  } catch (const nlopt::roundoff_limited&) {  // on a plateau: the caller has what was evaluated
  }
  if (context.thrown) std::rethrow_exception(context.thrown);
}

}  // namespace coapt
