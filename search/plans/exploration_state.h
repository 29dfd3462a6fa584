// What an exploration knows between its rounds: the plans tried and the rung that each has reached,
// the search of each branch, and what is to be beaten.
#pragma once

#include <limits>
#include <unordered_map>
#include <vector>

#include "search/plans/branch_search.h"
#include "search/plans/climb_model.h"
#include "search/plans/ladder.h"
#include "search/plans/plan_evaluations.h"
#include "search/plans/search_options.h"
#include "search/plans/search_progress.h"

namespace coapt {

struct ExplorationInput {
  PlanEvaluations& evaluations;
  const PlanSpace& space;
  const SearchOptions& options;
  SearchMonitor& monitor;
};

/// A point of one branch's lattice.
struct BranchPoint {
  int branch = 0;
  LatticePoint at;
};

/// A plan that was closed.
struct Trial {
  PlanRecord* record = nullptr;
  int branch = 0;
  /// All points that are this plan.
  std::vector<LatticePoint> at;
  /// Index into kRungs of the nodes closed.
  int rung = 0;
  /// At the next rung; at the last: as it is.
  ClimbModel::Expectation expected;
};

struct BranchState {
  static constexpr double kUnknown = std::numeric_limits<double>::infinity();

  BranchSearch search;
  /// No plan of the branch costs less.
  double lowest_cost = 0.0;
  /// At kChosenBy nodes.
  double best_scored = kUnknown;
  /// Whether its last refinement came upon no new plan.
  bool is_idle = false;
};

struct ExplorationState {
  ExplorationInput in;
  std::vector<BranchState> branches{};     ///< as the space's
  std::vector<ClimbModel> climb_models{};  ///< from each rung to the next
  std::vector<Trial> trials{};
  std::unordered_map<const PlanRecord*, int> trial_of{};
  /// What a branch without a scored plan must beat to be reported.
  double entry_cost = BranchState::kUnknown;

  /// Plans tried at random; of those, closed on all rungs, with what each was expected to cost at
  /// the second beforehand.
  std::vector<const PlanRecord*> random_plans{}, ladder_plans{};
  std::vector<double> ladder_expected{};

  /// The best cost so far at one node, and at kChosenBy.
  std::vector<Progress> progress{}, scored_progress{};
  /// Closures when either improved last.
  int improved_at = 0;
  /// Something was left out for want of closures.
  bool budget_short = false;
  SearchStop stop = SearchStop::EvaluationLimit;
};

/// Instead of a cost, for plans that cannot be done.
inline constexpr double kInfeasibleCost = 1e6;

ExplorationState make_state(const ExplorationInput& input);

int evaluations_left(const ExplorationState& state);

/// Closures that promotion from one rung to another takes, at most. At the last rung plans are asked how long they last, too, unless the
/// search has no evidence or ranks by price.
int promotion_closures(const ExplorationState& state, int from_rung, int to_rung);

/// Whether to try nothing more; sets state.stop unless it is for want of closures.
bool is_over(ExplorationState& state);

/// What a plan of that branch must be expected to cost less than to be worth closures.
double cost_to_beat(const ExplorationState& state, int branch);

/// At the next rung. @pre closed at kRungs[rung].
ClimbModel::Expectation expectation(const ExplorationState& state, const PlanRecord& plan,
                                    int rung);

/// Fits the climb models to all plans that have climbed, and revises by them what each trial is
/// expected to cost.
void refit_climb_models(ExplorationState& state);

/// Adds a plan that was closed as planned, or the point, if the plan is known.
void record_trial(ExplorationState& state, PlanRecord& plan, const BranchPoint& point);

/// Closes plans as planned, but for those that are infeasible or whose operation alone is too dear.
void try_points(ExplorationState& state, const std::vector<BranchPoint>& points);

/// Closes trials at all nodes up to a rung. None of them is promoted if that is stopped.
void promote(ExplorationState& state, const std::vector<int>& trials, int to_rung);

}  // namespace coapt
