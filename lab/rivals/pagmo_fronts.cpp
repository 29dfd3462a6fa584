#include "lab/rivals/pagmo_fronts.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <pagmo/algorithm.hpp>
#include <pagmo/algorithms/moead.hpp>
#include <pagmo/algorithms/nsga2.hpp>
#include <pagmo/population.hpp>
#include <pagmo/problem.hpp>
#include <random>
#include <utility>

#include "lab/rivals/budgeted_cost.h"

namespace coapt::rivals {
namespace {

constexpr const char* kNsga2 = "pagmo_nsga2";
constexpr const char* kMoead = "pagmo_moead";
constexpr unsigned kNsga2Population = 24;
constexpr unsigned kMoeadPopulation = 28;  // a grid of weights of three objectives, in sixths
constexpr int kMostCallsOfStartPerPlan = 2;

/// Thrown through pagmo, which has no other way to be stopped.
struct BudgetSpent {};

/// Answers for plans until as many as the budget were asked for.
class Plans {
 public:
  Plans(std::span<const LatticeTable> objectives, const FrontRivalSettings& settings)
      : objectives_(objectives), settings_(settings), known_(objectives[0].costs.size()) {
    for (const LatticeTable& table : objectives) {
      worst_.push_back(0.0);
      for (const double cost : table.costs)
        if (std::isfinite(cost)) worst_.back() = std::max(worst_.back(), cost);
    }
  }

  /// Of an impossible combination: the worst of all.
  std::vector<double> at(const std::vector<int>& combination) {
    if (asked_ == settings_.budget ||
        ++calls_ > BudgetedCost::kMostCallsPerEvaluation * settings_.budget)
      throw BudgetSpent{};
    const LatticeTable& first = objectives_[0];
    const std::size_t index = index_of(first, combination);
    if (!std::isfinite(first.costs[index])) return worst_;
    const std::size_t plan =
        first.plans.empty() ? index : static_cast<std::size_t>(first.plans[index]);
    if (!known_[plan]) {
      known_[plan] = true;
      ++asked_;
      settings_.on_plan(index);
    }
    std::vector<double> values;
    for (const LatticeTable& table : objectives_) values.push_back(table.costs[index]);
    return values;
  }

 private:
  std::span<const LatticeTable> objectives_;
  const FrontRivalSettings& settings_;
  std::vector<bool> known_;
  std::vector<double> worst_;
  int asked_ = 0, calls_ = 0;
};

struct FrontProblem {
  Plans* plans = nullptr;
  const LatticeTable* table = nullptr;
  std::size_t objectives = 3;
  bool integers = false;  // else shares

  std::pair<std::vector<double>, std::vector<double>> get_bounds() const {
    std::vector<double> upper(table->variables.size(), 1.0);
    if (integers)
      std::transform(table->variables.begin(), table->variables.end(), upper.begin(),
                     [](const LatticeVariable& variable) { return variable.count - 1.0; });
    return {std::vector<double>(upper.size(), 0.0), upper};
  }
  std::vector<double>::size_type get_nix() const { return integers ? table->variables.size() : 0; }
  std::vector<double>::size_type get_nobj() const { return objectives; }
  std::vector<double> fitness(const std::vector<double>& x) const {
    std::vector<int> combination;
    for (std::size_t k = 0; k < x.size(); ++k)
      combination.push_back(integers ? static_cast<int>(x[k])
                                     : value_of(x[k], table->variables[k].count));
    return plans->at(combination);
  }
};

pagmo::algorithm algorithm(bool nsga2, unsigned calls, unsigned seed) {
  if (nsga2) {
    pagmo::nsga2 method(calls / kNsga2Population);
    method.set_seed(seed);
    return pagmo::algorithm(std::move(method));
  }
  pagmo::moead method(calls / kMoeadPopulation);
  method.set_seed(seed);
  return pagmo::algorithm(std::move(method));
}

}  // namespace

std::vector<std::string> pagmo_front_names() { return {kNsga2, kMoead}; }

void search_front_by_pagmo(std::span<const LatticeTable> objectives,
                           const FrontRivalSettings& settings) {
  const bool nsga2 = settings.method == kNsga2;
  assert(nsga2 || settings.method == kMoead);
  Plans plans(objectives, settings);
  const pagmo::problem problem(FrontProblem{&plans, &objectives[0], objectives.size(), nsga2});
  const unsigned size = nsga2 ? kNsga2Population : kMoeadPopulation;
  const unsigned calls =
      std::max(size, static_cast<unsigned>(kMostCallsOfStartPerPlan * settings.budget));
  std::mt19937_64 engine(settings.seed);
  try {
    while (true) {
      const auto population_seed = static_cast<unsigned>(engine() >> 32);
      const auto seed = static_cast<unsigned>(engine() >> 32);
      const pagmo::population population(problem, size, population_seed);
      algorithm(nsga2, calls, seed).evolve(population);
    }
  } catch (const BudgetSpent&) {
  }
}

}  // namespace coapt::rivals
