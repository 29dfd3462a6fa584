// Looks for good plans, from few closures a plan to many.
//
// 1. Starts: what practice would try first in every branch, and every size where that is all there is to decide,
//    cheapest operation first, one closure each; after every eight the best climbs to 17 nodes at once.
// 2. Brackets of successive halving: the best eight branches refine their lattices with equal quotas, the
//    better half goes on with twice as much, and so to two. One of four is there for its bound, not for
//    what it has shown.
// 3. After each round the race: a plan climbs from 1 to 5 to 17 nodes of the region as long as what it is
//    expected to cost there (climb_model.h), less the scatter of such guesses, is below what is to be beaten.
//    From bracket to bracket more scatter is granted.
// 4. The best plans lend their sizes and movements to the branches that differ in one decision.
// 5. Once: plans at random, for random search's line, and twelve of their better half on all rungs: how far the few
//    nodes, with the expectation, rank plans as the many do. Below 0.8 plans climb more freely. (To start all plans at
//    five nodes then was slower: 1,808 closures instead of 1,417 to the best of a lattice within 0.1 mm2.)
// What the operation alone costs bounds a plan from below: a point whose bound is not below what is to be beaten is
// left out unclosed. Plans on different rungs are compared by what they are expected to cost; finalists over equal
// nodes.
//
// Every quota is fixed before it is spent, and batches have sizes of their own: no decision depends on the
// number of threads.
#pragma once

#include <vector>

#include "search/plans/branch_search.h"
#include "search/plans/climb_model.h"
#include "search/plans/plan_desk.h"
#include "search/plans/plan_search.h"

namespace coapt {

/// Nodes of the region by which plans are chosen before they are finalists.
inline constexpr int kRungs[] = {1, 5, 17};
inline constexpr int kChosenBy = 17;

class Exploration {
 public:
  Exploration(PlanDesk& desk, const PlanSpace& space, const SearchOptions& options, Watch& watch);

  void run();

  /// Plans with the most nodes closed first, then the cheapest; the best of each branch before the second of
  /// any. At most `count`.
  std::vector<PlanRecord*> best(int count) const;

  /// The best cost so far at one node, and at kChosenBy.
  const std::vector<Progress>& progress() const { return progress_; }
  const std::vector<Progress>& scored_progress() const { return scored_progress_; }
  std::vector<Progress> random_progress() const;
  std::vector<LadderStep> ladder() const;
  int plans_tried() const { return static_cast<int>(tried_.size()); }
  /// All plans closed at kChosenBy nodes, in the order of trying.
  std::vector<const PlanRecord*> scored() const;
  SearchStop stop() const { return stop_; }

 private:
  struct Point {
    std::size_t branch = 0;
    LatticePoint at;
  };
  struct Tried {
    PlanRecord* record = nullptr;
    std::size_t branch = 0;
    std::vector<LatticePoint> at;      // all points that are this plan
    int rung = 0;                      // index into kRungs of the nodes closed
    ClimbModel::Expectation expected;  // at the next rung; at the last: as it is
  };

  static constexpr double kOut = 1e6;   // instead of a cost, for plans that cannot be done
  static constexpr int kRaceBatch = 4;  // plans that climb at once

  int left() const;
  bool over();
  double to_beat(std::size_t branch) const;
  void update_to_beat();
  ClimbModel::Expectation expected(const PlanRecord& record, int rung) const;
  void learn();
  std::vector<Point> make_starts();
  void try_points(const std::vector<Point>& points);
  void try_random(int count);
  void measure_ladder();
  void take(PlanRecord& record, const Point& point);
  void climb(const std::vector<std::size_t>& climbing, int to_rung);
  void sprint();
  void race(int most, double optimism);
  void refine_best(int count, int quota);
  void lend();
  std::vector<std::size_t> by_cost() const;

  PlanDesk& desk_;
  const PlanSpace& space_;
  const SearchOptions& options_;
  Watch& watch_;
  std::vector<BranchSearch> searches_;  // as the space's branches
  std::vector<double> lowest_;          // bound of each branch
  std::vector<double> best_scored_;     // of each branch, at kChosenBy nodes
  double enter_ = 0.0;                  // what a new branch must beat to be reported
  std::vector<ClimbModel> climbs_;      // from each rung
  std::vector<Tried> tried_;
  std::unordered_map<const PlanRecord*, std::size_t> index_;  // into tried_
  std::vector<const PlanRecord*> random_;                     // plans tried at random
  std::vector<const PlanRecord*> measured_;                   // of those: closed on all rungs
  std::vector<double> guessed_;  // their cost at the second rung, beforehand
  std::vector<Progress> progress_, scored_progress_;
  int improved_at_ = 0;     // closures
  std::vector<bool> idle_;  // branches whose refinement came upon nothing new
  bool short_ = false;      // something was left out for want of closures
  SearchStop stop_ = SearchStop::EvaluationLimit;
};

}  // namespace coapt
