#include "lab/lattices/lattice_benchmark.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "lab/lattices/lattice_findings.h"
#include "tests/search/plans/search_scene.h"

namespace coapt {
namespace {

using scene::needs_suture;

/// Own rings and sutures of the posteromedial muscle by 2 mm, a few dozen plans.
LatticeCase small_case() {
  LatticeCase lattice{"small", small_valve(), {}};
  lattice.rules.suture_lattice_mm = 2.0;
  lattice.rules.forbidden = {
      "papillary_approximation:anterolateral", "papillary_approximation:annulus_point",
      "annuloplasty:generic-etlogix-like", "annuloplasty:generic-geoform-like"};
  return lattice;
}

SolvedLattice solved(const LatticeCase& lattice = small_case()) {
  SearchContext context;
  context.evaluate = needs_suture;
  context.open = [](const Valve&) {
    PlanOpening opening;
    opening.measure.opening_area_mm2 = 400.0;
    opening.measure.gradient_mmhg = 2.0;
    return opening;
  };
  return *solve_lattice(lattice, 1, context);
}

TEST(FlatSpace, EveryPointOfEveryBranchIsReached) {
  const LatticeCase lattice = small_case();
  const PlanSpace space(lattice.valve, lattice.rules);
  const FlatSpace flat(space);
  std::set<std::pair<std::size_t, LatticePoint>> reached;
  std::vector<int> values(flat.variables().size(), 0);
  std::size_t combinations = 1, missing = 0;
  for (const FlatVariable& variable : flat.variables())
    combinations *= static_cast<std::size_t>(variable.count);
  for (std::size_t i = 0; i < combinations; ++i) {
    std::size_t rest = i;
    for (std::size_t v = 0; v < values.size(); ++v) {
      const auto count = static_cast<std::size_t>(flat.variables()[v].count);
      values[v] = static_cast<int>(rest % count);
      rest /= count;
    }
    if (const auto point = flat.point(values)) {
      reached.insert({point->branch, point->at});
    } else {
      ++missing;
    }
  }
  std::int64_t points = 0;
  for (const Branch& branch : space.branches()) points += point_count(branch);
  EXPECT_EQ(static_cast<std::int64_t>(reached.size()), points);
  EXPECT_GT(missing, 0u) << "doing nothing is no branch";
}

TEST(LatticeBenchmark, EveryPlanHasOneCostAndCombinationsOfOnePlanShareIt) {
  const SolvedLattice lattice = solved();
  ASSERT_EQ(lattice.costs.size(), lattice.plans.size());
  std::vector<double> cost_of(lattice.costs.size(), std::nan(""));
  std::set<int> plans;
  for (std::size_t i = 0; i < lattice.costs.size(); ++i) {
    if (!std::isfinite(lattice.costs[i])) continue;
    double& cost = cost_of[static_cast<std::size_t>(lattice.plans[i])];
    if (std::isnan(cost)) cost = lattice.costs[i];
    EXPECT_EQ(cost, lattice.costs[i]);
    plans.insert(lattice.plans[i]);
  }
  EXPECT_EQ(plans.size(), lattice.sorted_costs.size());
  EXPECT_TRUE(std::is_sorted(lattice.sorted_costs.begin(), lattice.sorted_costs.end()));
  EXPECT_EQ(*std::min_element(lattice.costs.begin(), lattice.costs.end()),
            lattice.sorted_costs.front());
}

TEST(LatticeBenchmark, ASearchOfItFindsTheOptimumWithoutANewClosure) {
  const SolvedLattice lattice = solved();
  SearchOptions options;
  options.evaluations = 17 * static_cast<int>(lattice.sorted_costs.size());
  options.plans = 1;
  const LatticeRun run = search_lattice(lattice, options);
  EXPECT_EQ(run.winner, lattice.sorted_costs.front());
  EXPECT_EQ(run.improvements.back().cost, lattice.sorted_costs.front());
  EXPECT_LE(run.closures, options.evaluations);
}

TEST(LatticeBenchmark, ByTheRuleEveryPlanIsOpenedAndClosedUnderDiseaseBeforehand) {
  const SolvedLattice lattice = solved(by_rule(small_case()));
  EXPECT_EQ(lattice.openings.size(), lattice.sorted_costs.size());
  EXPECT_GT(lattice.closures_a_plan, kChosenBy + kOpeningClosures);
  EXPECT_NE(lattice.sorted_costs, solved().sorted_costs) << "another score";
  SearchOptions options;
  options.evaluations = 40 * static_cast<int>(lattice.sorted_costs.size());
  options.plans = 1;
  // Without a new closure or opening: the one throws, the other leaks as the valve does.
  EXPECT_EQ(search_lattice(lattice, options).winner, lattice.sorted_costs.front());
}

TEST(LatticeFindings, CountEachPlanWithARingThatClosesOnce) {
  const SolvedLattice lattice = solved();
  const LatticeFindings findings = findings_of(lattice);
  int closing = 0;
  for (const RingTightness& ring : findings.rings) {
    EXPECT_LE(ring.robust, ring.closing);
    closing += ring.closing;
  }
  EXPECT_GT(closing, 0);
  EXPECT_LT(closing, static_cast<int>(lattice.sorted_costs.size()) * 2);
  EXPECT_LE(findings.anchors.trigone_cheaper, findings.anchors.pairs);
}

}  // namespace
}  // namespace coapt
