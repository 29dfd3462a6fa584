// Plans, closed and priced: each under each disturbance once, on all threads, known again the next
// time.
//
// A disturbed closure starts from where those of the plan's frame (disturbance_frame.h) let it be
// expected, or, where they do not, from that of the plan as planned (a warm start: half the time;
// over 64 nodes of nine repairs the means differ by 0.00 to 0.06 mm2, of a flail leaflet by 0.19).
// What is kept of a closure is its PlanClosure; those of the frame and the plan as planned stay with
// the last few hundred plans, and are made again from the plan, to the same bits, where they are
// needed later.
#pragma once

#include <atomic>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <span>
#include <string>
#include <unordered_map>

#include "search/evaluator.h"
#include "search/plans/disturbance.h"
#include "search/plans/objective.h"
#include "search/plans/plan_opening.h"
#include "search/plans/search_monitor.h"

namespace coapt {

/// By index of disturbance.
using PlanClosures = std::map<int, PlanClosure>;
/// By plan_key().
using KnownPlans = std::unordered_map<std::string, PlanClosures>;
using KnownOpenings = std::unordered_map<std::string, PlanOpening>;

/// A plan with what has been closed of it.
struct PlanRecord {
  RepairPlan plan;
  std::string key;
  bool possible = true;     ///< apply_plan() accepts it; else it has no closures and no effort
  std::string rejected_by;  ///< the first rule of operation_gates() that rejects it; empty: none
  Effort effort;
  int muscles = 0;             ///< that its sutures move
  int free_anchors = 0;        ///< of its sutures: not at the trigone or the saddle peak
  int resections = 0;          ///< of leaflets
  int avoidable_warnings = 0;  ///< of operation_gates()
  double lowest_cost = 0.0;    ///< effort_price(): a bound from below
  double least_guide = 0.0;    ///< likewise of PlanEvaluations::guide()
  Eigen::VectorXd place;       ///< where it puts the valve, see place_of()
  /// The repaired valve, kept where it takes long to make: sewing up a resection takes as long as ten closures.
  std::shared_ptr<const Valve> sewn{};
  PlanClosures closures;  ///< asked for in this run
  std::optional<PlanOpening> opening{};
};

/// A plan that cannot be done, or that practice rejects.
bool is_infeasible(const PlanRecord& record);

/// Where a plan leaves annulus, tips and chordae, each in units over which a leak changes a little:
/// plans at nearby places leak alike. The same length for all plans of a valve.
Eigen::VectorXd place_of(const Valve& repaired, const RepairPlan& plan);

struct PlanEvaluationOptions {
  int threads = 0;   ///< 0: all cores; does not change any answer
  KnownPlans known;  ///< of this valve and these closure options, from an earlier run
  /// Told of each closure as it ends, from one thread at a time. What it throws ends close().
  std::function<void(const std::string& key, int disturbance, const PlanClosure&)> keep;
  CostWeights weights;
  bool guide_by_price = false;
  Opener open{};  ///< empty: open() does nothing
  /// Steps that were decided elsewhere: what rejects them rejects no plan any more.
  RepairPlan fixed{};
  KnownOpenings known_openings{};  ///< by plan_key()
};

class PlanEvaluations {
 public:
  PlanEvaluations(const Evaluator& evaluate, const Valve& valve, PlanEvaluationOptions options,
                  SearchMonitor& monitor);

  /// The unrepaired valve, closed at once.
  const Evaluation& before() const { return before_.evaluation; }
  const ClosedPlan& closed_before() const { return before_; }
  /// Why the valve leaks; before plans are compared.
  void tell(const Diagnosis& diagnosis);
  /// That were not planned (SearchProgress::closures_planned).
  void expect_more(int closures) { monitor_.plan_more(closures); }
  /// Its leaflets are tethered, for sure, and none prolapses.
  bool tethered() const { return tethered_; }
  /// They are not tethered, for sure.
  bool untethered() const { return untethered_; }
  const CostContext& context() const { return context_; }
  const Valve& valve() const { return valve_; }
  int threads() const { return options_.threads; }
  bool cancelled() const { return monitor_.cancelled(); }

  /// apply_plan() of a possible plan.
  Valve repaired(const PlanRecord& plan) const;

  /// Any valve, closed and measured; neither counted nor kept. From any thread.
  ClosedPlan evaluate(const Valve& valve, const ClosureResult* neighbour) const {
    return evaluate_(valve, neighbour);
  }

  /// The plan's record, made if it is new; stays where it is as long as this object. From any
  /// thread.
  PlanRecord& record(const RepairPlan& plan);

  struct Wanted {
    PlanRecord* plan = nullptr;
    int disturbance = 0;
  };
  /// While searching, part of a time limit is kept for ranking.
  enum class Phase { Searching, Ranking };
  /// Closes what is not closed yet. False if it was stopped before all were: some are missing.
  bool close(std::span<const Wanted> wanted, Phase phase);
  /// The same, of one plan under the first `count` disturbances, in order, by the calling thread
  /// alone.
  bool close_here(PlanRecord& plan, int count);

  bool opens() const { return static_cast<bool>(options_.open); }
  /// Opens what is not opened yet; a plan's cost counts it from the second node on. False if it was stopped before all were.
  bool open(std::span<PlanRecord* const> plans, Phase phase);
  /// Any valve; none without an opener. Neither counted nor kept. From any thread.
  std::optional<PlanOpening> opened(const Valve& valve) const;

  /// Plans of which a gate (gates.h) rejects, and on how many each: what a search left out.
  std::map<std::string, int> rejections() const;
  /// Over the first `count` nodes of the region. @pre they are closed, or the plan is impossible.
  CostTerms terms(const PlanRecord& plan, int count) const;
  double cost(const PlanRecord& plan, int count) const;
  /// What a search climbs by (guide.h); by price, the cost.
  double guide(const PlanRecord& plan, int count) const;
  /// By how much a millimetre of papillary movement raises it.
  double movement_guide() const;

  /// The plan as planned, closed again if need be (not counted).
  ClosedPlan closed(const PlanRecord& plan);
  /// The same, disturbed; from any thread.
  ClosedPlan closed(const PlanRecord& plan, int disturbance);

  /// Asked for: closed now, or known; of the valve as it is, too.
  int closures() const { return closures_; }
  int known() const { return known_; }        ///< of those: from an earlier run
  int openings() const { return openings_; }  ///< asked for: made now, or known
  int not_converged() const { return not_converged_; }
  int crossed() const { return crossed_; }

 private:
  struct State {
    Valve repaired;
    ClosedPlan closed;
    /// Of its frame, by index of disturbance; null if the evaluator keeps none.
    std::map<int, std::shared_ptr<const ClosureResult>> frame{};
  };
  /// A closure to make: asked for, or for others to start from.
  struct Task {
    PlanRecord* plan = nullptr;
    int disturbance = 0;
    bool wanted = true;
    int level = 0;  ///< frame_level(); where the plan makes no frame, all but itself start from it
  };
  std::shared_ptr<State> state_of(const PlanRecord& plan);
  static bool has_frame(const State& state);
  std::vector<Task> with_frames(std::span<const Wanted> missing);
  std::shared_ptr<const ClosureResult> closure_of(const PlanRecord& plan, State& state,
                                                  int disturbance);
  ClosedPlan close_disturbed(const PlanRecord& plan, State& state, int disturbance);
  bool take_known(PlanRecord& plan, int disturbance);
  void close_one(PlanRecord& plan, int disturbance);
  bool stopped(Phase phase) const;
  void add(PlanRecord& plan, int disturbance, const PlanClosure& closure, bool was_known);

  const Evaluator& evaluate_;
  std::set<std::string> tolerated_;  // rules
  Valve valve_;
  LeafletCoordinates coordinates_;  // of it
  PlanEvaluationOptions options_;
  SearchMonitor& monitor_;
  ClosedPlan before_;
  double leaflet_ratio_before_;  // PlanClosure::leaflet_ratio
  bool tethered_ = false, untethered_ = false;
  CostContext context_;

  Mutex mutex_;
  std::atomic<bool> failed_ = false;  // a closure could not be kept: make no more
  std::unordered_map<std::string, std::unique_ptr<PlanRecord>> records_;
  std::unordered_map<const PlanRecord*, std::shared_ptr<State>> states_;
  std::deque<const PlanRecord*> newest_states_;
  int closures_ = 0, known_ = 0, not_converged_ = 0, crossed_ = 0;
  std::atomic<int> openings_ = 0;
};

}  // namespace coapt
