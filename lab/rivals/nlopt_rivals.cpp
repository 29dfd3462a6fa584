#include "lab/rivals/nlopt_rivals.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <exception>
#include <nlopt.hpp>
#include <random>
#include <stdexcept>

namespace coapt::rivals {
namespace {

struct Algorithm {
  const char* name;
  nlopt::algorithm id;
  bool restarts = true;  // else it covers the range by itself, and another start repeats that
};

constexpr std::array<Algorithm, 12> kAlgorithms{{
    {"bobyqa", nlopt::LN_BOBYQA},
    {"newuoa_bound", nlopt::LN_NEWUOA_BOUND},
    {"sbplx", nlopt::LN_SBPLX},
    {"nelder_mead", nlopt::LN_NELDERMEAD},
    {"praxis", nlopt::LN_PRAXIS},
    {"direct", nlopt::GN_DIRECT, false},
    {"direct_l", nlopt::GN_DIRECT_L, false},
    {"crs2_lm", nlopt::GN_CRS2_LM},
    {"isres", nlopt::GN_ISRES},
    {"esch", nlopt::GN_ESCH},
    {"mlsl_lds_bobyqa", nlopt::G_MLSL_LDS, false},
    {"ags", nlopt::GN_AGS, false},
}};
constexpr Algorithm kCobyla{"cobyla", nlopt::LN_COBYLA};

/// Shares: more than a value of most variables, so that the first steps see a slope and not one
/// stair; BOBYQA takes none beyond 0.5.
constexpr double kFirstStep = 0.3;
/// Shorter steps than this share of a value ask for nothing new.
constexpr double kToleranceInValues = 0.1;

struct Context {
  const SharesCost& cost;
  nlopt::opt& optimizer;
  std::exception_ptr thrown = nullptr;  // by cost(): must not pass through NLopt's C code
  bool ended = false;
};

double call(const std::vector<double>& shares, std::vector<double>&, void* data) {
  auto& context = *static_cast<Context*>(data);
  try {
    if (const std::optional<double> cost = context.cost(shares)) return *cost;
  } catch (...) {
    context.thrown = std::current_exception();
  }
  context.ended = true;
  context.optimizer.force_stop();
  return 0.0;
}

void configure(nlopt::opt& optimizer, const RivalProblem& problem, int most_calls) {
  optimizer.set_lower_bounds(0.0);
  optimizer.set_upper_bounds(1.0);
  optimizer.set_initial_step(kFirstStep);
  std::vector<double> tolerance;
  for (const int count : problem.counts) tolerance.push_back(kToleranceInValues / count);
  optimizer.set_xtol_abs(tolerance);
  optimizer.set_maxeval(most_calls);
}

/// Whether to start again.
bool search_once(const Algorithm& algorithm, const RivalProblem& problem, const SharesCost& cost,
                 std::vector<double> start) {
  const auto dimensions = static_cast<unsigned>(start.size());
  nlopt::opt optimizer(algorithm.id, dimensions);
  Context context{cost, optimizer};
  const int most_calls = algorithm.restarts ? problem.most_calls_of_start : problem.most_calls;
  configure(optimizer, problem, most_calls);
  optimizer.set_min_objective(call, &context);
  if (algorithm.id == nlopt::G_MLSL_LDS) {
    nlopt::opt local(nlopt::LN_BOBYQA, dimensions);
    configure(local, problem, most_calls);
    optimizer.set_local_optimizer(local);
  }
  double least = 0.0;
  try {
    optimizer.optimize(start, least);
  } catch (const std::invalid_argument&) {
    throw;
  } catch (const nlopt::forced_stop&) {
  } catch (const std::runtime_error&) {  // roundoff_limited, or that it failed: on a plateau
  }
  if (context.thrown) std::rethrow_exception(context.thrown);
  return algorithm.restarts && !context.ended;
}

}  // namespace

std::vector<std::string> nlopt_rival_names() {
  std::vector<std::string> names;
  for (const Algorithm& algorithm : kAlgorithms) names.emplace_back(algorithm.name);
  return names;
}

void search_by_nlopt(const std::string& method, const RivalProblem& problem,
                     const SharesCost& cost) {
  const auto* found = std::find_if(kAlgorithms.begin(), kAlgorithms.end(),
                                   [&](const Algorithm& a) { return a.name == method; });
  assert(found != kAlgorithms.end() || method == kCobyla.name);
  const Algorithm& algorithm = found != kAlgorithms.end() ? *found : kCobyla;

  nlopt_srand(static_cast<unsigned long>(problem.seed));  // per thread, else seeded by the clock
  std::mt19937_64 engine(problem.seed);
  // A start may make no call at all, hence a limit here as well.
  for (int starts = 0; starts < problem.most_calls; ++starts) {
    std::vector<double> start;
    for (std::size_t k = 0; k < problem.counts.size(); ++k) start.push_back(random_share(engine));
    if (!search_once(algorithm, problem, cost, std::move(start))) return;
  }
}

}  // namespace coapt::rivals
