#include "lab/lattices/lattice_benchmark.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "core/presets/presets.h"
#include "core/valve/remodel.h"
#include "search/plans/durability.h"
#include "search/plans/exploration.h"
#include "search/plans/ranking.h"

namespace coapt {
namespace {

constexpr int kTriangles = 650;
constexpr std::size_t kPortion = 64;  // plans closed at once

Valve diseased(const char* preset, double dilation, const Vec3& al, const Vec3& pm) {
  Remodelling change;
  change.ap_dilation_percent = dilation;
  change.anterolateral_mm = al;
  change.posteromedial_mm = pm;
  return *remodel(*make_preset(preset, kTriangles), change);
}

/// The next combination of the flat variables, the first fastest.
void advance(const std::vector<FlatVariable>& variables, std::vector<int>& values) {
  for (std::size_t v = 0; v < values.size(); ++v) {
    if (++values[v] < variables[v].count) return;
    values[v] = 0;
  }
}

}  // namespace

std::vector<LatticeCase> lattice_cases(const Valve& real) {
  SearchRules both;
  both.suture_lattice_mm = 1.0;
  both.forbidden = {"papillary_approximation:annulus_point"};
  SearchRules flail;
  flail.most_neochordae = 2;
  flail.neochorda_lattice_mm = 4.0;
  flail.forbidden = {"annuloplasty:own", "annuloplasty:generic-geoform-like"};
  const Vec3 none = Vec3::Zero();
  return {
      {"functional", *make_preset("human-functional-mr", kTriangles), both},
      {"porcine-both", diseased("porcine-thesis", 10.0, {2, 3, 4}, {3, 3, 4}), both},
      {"human-pm", diseased("human-normal", 15.0, none, {4, 4, 5}), {}},
      {"real", real, both},
      {"ischaemic", diseased("human-normal", 20.0, {3, 4, 5}, {5, 6, 5}), both},
      {"flail-p2", *make_preset("human-p2-prolapse", kTriangles), flail},
  };
}

LatticeCase by_rule(LatticeCase lattice) {
  lattice.by_rule = true;
  lattice.rules.suture_lattice_mm = 2.0;
  lattice.rules.neochorda_lattice_mm = 8.0;
  return lattice;
}

LatticePlans plans_of(const PlanSpace& space, const FlatSpace& flat, PlanEvaluations& evaluations) {
  const std::vector<FlatVariable>& variables = flat.variables();
  std::size_t combinations = 1;
  for (const FlatVariable& variable : variables)
    combinations *= static_cast<std::size_t>(variable.count);
  LatticePlans all;
  std::unordered_map<const PlanRecord*, int> number;
  std::vector<int> values(variables.size(), 0);
  for (std::size_t i = 0; i < combinations; ++i, advance(variables, values)) {
    all.numbers.push_back(-1);
    const auto point = flat.point(values);
    if (!point) continue;
    const Branch& branch = space.branches()[point->branch];
    PlanRecord& record = evaluations.record(space.plan(branch, point->at));
    if (is_infeasible(record)) continue;
    const auto [found, is_new] = number.try_emplace(&record, static_cast<int>(all.plans.size()));
    if (is_new) all.plans.push_back(&record);
    all.numbers.back() = found->second;
  }
  return all;
}

std::optional<SolvedLattice> solve_lattice(const LatticeCase& lattice, int threads,
                                           const SearchContext& context) {
  SolvedLattice solved{.of = lattice,
                       .space = std::make_shared<PlanSpace>(lattice.valve, lattice.rules)};
  solved.flat = std::make_shared<FlatSpace>(*solved.space);
  SearchMonitor monitor(0.0, context.cancelled, context.progress);
  const Evaluator evaluate = context.evaluate ? context.evaluate : closing_evaluator({});
  PlanEvaluationOptions closing;
  closing.threads = threads;
  closing.known = context.known;
  closing.keep = context.keep;
  closing.guide_by_price = !lattice.by_rule;
  if (lattice.by_rule) closing.open = context.open ? context.open : Opener{open_plan};
  PlanEvaluations evaluations(evaluate, lattice.valve, std::move(closing), monitor);
  solved.before = evaluations.before();
  const auto [plans, numbers] = plans_of(*solved.space, *solved.flat, evaluations);
  for (const int number : numbers) solved.plans.push_back(std::max(0, number));
  monitor.plan(
      1 + (kChosenBy + (lattice.by_rule ? kDisease.count : 0)) * static_cast<int>(plans.size()),
      "solving lattice " + lattice.name);
  for (std::size_t first = 0; first < plans.size(); first += kPortion) {
    std::vector<PlanEvaluations::Wanted> wanted;
    for (std::size_t i = first; i < std::min(plans.size(), first + kPortion); ++i)
      for (int d = 0; d < kChosenBy; ++d) wanted.push_back({plans[i], d});
    if (!evaluations.close(wanted, PlanEvaluations::Phase::Ranking)) return std::nullopt;
    if (!lattice.by_rule) continue;
    const std::vector<PlanRecord*> portion(
        plans.begin() + static_cast<std::ptrdiff_t>(first),
        plans.begin() + static_cast<std::ptrdiff_t>(std::min(plans.size(), first + kPortion)));
    if (!evaluations.open(portion, PlanEvaluations::Phase::Ranking) ||
        !close_disease(evaluations, portion, PlanEvaluations::Phase::Ranking))
      return std::nullopt;
  }
  for (const PlanRecord* plan : plans) {
    solved.sorted_costs.push_back(evaluations.guide(*plan, kChosenBy));
    solved.closures[plan->key] = plan->closures;
    if (plan->opening) solved.openings.emplace(plan->key, *plan->opening);
    solved.closures_a_plan +=
        static_cast<double>(plan->closures.size()) + (plan->opening ? kOpeningClosures : 0);
  }
  solved.closures_a_plan /= static_cast<double>(plans.size());
  for (const int number : numbers)
    solved.costs.push_back(
        number < 0 ? std::numeric_limits<double>::infinity()
                   : evaluations.guide(*plans[static_cast<std::size_t>(number)], kChosenBy));
  std::sort(solved.sorted_costs.begin(), solved.sorted_costs.end());
  solved.seconds = monitor.seconds();
  return solved;
}

LatticeRun search_lattice(const SolvedLattice& lattice, const SearchOptions& options) {
  const Evaluator evaluate = [&](const Valve&, const ClosureResult*) {
    return ClosedPlan{lattice.before, nullptr};  // asked for the unrepaired valve alone
  };
  SearchMonitor monitor(0.0, nullptr);
  PlanEvaluationOptions closing;
  closing.threads = 1;
  closing.known = lattice.closures;
  closing.guide_by_price = !lattice.of.by_rule;  // as rivals are
  if (lattice.of.by_rule)
    closing.open = [](const Valve&) -> PlanOpening {
      throw std::logic_error("an opening that was not solved");
    };
  closing.known_openings = lattice.openings;
  PlanEvaluations evaluations(evaluate, lattice.of.valve, std::move(closing), monitor);
  SearchOptions alone = options;
  alone.threads = 1;
  const ExplorationState exploration = explore({evaluations, *lattice.space, alone, monitor});
  LatticeRun run;
  run.improvements = exploration.scored_progress;
  run.closures = evaluations.closures() - 1 + kOpeningClosures * evaluations.openings();
  run.winner = std::numeric_limits<double>::infinity();
  for (PlanRecord* plan : best_plans(exploration, lattice.of.by_rule ? kFinalists : 1)) {
    if (!evaluations.close_here(*plan, kChosenBy)) continue;
    if (lattice.of.by_rule) {
      const std::vector<PlanRecord*> finalist = {plan};
      evaluations.open(finalist, PlanEvaluations::Phase::Ranking);
      close_disease(evaluations, finalist, PlanEvaluations::Phase::Ranking);
    }
    run.winner = std::min(run.winner, evaluations.guide(*plan, kChosenBy));
  }
  return run;
}

}  // namespace coapt
