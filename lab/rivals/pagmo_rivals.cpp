#include "lab/rivals/pagmo_rivals.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <pagmo/algorithm.hpp>
#include <pagmo/algorithms/cmaes.hpp>
#include <pagmo/algorithms/de1220.hpp>
#include <pagmo/algorithms/gaco.hpp>
#include <pagmo/algorithms/ihs.hpp>
#include <pagmo/algorithms/sade.hpp>
#include <pagmo/algorithms/sga.hpp>
#include <pagmo/population.hpp>
#include <pagmo/problem.hpp>
#include <utility>

namespace coapt::rivals {
namespace {

/// Twenty generations of a budget of 500; de1220 wants 7, and pagmo's own 63 of gaco would be 8.
constexpr unsigned kPopulation = 24;

/// Thrown through pagmo, which is C++ and has no other way to be stopped.
struct Ended {};

struct LatticeProblem {
  const RivalProblem* problem = nullptr;
  const SharesCost* cost = nullptr;
  bool integers = false;  // else shares

  std::pair<std::vector<double>, std::vector<double>> get_bounds() const {
    std::vector<double> upper(problem->counts.size(), 1.0);
    if (integers)
      std::transform(problem->counts.begin(), problem->counts.end(), upper.begin(),
                     [](int count) { return count - 1.0; });
    return {std::vector<double>(upper.size(), 0.0), upper};
  }
  std::vector<double>::size_type get_nix() const { return integers ? problem->counts.size() : 0; }
  std::vector<double> fitness(const std::vector<double>& x) const {
    std::vector<double> shares = x;
    if (integers)
      for (std::size_t k = 0; k < x.size(); ++k)
        shares[k] = share_of(static_cast<int>(x[k]), problem->counts[k]);
    if (const std::optional<double> value = (*cost)(shares)) return {*value};
    throw Ended{};
  }
};

struct Algorithm {
  const char* name;
  bool integers;
  /// For about so many calls; all else but the seed is pagmo's own.
  pagmo::algorithm (*make)(unsigned calls, unsigned seed);
};

constexpr std::array<Algorithm, 6> kAlgorithms{{
    {"pagmo_gaco", true,
     [](unsigned calls, unsigned seed) {
       pagmo::gaco gaco(calls / kPopulation, kPopulation);
       gaco.set_seed(seed);
       return pagmo::algorithm(std::move(gaco));
     }},
    {"pagmo_sga", true,
     [](unsigned calls, unsigned seed) {
       pagmo::sga sga(calls / kPopulation);
       sga.set_seed(seed);
       return pagmo::algorithm(std::move(sga));
     }},
    {"pagmo_ihs", true,
     [](unsigned calls, unsigned seed) {
       pagmo::ihs ihs(calls);
       ihs.set_seed(seed);
       return pagmo::algorithm(std::move(ihs));
     }},
    {"pagmo_de1220", false,
     [](unsigned calls, unsigned seed) {
       pagmo::de1220 de1220(calls / kPopulation);
       de1220.set_seed(seed);
       return pagmo::algorithm(std::move(de1220));
     }},
    {"pagmo_sade", false,
     [](unsigned calls, unsigned seed) {
       pagmo::sade sade(calls / kPopulation);
       sade.set_seed(seed);
       return pagmo::algorithm(std::move(sade));
     }},
    {"pagmo_cmaes", false,
     [](unsigned calls, unsigned seed) {
       constexpr double kAuto = -1.0, kSigma = 0.5, kTolerance = 1e-6;  // pagmo's defaults
       constexpr bool kMemory = false, kForceBounds = true;
       pagmo::cmaes cmaes(calls / kPopulation, kAuto, kAuto, kAuto, kAuto, kSigma, kTolerance,
                          kTolerance, kMemory, kForceBounds);
       cmaes.set_seed(seed);
       return pagmo::algorithm(std::move(cmaes));
     }},
}};

}  // namespace

std::vector<std::string> pagmo_rival_names() {
  std::vector<std::string> names;
  for (const Algorithm& algorithm : kAlgorithms) names.emplace_back(algorithm.name);
  return names;
}

void search_by_pagmo(const std::string& method, const RivalProblem& problem,
                     const SharesCost& cost) {
  const auto* algorithm = std::find_if(kAlgorithms.begin(), kAlgorithms.end(),
                                       [&](const Algorithm& a) { return a.name == method; });
  assert(algorithm != kAlgorithms.end());
  const unsigned calls = std::max(kPopulation, static_cast<unsigned>(problem.most_calls_of_start));
  std::mt19937_64 engine(problem.seed);
  try {
    for (int starts = 0; starts < problem.most_calls; ++starts) {
      const auto population_seed = static_cast<unsigned>(engine() >> 32);
      const auto seed = static_cast<unsigned>(engine() >> 32);
      const pagmo::problem lattice(LatticeProblem{&problem, &cost, algorithm->integers});
      const pagmo::population population(lattice, kPopulation, population_seed);
      algorithm->make(calls, seed).evolve(population);
    }
  } catch (const Ended&) {
  }
}

}  // namespace coapt::rivals
