#include "search/plans/exploration.h"

#include <algorithm>
#include <limits>
#include <random>
#include <set>
#include <utility>

#include "search/parallel.h"
#include "search/random_share.h"

namespace coapt {
namespace {

constexpr int kStartBatch = 8;
constexpr int kFewPoints = 6;         // a branch of so many is tried whole
constexpr int kHalved = 16;           // branches in the first round of a bracket
constexpr int kQuota = 8;             // plans each, in the first round of a bracket
constexpr int kBoundShare = 4;        // one branch in so many is refined for its bound
constexpr int kPromoted = 2;          // plans promoted at once
constexpr int kPromotedInRound = 8;   // plans promoted after a round of a bracket
constexpr double kMoreScatter = 0.5;  // granted from bracket to bracket
constexpr double kFreely = 2.0;       // scatters granted where few nodes say little about more
constexpr int kRandomShare = 20;      // one of so many closures is spent on plans at random, up to
constexpr int kMostRandom = 100;
constexpr int kBracketsBefore = 2;  // them, where closures last: they are evidence, and help little
constexpr int kOfABracket = 1000;   // closures, about as many as it takes
constexpr int kLadderPlans = 12;    // plans on all rungs, where they take one of
constexpr int kLadderShare = 4;     // so many closures left, at most
constexpr std::uint64_t kGolden = 0x9e3779b97f4a7c15;  // keeps seeds of branches apart

double bound(const ExplorationState& state, const BranchPoint& point) {
  const Branch& branch = *state.branches[point.branch].search.branch;
  const PlanRecord& plan = state.in.evaluations.record(state.in.space.plan(branch, point.at));
  return is_infeasible(plan) ? kInfeasibleCost : plan.least_guide;
}

/// Cheapest operation first.
std::vector<BranchPoint> starts(const ExplorationState& state) {
  std::vector<std::pair<double, BranchPoint>> order;
  const auto add = [&](const BranchPoint& point) {
    order.emplace_back(bound(state, point), point);
  };
  for (int i = 0; i < std::ssize(state.branches); ++i) {
    const Branch& branch = *state.branches[i].search.branch;
    if (point_count(branch) <= kFewPoints) {
      for (std::int64_t number = 0; number < point_count(branch); ++number)
        add({i, point_at(branch, number)});
      continue;
    }
    const BranchPoint usual = {i, start_of(branch)};
    add(bound(state, usual) < kInfeasibleCost ? usual : BranchPoint{i, mildest_of(branch)});
  }
  std::stable_sort(order.begin(), order.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<BranchPoint> points;
  for (const auto& [cost, point] : order)
    if (std::ssize(points) < std::max(1, state.in.options.evaluations / 2)) points.push_back(point);
  return points;
}

/// Scores the trial that is expected to cost least, unless it leaks more as planned.
void promote_best(ExplorationState& state, double most_leak_mm2) {
  const auto best = std::min_element(
      state.trials.begin(), state.trials.end(),
      [](const Trial& a, const Trial& b) { return a.expected.cost < b.expected.cost; });
  if (best == state.trials.end() || best->rung == kLastRung ||
      evaluations_left(state) < promotion_closures(state, best->rung, kLastRung))
    return;
  if (best->record->closures.at(0).leak_mm2 > most_leak_mm2) return;
  promote(state, {static_cast<int>(best - state.trials.begin())}, kLastRung);
  refit_climb_models(state);
}

/// Trials that may yet beat what is to be beaten, likeliest first.
std::vector<int> promising(const ExplorationState& state, double scatters) {
  std::vector<int> order;
  for (int i = 0; i < std::ssize(state.trials); ++i) {
    const Trial& trial = state.trials[i];
    if (trial.rung < kLastRung &&
        ClimbModel::least(trial.expected, scatters) < cost_to_beat(state, trial.branch))
      order.push_back(i);
  }
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
    return state.trials[a].expected.cost < state.trials[b].expected.cost;
  });
  return order;
}

/// The best trial of each of the first `most` branches, as far as closures go.
std::vector<int> next_promotions(ExplorationState& state, const std::vector<int>& order, int most) {
  std::vector<int> chosen;
  int closures = 0;
  for (const int i : order) {
    const Trial& trial = state.trials[i];
    if (std::any_of(chosen.begin(), chosen.end(),
                    [&](int c) { return state.trials[c].branch == trial.branch; }))
      continue;
    closures += promotion_closures(state, trial.rung, trial.rung + 1);
    if (closures > evaluations_left(state)) {
      state.budget_short = true;
      break;
    }
    if (std::ssize(chosen) == most) break;
    chosen.push_back(i);
  }
  return chosen;
}

/// Promotes trials by one rung each, at most `most`, and refits the models.
void promote_promising(ExplorationState& state, int most, double scatters) {
  for (int done = 0; done < most && !is_over(state);) {
    const std::vector<int> chosen =
        next_promotions(state, promising(state, scatters), std::min(kPromoted, most - done));
    if (chosen.empty()) break;
    const int before = state.in.evaluations.closures();
    for (int rung = kLastRung; rung > 0; --rung) {  // from above: one step each
      std::vector<int> here;
      for (const int i : chosen)
        if (state.trials[i].rung + 1 == rung) here.push_back(i);
      promote(state, here, rung);
    }
    if (state.in.evaluations.closures() == before) break;  // stopped
    done += static_cast<int>(chosen.size());
  }
  refit_climb_models(state);
}

/// Branches that have been tried, the best first.
std::vector<int> branches_by_cost(const ExplorationState& state) {
  std::vector<int> order;
  for (int i = 0; i < std::ssize(state.branches); ++i)
    if (!state.branches[i].search.costs.empty()) order.push_back(i);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
    return state.branches[a].search.best_cost < state.branches[b].search.best_cost;
  });
  return order;
}

/// Those of them in which a better plan may yet be found.
std::vector<int> open_branches(const ExplorationState& state) {
  std::vector<int> order = branches_by_cost(state);
  std::erase_if(order, [&](int i) {
    const BranchState& branch = state.branches[i];
    return is_exhausted(branch.search) || branch.is_idle ||
           branch.lowest_cost >= cost_to_beat(state, i);
  });
  return order;
}

/// The best open branches, and of the others those with the lowest bounds.
std::vector<int> branches_to_refine(const ExplorationState& state, int count) {
  const std::vector<int> likely = open_branches(state);
  std::vector<int> possible = likely, chosen;
  std::stable_sort(possible.begin(), possible.end(), [&](int a, int b) {
    return state.branches[a].lowest_cost < state.branches[b].lowest_cost;
  });
  const auto fill = [&](const std::vector<int>& order, int upto) {
    for (const int i : order)
      if (std::ssize(chosen) < upto && std::find(chosen.begin(), chosen.end(), i) == chosen.end())
        chosen.push_back(i);
  };
  fill(likely, count - count / kBoundShare);
  fill(possible, count);
  return chosen;
}

/// A plan closed as planned at a point of a branch.
using Found = std::pair<PlanRecord*, LatticePoint>;

/// Refines one branch; changes nothing of the state but that branch's search.
std::vector<Found> refine_branch(ExplorationState& state, int i, int quota) {
  std::vector<Found> found;
  const TryPoint try_point = [&](const Branch& branch,
                                 const LatticePoint& at) -> std::optional<PointCost> {
    PlanRecord& plan = state.in.evaluations.record(state.in.space.plan(branch, at));
    if (is_infeasible(plan)) return PointCost{kInfeasibleCost, 0, true};
    if (plan.least_guide >= cost_to_beat(state, i)) return PointCost{plan.least_guide, 0, true};
    const bool is_new = !plan.closures.contains(0);
    if (!state.in.evaluations.close_here(plan, 1)) return std::nullopt;
    found.emplace_back(&plan, at);
    return PointCost{expectation(state, plan, 0).cost, is_new ? 1 : 0, false};
  };
  const std::uint64_t seed = state.in.options.seed + static_cast<std::uint64_t>(i) * kGolden;
  refine(state.branches[i].search, quota, seed, try_point);
  return found;
}

void refine_branches(ExplorationState& state, int count, int quota) {
  const std::vector<int> chosen = branches_to_refine(state, count);
  if (chosen.empty()) return;
  const int each = std::min(quota, evaluations_left(state) / static_cast<int>(chosen.size()));
  if (each < 1) {
    state.budget_short = true;
    return;
  }
  std::vector<std::vector<Found>> found(chosen.size());
  for_each_index(static_cast<int>(chosen.size()), state.in.options.threads,
                 [&](int k) { found[k] = refine_branch(state, chosen[k], each); });
  for (std::size_t k = 0; k < chosen.size(); ++k) {
    state.branches[chosen[k]].is_idle = found[k].empty();
    for (const auto& [plan, at] : found[k]) record_trial(state, *plan, {chosen[k], at});
  }
}

/// One bracket: half as many branches in each round, with twice the quota.
void successive_halving(ExplorationState& state) {
  int quota = kQuota;
  for (int count = kHalved; count >= 2 && !is_over(state); count /= 2, quota *= 2) {
    refine_branches(state, count, quota);
    promote_promising(state, kPromotedInRound, 1.0);
  }
}

void share_across_branches(ExplorationState& state) {
  std::vector<int> best = branches_by_cost(state);
  best.resize(std::min(best.size(), static_cast<std::size_t>(compared_plans(state.in.options))));
  std::vector<BranchPoint> points;
  for (const int from : best)
    for (int to = 0; to < std::ssize(state.branches); ++to) {
      const BranchSearch &a = state.branches[from].search, &b = state.branches[to].search;
      if (differences(a.branch->choice, b.branch->choice) != 1) continue;
      const LatticePoint at = nearest_point(*a.branch, a.best, *b.branch);
      if (!b.costs.contains(at)) points.push_back({to, at});
    }
  try_points(state, points);
}

void try_at_random(ExplorationState& state, int count) {
  const std::vector<BranchPoint> points = random_points(state, count);
  std::vector<PlanEvaluations::Wanted> wanted;
  std::vector<PlanRecord*> plans;
  for (const auto& [branch, at] : points) {
    plans.push_back(&state.in.evaluations.record(
        state.in.space.plan(*state.branches[branch].search.branch, at)));
    if (!is_infeasible(*plans.back()) && !plans.back()->closures.contains(0))
      wanted.push_back({plans.back(), 0});
  }
  if (!state.in.evaluations.close(wanted, PlanEvaluations::Phase::Searching)) return;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (is_infeasible(*plans[i])) continue;
    state.random_plans.push_back(plans[i]);
    record_trial(state, *plans[i], points[i]);
  }
  std::vector<double> costs;
  for (const Progress& expected : random_progress(state)) costs.push_back(expected.cost);
  state.in.monitor.expect_of_random(std::move(costs));
}

/// The better half of the plans tried at random, best first. Not those promoted before: the models
/// have learnt from them.
std::vector<int> ladder_candidates(const ExplorationState& state) {
  std::vector<const PlanRecord*> order = state.random_plans;
  std::stable_sort(order.begin(), order.end(), [&](const PlanRecord* a, const PlanRecord* b) {
    return state.in.evaluations.guide(*a, 1) < state.in.evaluations.guide(*b, 1);
  });
  std::vector<int> candidates;
  std::set<const PlanRecord*> seen;
  for (const PlanRecord* plan : order)
    if (const int i = state.trial_of.at(plan);
        seen.insert(plan).second && state.trials[i].rung == 0)
      candidates.push_back(i);
  candidates.resize(candidates.size() / 2);
  return candidates;
}

void measure_ladder(ExplorationState& state) {
  const std::vector<int> candidates = ladder_candidates(state);
  const int count = static_cast<int>(candidates.size());
  if (count < kLadderPlans || evaluations_left(state) < kLadderShare * kLadderPlans *
                                                            promotion_closures(state, 0, kLastRung))
    return;
  std::vector<int> chosen;
  for (int k = 0; k < kLadderPlans; ++k) {
    chosen.push_back(candidates[k * count / kLadderPlans]);
    state.ladder_expected.push_back(state.trials[chosen.back()].expected.cost);
  }
  promote(state, chosen, kLastRung);
  refit_climb_models(state);
  if (state.trials[chosen.front()].rung < kLastRung) return;  // stopped
  for (const int i : chosen) state.ladder_plans.push_back(state.trials[i].record);
}

/// Once.
void try_random_plans(ExplorationState& state) {
  if (!state.random_plans.empty() || is_over(state)) return;
  try_at_random(state, std::min({kMostRandom, state.in.options.evaluations / kRandomShare,
                                 evaluations_left(state)}));
  measure_ladder(state);
}

}  // namespace

ExplorationState explore(const ExplorationInput& input) {
  ExplorationState state = make_state(input);
  const PlanEvaluations& evaluations = input.evaluations;
  const std::vector<BranchPoint> points = starts(state);
  for (auto next = points.begin(); next != points.end() && !is_over(state);) {
    const auto end = next + std::min<std::ptrdiff_t>(kStartBatch, points.end() - next);
    try_points(state, {next, end});
    promote_best(state, kMildLeak_mm2);
    next = end;
  }
  if (!is_over(state)) promote_best(state, std::numeric_limits<double>::infinity());
  double scatters = 1.0;
  for (int bracket = 1; !open_branches(state).empty() && !is_over(state);
       ++bracket, scatters += kMoreScatter) {
    const int before = evaluations.closures();
    if (bracket > kBracketsBefore || evaluations_left(state) < kOfABracket) try_random_plans(state);
    successive_halving(state);
    if (open_branches(state).empty()) try_random_plans(state);
    if (!is_over(state)) share_across_branches(state);
    if (!is_over(state)) promote_promising(state, std::numeric_limits<int>::max(), scatters);
    if (ladder_of(state)[1].skipped) scatters = std::max(scatters, kFreely);
    if (state.budget_short && before == evaluations.closures()) break;
  }
  if (!is_over(state) && !state.budget_short) state.stop = SearchStop::Exhausted;
  if (!state.progress.empty() && state.progress.back().closures < evaluations.closures())
    state.progress.push_back({evaluations.closures(), state.progress.back().cost});
  return state;
}

std::vector<PlanRecord*> best_plans(const ExplorationState& state, int count) {
  std::vector<const Trial*> order;
  for (const Trial& trial : state.trials) order.push_back(&trial);
  std::stable_sort(order.begin(), order.end(), [](const Trial* a, const Trial* b) {
    if (a->rung != b->rung) return a->rung > b->rung;
    return a->expected.cost < b->expected.cost;
  });
  std::set<int> seen;
  std::stable_partition(order.begin(), order.end(),
                        [&](const Trial* trial) { return seen.insert(trial->branch).second; });
  std::vector<PlanRecord*> plans;
  for (const Trial* trial : order)
    if (std::ssize(plans) < count) plans.push_back(trial->record);
  return plans;
}

std::vector<const PlanRecord*> scored_plans(const ExplorationState& state) {
  std::vector<const PlanRecord*> plans;
  for (const Trial& trial : state.trials)
    if (trial.rung == kLastRung) plans.push_back(trial.record);
  return plans;
}

std::vector<BranchPoint> random_points(const ExplorationState& state, int count) {
  std::vector<std::int64_t> upto;
  std::int64_t all = 0;
  for (const BranchState& branch : state.branches)
    upto.push_back(all += point_count(*branch.search.branch));
  std::mt19937_64 engine(state.in.options.seed);
  std::vector<BranchPoint> points;
  for (int i = 0; i < count; ++i) {
    const auto number = static_cast<std::int64_t>(random_share(engine) * static_cast<double>(all));
    const auto branch =
        static_cast<int>(std::upper_bound(upto.begin(), upto.end(), number) - upto.begin());
    const Branch& of = *state.branches[branch].search.branch;
    points.push_back({branch, point_at(of, number - upto[branch] + point_count(of))});
  }
  return points;
}

std::vector<Progress> random_progress(const ExplorationState& state) {
  std::vector<double> costs;
  for (const PlanRecord* plan : state.random_plans)
    costs.push_back(state.in.evaluations.guide(*plan, 1));
  std::sort(costs.begin(), costs.end());
  const int n = static_cast<int>(costs.size());
  std::vector<Progress> expected;
  for (int drawn = 1; drawn <= n; ++drawn) {
    // The chance that the k-th cheapest is the cheapest of those drawn.
    double mean = 0.0, chance = static_cast<double>(drawn) / n;
    for (int k = 0; k + drawn <= n; ++k) {
      mean += chance * costs[k];
      chance *= static_cast<double>(n - drawn - k) / (n - 1 - k);
    }
    expected.push_back({drawn, mean});
  }
  return expected;
}

std::vector<LadderStep> ladder_of(const ExplorationState& state) {
  const auto costs = [&](const std::vector<const PlanRecord*>& plans, int nodes) {
    std::vector<double> at;
    for (const PlanRecord* plan : plans)
      at.push_back(nodes == 0 ? plan->least_guide : state.in.evaluations.guide(*plan, nodes));
    return at;
  };
  std::vector<LadderStep> steps = {measure_ladder_step(0, kRungs[0], costs(state.random_plans, 0),
                                                       costs(state.random_plans, kRungs[0]))};
  for (int r = 0; r < kLastRung; ++r) {
    const std::vector<const PlanRecord*>& plans = state.ladder_plans;
    const bool is_expected =
        r == 0;  // plans are promoted from there by what they are expected to cost
    std::vector<double> few = is_expected ? state.ladder_expected : costs(plans, kRungs[r]);
    few.resize(plans.size());
    steps.push_back(
        measure_ladder_step(kRungs[r], kRungs[r + 1], few, costs(plans, kRungs[r + 1])));
  }
  return steps;
}

}  // namespace coapt
