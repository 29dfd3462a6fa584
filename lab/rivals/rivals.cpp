#include "lab/rivals/rivals.h"

#include <cassert>
#include <cmath>
#include <numeric>
#include <set>
#include <utility>

#include "lab/rivals/nlopt_rivals.h"
#include "lab/rivals/sobol.h"

namespace coapt::rivals {
namespace {

constexpr const char* kRandom = "random";
constexpr const char* kRandomVariables = "random_variables";
constexpr const char* kSobol = "sobol";
/// Enough that a start that still finds new combinations spends the budget before; some genetic
/// algorithms, CRS2 and ESCH gather where they know everything, after a fifth of it.
constexpr int kMostCallsOfStartPerEvaluation = 2;

/// Every plan with the same chance, none twice: what random search is where plans can be listed.
void search_plans_at_random(const LatticeTable& table, const RivalProblem& problem,
                            const SharesCost& cost) {
  std::vector<std::size_t> order;  // one combination of each plan
  std::set<int> seen;
  for (std::size_t i = 0; i < table.costs.size(); ++i)
    if (std::isfinite(table.costs[i]) &&
        (table.plans.empty() || seen.insert(table.plans[i]).second))
      order.push_back(i);
  std::mt19937_64 engine(problem.seed);
  for (std::size_t i = 0; i < order.size(); ++i) {
    const auto left = static_cast<double>(order.size() - i);
    std::swap(order[i], order[i + static_cast<std::size_t>(random_share(engine) * left)]);
    std::vector<double> shares;
    const std::vector<int> at = combination_of(table, order[i]);
    for (std::size_t k = 0; k < at.size(); ++k)
      shares.push_back(share_of(at[k], problem.counts[k]));
    if (!cost(shares)) return;
  }
}

/// Every combination with the same chance, none twice (Fisher and Yates's shuffle).
void search_at_random(const RivalProblem& problem, const SharesCost& cost) {
  std::size_t combinations = 1;
  for (const int count : problem.counts) combinations *= static_cast<std::size_t>(count);
  std::vector<std::size_t> order(combinations);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::mt19937_64 engine(problem.seed);
  std::vector<double> shares(problem.counts.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const auto left = static_cast<double>(order.size() - i);
    std::swap(order[i], order[i + static_cast<std::size_t>(random_share(engine) * left)]);
    std::size_t index = order[i];
    for (std::size_t k = 0; k < shares.size(); ++k) {
      const auto count = static_cast<std::size_t>(problem.counts[k]);
      shares[k] = share_of(static_cast<int>(index % count), problem.counts[k]);
      index /= count;
    }
    if (!cost(shares)) return;
  }
}

void search_by_sobol(const RivalProblem& problem, const SharesCost& cost) {
  std::mt19937_64 engine(problem.seed);
  std::vector<std::uint32_t> shift;
  for (std::size_t k = 0; k < problem.counts.size(); ++k)
    shift.push_back(static_cast<std::uint32_t>(engine() >> 32));
  SobolSequence sequence(static_cast<int>(problem.counts.size()), std::move(shift));
  while (cost(sequence.next())) {
  }
}

}  // namespace

std::vector<std::string> rival_names() {
  std::vector<std::string> names{kRandom, kRandomVariables, kSobol};
  for (std::string& name : nlopt_rival_names()) names.push_back(std::move(name));
  return names;
}

RivalRun run_rival(const LatticeTable& table, const RivalSettings& settings) {
  if (settings.method == kRandom)
    return run_rival(table, settings, [&](const RivalProblem& problem, const SharesCost& cost) {
      search_plans_at_random(table, problem, cost);
    });
  if (settings.method == kRandomVariables) return run_rival(table, settings, search_at_random);
  if (settings.method == kSobol) return run_rival(table, settings, search_by_sobol);
  return run_rival(table, settings, [&](const RivalProblem& problem, const SharesCost& cost) {
    search_by_nlopt(settings.method, problem, cost);
  });
}

RivalRun run_rival(const LatticeTable& table, const RivalSettings& settings, const Rival& rival) {
  BudgetedCost cost(table, settings.budget, settings.on_improvement);
  RivalProblem problem{{},
                       settings.seed,
                       BudgetedCost::kMostCallsPerEvaluation * settings.budget,
                       kMostCallsOfStartPerEvaluation * settings.budget};
  for (const LatticeVariable& variable : table.variables) problem.counts.push_back(variable.count);
  rival(problem, std::ref(cost));
  return {settings.method, settings.seed, cost.improvements(), cost.evaluations(), cost.calls()};
}

}  // namespace coapt::rivals
