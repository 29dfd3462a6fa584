#include "search/plans/exploration_state.h"

#include <algorithm>

#include "core/repair/describe.h"
#include "search/plans/durability.h"
#include "search/plans/region_report.h"

namespace coapt {
namespace {

/// The entry cost is the worst of as many branches' best plans as are compared: what a search climbs by is near the rule that ranks, not the rule.
void update_entry_cost(ExplorationState& state) {
  const int place = compared_plans(state.in.options) - 1;
  if (std::ssize(state.branches) <= place) return;
  std::vector<double> best;
  for (const BranchState& branch : state.branches) best.push_back(branch.best_scored);
  std::nth_element(best.begin(), best.begin() + place, best.end());
  state.entry_cost = best[place];
}

bool asks_how_long(const ExplorationState& state) {
  return state.in.options.evidence && !state.in.options.rank_by_price;
}

/// Over so many nodes it costs less than all others.
void tell_leading(const ExplorationState& state, const PlanRecord& plan, int nodes) {
  const PlanEvaluations& evaluations = state.in.evaluations;
  state.in.monitor.leads({plan.plan, describe(evaluations.valve(), plan.plan),
                          evaluations.cost(plan, nodes), nodes, plan.closures.at(0).leak_mm2});
}

/// A plan has reached kChosenBy nodes at a cost that no other plan of its branch had.
void record_scored(ExplorationState& state, const Trial& trial) {
  const double cost = state.branches[trial.branch].best_scored = trial.expected.cost;
  if (state.scored_progress.empty() || cost < state.scored_progress.back().cost) {
    state.scored_progress.push_back({state.in.evaluations.closures(), cost});
    state.improved_at = state.in.evaluations.closures();
    tell_leading(state, *trial.record, kChosenBy);
  }
  const RegionReport region = region_report(*trial.record, kChosenBy);
  if (region.failures == 0 &&
      region.leak_mm2.mean + region.leak_mm2.sd <= state.in.options.target_mm2)
    state.stop = SearchStop::TargetReached;
}

}  // namespace

ExplorationState make_state(const ExplorationInput& input) {
  ExplorationState state{.in = input};
  for (int rung = 0; rung < kLastRung; ++rung)
    state.climb_models.emplace_back(kRungs[rung], kRungs[rung + 1]);
  const SearchOptions& options = input.options;
  for (const Branch& branch : input.space.branches()) {
    const PlanRecord& mildest =
        input.evaluations.record(input.space.plan(branch, mildest_of(branch)));
    BranchState& added = state.branches.emplace_back();
    added.search.branch = &branch;
    // A suture's length is rounded to the lattice: by half a step, of two sutures.
    added.lowest_cost =
        mildest.least_guide - input.evaluations.movement_guide() * options.rules.suture_lattice_mm;
  }
  return state;
}

int evaluations_left(const ExplorationState& state) {
  return state.in.options.evaluations + 1 - state.in.evaluations.closures();
}

int promotion_closures(const ExplorationState& state, int from_rung, int to_rung) {
  const int nodes = kRungs[to_rung] - kRungs[from_rung];
  return to_rung == kLastRung && asks_how_long(state) ? nodes + kDisease.count : nodes;
}

bool is_over(ExplorationState& state) {
  const int patience = state.in.options.no_improvement;
  if (state.in.monitor.cancelled()) {
    state.stop = SearchStop::Cancelled;
  } else if (state.in.monitor.search_stopped()) {
    state.stop = SearchStop::TimeLimit;
  } else if (patience > 0 && state.in.evaluations.closures() - state.improved_at >= patience) {
    state.stop = SearchStop::NoImprovement;
  } else if (state.stop != SearchStop::TargetReached) {
    return evaluations_left(state) <= 0;
  }
  return true;
}

double cost_to_beat(const ExplorationState& state, int branch) {
  return std::min(state.entry_cost, state.branches[branch].best_scored);
}

ClimbModel::Expectation expectation(const ExplorationState& state, const PlanRecord& plan,
                                    int rung) {
  if (rung < kLastRung) return state.climb_models[rung].expected(state.in.evaluations, plan);
  const double cost = state.in.evaluations.guide(plan, kChosenBy);
  return {cost, cost, 0.0, 0.0, cost};
}

void refit_climb_models(ExplorationState& state) {
  for (int rung = 0; rung < kLastRung; ++rung) {
    std::vector<const PlanRecord*> climbed;
    for (const Trial& trial : state.trials)
      if (trial.rung > rung) climbed.push_back(trial.record);
    state.climb_models[rung].learn(state.in.evaluations, climbed);
  }
  for (BranchState& branch : state.branches) {
    branch.search.best.clear();
    branch.search.best_cost = BranchState::kUnknown;
  }
  for (Trial& trial : state.trials) {
    trial.expected = expectation(state, *trial.record, trial.rung);
    BranchSearch& search = state.branches[trial.branch].search;
    for (const LatticePoint& at : trial.at) search.costs[at] = trial.expected.cost;
    if (trial.expected.cost >= search.best_cost) continue;
    search.best = trial.at.front();
    search.best_cost = trial.expected.cost;
  }
}

void record_trial(ExplorationState& state, PlanRecord& plan, const BranchPoint& point) {
  const double cost = state.in.evaluations.guide(plan, 1);
  const ClimbModel::Expectation expected = expectation(state, plan, 0);
  BranchSearch& search = state.branches[point.branch].search;
  if (!search.costs.contains(point.at)) add_point(search, point.at, {expected.cost, 0, false});
  const auto [found, is_new] =
      state.trial_of.try_emplace(&plan, static_cast<int>(state.trials.size()));
  if (!is_new) {
    std::vector<LatticePoint>& known = state.trials[found->second].at;
    if (std::find(known.begin(), known.end(), point.at) == known.end()) known.push_back(point.at);
    return;
  }
  state.trials.push_back({&plan, point.branch, {point.at}, 0, expected});
  std::vector<Progress>& progress = state.progress;
  if (!progress.empty() && cost >= progress.back().cost) return;
  state.improved_at = state.in.evaluations.closures();
  if (!progress.empty() && progress.back().closures == state.improved_at) progress.pop_back();
  progress.push_back({state.improved_at, cost});
  state.in.monitor.found(cost);
  if (state.scored_progress.empty()) tell_leading(state, plan, 1);
}

void try_points(ExplorationState& state, const std::vector<BranchPoint>& points) {
  std::vector<PlanRecord*> plans;
  std::vector<BranchPoint> chosen;
  std::vector<PlanEvaluations::Wanted> wanted;
  for (const BranchPoint& point : points) {
    BranchSearch& search = state.branches[point.branch].search;
    PlanRecord& plan = state.in.evaluations.record(state.in.space.plan(*search.branch, point.at));
    if (is_infeasible(plan) || plan.least_guide >= cost_to_beat(state, point.branch)) {
      if (!search.costs.contains(point.at))
        add_point(search, point.at,
                  {is_infeasible(plan) ? kInfeasibleCost : plan.least_guide, 0, true});
      continue;
    }
    if (std::ssize(wanted) >= evaluations_left(state)) {
      state.budget_short = true;
      break;
    }
    plans.push_back(&plan);
    chosen.push_back(point);
    if (!plan.closures.contains(0)) wanted.push_back({&plan, 0});
  }
  state.in.evaluations.close(wanted, PlanEvaluations::Phase::Searching);
  for (std::size_t i = 0; i < plans.size(); ++i)
    if (plans[i]->closures.contains(0)) record_trial(state, *plans[i], chosen[i]);
}

void promote(ExplorationState& state, const std::vector<int>& trials, int to_rung) {
  std::vector<PlanEvaluations::Wanted> wanted;
  for (const int i : trials) {
    const Trial& trial = state.trials[i];
    for (int node = kRungs[trial.rung]; node < kRungs[std::max(to_rung, trial.rung)]; ++node)
      wanted.push_back({trial.record, node});
  }
  std::vector<PlanRecord*> plans;
  for (const int i : trials) plans.push_back(state.trials[i].record);
  if (!state.in.evaluations.open(plans, PlanEvaluations::Phase::Searching)) return;
  if (!state.in.evaluations.close(wanted, PlanEvaluations::Phase::Searching)) return;
  if (to_rung == kLastRung && asks_how_long(state) &&
      !close_disease(state.in.evaluations, plans, PlanEvaluations::Phase::Searching))
    return;
  for (const int i : trials) {
    Trial& trial = state.trials[i];
    trial.rung = std::max(to_rung, trial.rung);
    trial.expected = expectation(state, *trial.record, trial.rung);
    if (trial.rung == kLastRung && trial.expected.cost < state.branches[trial.branch].best_scored)
      record_scored(state, trial);
  }
  update_entry_cost(state);
}

}  // namespace coapt
