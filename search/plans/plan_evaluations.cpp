#include "search/plans/plan_evaluations.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <set>
#include <utility>

#include "core/closure/predicted_start.h"
#include "core/repair/apply_plan.h"
#include "core/repair/approximation.h"
#include "core/valve/annulus_frame.h"
#include "search/parallel.h"
#include "search/plans/disturbance_frame.h"
#include "search/plans/durability.h"
#include "search/plans/gates.h"
#include "search/plans/guide.h"
#include "search/plans/ladder.h"
#include "search/plans/plan_key.h"

namespace coapt {
namespace {

constexpr std::size_t kStates = 256;  // closures kept to start others from; 0.1 MB each

// Millimetres and shares that count as one unit of place_of().
constexpr double kAnnulusUnit_mm = 2.0, kTipUnit_mm = 2.0, kLengthUnit_mm = 2.0;
constexpr double kAlongUnit = 0.07;
constexpr double kOtherKind = 10.0;  // apart: nothing in common
constexpr Eigen::Index kMostNeochordae = 4;

OperationMerits operation_of(const PlanRecord& plan) {
  return {plan.effort, plan.muscles, plan.free_anchors, plan.resections, plan.avoidable_warnings};
}

}  // namespace

bool is_infeasible(const PlanRecord& record) {
  return !record.possible || !record.rejected_by.empty();
}

Eigen::VectorXd place_of(const Valve& repaired, const RepairPlan& plan) {
  Eigen::VectorXd place = Eigen::VectorXd::Zero(10 + 2 * kMostNeochordae);
  place[0] = ap_diameter_mm(repaired) / kAnnulusUnit_mm;
  place[1] = transverse_diameter_mm(repaired) / kAnnulusUnit_mm;
  place.segment<3>(2) = papillary_tip_mm(repaired, Side::Anterolateral) / kTipUnit_mm;
  place.segment<3>(5) = papillary_tip_mm(repaired, Side::Posteromedial) / kTipUnit_mm;
  Eigen::Index neochordae = 0, chordal = 0;
  for (const RepairStep& step : plan.steps) {
    if (const auto* neochorda = std::get_if<Neochorda>(&step)) {
      if (neochordae++ >= kMostNeochordae) continue;
      place[8 + 2 * neochordae] = neochorda->length_mm / kLengthUnit_mm;
      place[9 + 2 * neochordae] = neochorda->insertion.along / kAlongUnit;
    } else if (const auto* change = std::get_if<ChordalLengthChange>(&step)) {
      place[9] += kOtherKind + change->change_mm / kLengthUnit_mm;
    } else if (!std::holds_alternative<Annuloplasty>(step) &&
               !std::holds_alternative<PapillaryApproximation>(step)) {
      ++chordal;
    }
  }
  place[8] = kOtherKind * static_cast<double>(neochordae);
  place[9] += kOtherKind * static_cast<double>(chordal);
  return place;
}

PlanEvaluations::PlanEvaluations(const Evaluator& evaluate, const Valve& valve,
                                 PlanEvaluationOptions options, SearchMonitor& monitor)
    : evaluate_(evaluate),
      valve_(valve),
      coordinates_(leaflet_coordinates(valve)),
      options_(std::move(options)),
      monitor_(monitor),
      before_(evaluate(valve, nullptr)),
      leaflet_ratio_before_(plan_closure(before_.evaluation).leaflet_ratio) {
  context_ = {valve.tissue.thickness_mm, before().measure.tension_max_n, options_.weights};
  if (!trusted(before())) context_.tension_before_n = std::numeric_limits<double>::infinity();
  const Expected<Valve> fixed = apply_plan(valve, options_.fixed, coordinates_);
  if (fixed)
    for (const Gate& gate : operation_gates({options_.fixed, valve_, *fixed}))
      if (gate.severity == GateSeverity::Reject) tolerated_.insert(gate.rule);
  closures_ = 1;
  not_converged_ = before().status != ClosureStatus::Converged;
  crossed_ = before().crossing;
  monitor_.closed(std::numeric_limits<double>::infinity());
}

PlanRecord& PlanEvaluations::record(const RepairPlan& plan) {
  const std::string key = plan_key(plan);
  {
    const Lock lock(mutex_);
    if (const auto found = records_.find(key); found != records_.end()) return *found->second;
  }
  auto made = std::make_unique<PlanRecord>();
  made->plan = plan;
  made->key = key;
  const Expected<Valve> repaired = apply_plan(valve_, plan, coordinates_);
  made->possible = bool(repaired);
  if (repaired) {
    made->effort = effort(valve_, *repaired, plan);
    made->place = place_of(*repaired, plan);
    const std::vector<Gate> gates = operation_gates({plan, valve_, *repaired, untethered_});
    for (const Gate& gate : gates)
      if (gate.severity == GateSeverity::Reject && made->rejected_by.empty() &&
          !tolerated_.contains(gate.rule))
        made->rejected_by = gate.rule;
    for (const Side side : {Side::Anterolateral, Side::Posteromedial})
      if (const PapillaryApproximation* const suture = suture_of(plan, side)) {
        ++made->muscles;
        made->free_anchors += suture->anchor == Anchor::AnnulusPoint;
      }
    for (const RepairStep& step : plan.steps)
      made->resections += std::holds_alternative<LeafletResection>(step);
    if (made->resections > 0) made->sewn = std::make_shared<const Valve>(*repaired);
    made->avoidable_warnings = avoidable_warnings(gates);
    made->lowest_cost = effort_price(made->effort, options_.weights);
    made->least_guide =
        options_.guide_by_price ? made->lowest_cost : least_guide(operation_of(*made));
  }
  const Lock lock(mutex_);
  return *records_.try_emplace(key, std::move(made)).first->second;
}

Valve PlanEvaluations::repaired(const PlanRecord& plan) const {
  return plan.sewn ? *plan.sewn : *apply_plan(valve_, plan.plan, coordinates_);
}

std::shared_ptr<PlanEvaluations::State> PlanEvaluations::state_of(const PlanRecord& plan) {
  {
    const Lock lock(mutex_);
    if (const auto found = states_.find(&plan); found != states_.end()) return found->second;
  }
  auto state = std::make_shared<State>();
  state->repaired = repaired(plan);
  state->closed = evaluate_(state->repaired, nullptr);
  const Lock lock(mutex_);
  const auto [entry, is_new] = states_.try_emplace(&plan, state);
  if (is_new) {
    newest_states_.push_back(&plan);
    if (newest_states_.size() > kStates) {
      states_.erase(newest_states_.front());
      newest_states_.pop_front();
    }
  }
  return state;
}

ClosedPlan PlanEvaluations::closed(const PlanRecord& plan) { return state_of(plan)->closed; }

ClosedPlan PlanEvaluations::closed(const PlanRecord& plan, int disturbance) {
  return close_disturbed(plan, *state_of(plan), disturbance);
}

void PlanEvaluations::add(PlanRecord& plan, int disturbance, const PlanClosure& closure,
                          bool was_known) {
  plan.closures.emplace(disturbance, closure);
  ++closures_;
  known_ += was_known;
  not_converged_ += closure.status != ClosureStatus::Converged;
  crossed_ += closure.crossing;
  if (!was_known && options_.keep) {
    Thrown unkept;
    failed_ = failed_ || !unkept.returns([&] { options_.keep(plan.key, disturbance, closure); });
    unkept.rethrow();  // not before: other threads look
  }
  monitor_.closed(disturbance == 0 && trusted(closure) ? closure.leak_mm2
                                                       : std::numeric_limits<double>::infinity());
}

bool PlanEvaluations::take_known(PlanRecord& plan, int disturbance) {
  const Lock lock(mutex_);
  if (plan.closures.contains(disturbance)) return true;
  const auto known = options_.known.find(plan.key);
  if (known == options_.known.end()) return false;
  const auto closure = known->second.find(disturbance);
  if (closure == known->second.end()) return false;
  add(plan, disturbance, closure->second, true);
  return true;
}

bool PlanEvaluations::has_frame(const State& state) {
  return state.closed.closure != nullptr && trusted(*state.closed.closure);
}

std::shared_ptr<const ClosureResult> PlanEvaluations::closure_of(const PlanRecord& plan,
                                                                 State& state, int disturbance) {
  if (disturbance == 0) return state.closed.closure;
  {
    const Lock lock(mutex_);
    if (const auto found = state.frame.find(disturbance); found != state.frame.end())
      return found->second;
  }
  return close_disturbed(plan, state, disturbance).closure;
}

ClosedPlan PlanEvaluations::close_disturbed(const PlanRecord& plan, State& state, int disturbance) {
  if (disturbance == 0) return state.closed;
  std::vector<std::shared_ptr<const ClosureResult>> closures;
  std::vector<ClosureShare> shares;
  if (has_frame(state))
    for (const FrameShare& part : predicted_from(disturbance)) {
      closures.push_back(closure_of(plan, state, part.disturbance));
      shares.push_back({closures.back().get(), part.share});
    }
  const std::optional<ClosureResult> predicted = predicted_start(state.repaired.faces, shares);
  ClosedPlan closed =
      evaluate_(disturb(valve_, state.repaired, plan.plan, disturbances()[disturbance]),
                predicted ? &*predicted : state.closed.closure.get());
  if (in_frame(disturbance)) {
    const Lock lock(mutex_);
    state.frame.emplace(disturbance, closed.closure);
  }
  return closed;
}

void PlanEvaluations::close_one(PlanRecord& plan, int disturbance) {
  const std::shared_ptr<State> state = state_of(plan);
  const PlanClosure closure = plan_closure(close_disturbed(plan, *state, disturbance).evaluation);
  const Lock lock(mutex_);
  if (!plan.closures.contains(disturbance)) add(plan, disturbance, closure, false);
}

/// With what of the plans' frames they are predicted from and is not at hand, level by level.
/// @pre the plans' own closures are at hand.
std::vector<PlanEvaluations::Task> PlanEvaluations::with_frames(std::span<const Wanted> missing) {
  std::vector<Task> tasks;
  std::set<std::pair<const PlanRecord*, int>> seen;
  for (const Wanted& one : missing) {
    tasks.push_back({one.plan, one.disturbance, true});
    seen.emplace(one.plan, one.disturbance);
  }
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    const auto [plan, disturbance, wanted, level] = tasks[i];
    const std::shared_ptr<const State> state = state_of(*plan);
    if (!has_frame(*state)) {
      tasks[i].level = std::min(1, disturbance);
      continue;
    }
    tasks[i].level = frame_level(disturbance);
    const Lock lock(mutex_);
    for (const FrameShare& part : predicted_from(disturbance)) {
      const int d = part.disturbance;
      if (d > 0 && !state->frame.contains(d) && seen.emplace(plan, d).second)
        tasks.push_back({plan, d, false});
    }
  }
  std::stable_sort(tasks.begin(), tasks.end(),
                   [](const Task& a, const Task& b) { return a.level < b.level; });
  return tasks;
}

bool PlanEvaluations::stopped(Phase phase) const {
  return failed_ || (phase == Phase::Searching ? monitor_.search_stopped() : monitor_.stopped());
}

bool PlanEvaluations::open(std::span<PlanRecord* const> plans, Phase phase) {
  if (!options_.open) return true;
  std::vector<PlanRecord*> missing;
  for (PlanRecord* plan : plans)
    if (plan->possible && !plan->opening &&
        std::find(missing.begin(), missing.end(), plan) == missing.end())
      missing.push_back(plan);
  for_each_index(static_cast<int>(missing.size()), options_.threads, [&](int i) {
    if (stopped(phase)) return;
    PlanRecord& plan = *missing[i];
    const auto known = options_.known_openings.find(plan.key);
    plan.opening =
        known != options_.known_openings.end() ? known->second : options_.open(repaired(plan));
    ++openings_;
  });
  return std::all_of(missing.begin(), missing.end(),
                     [](const PlanRecord* plan) { return plan->opening.has_value(); });
}

std::optional<PlanOpening> PlanEvaluations::opened(const Valve& valve) const {
  if (!options_.open) return std::nullopt;
  return options_.open(valve);
}

bool PlanEvaluations::close(std::span<const Wanted> wanted, Phase phase) {
  std::vector<Wanted> missing;
  std::set<std::pair<const PlanRecord*, int>> seen;
  for (const Wanted& one : wanted) {
    if (!one.plan->possible || take_known(*one.plan, one.disturbance)) continue;
    if (seen.emplace(one.plan, one.disturbance).second) missing.push_back(one);
  }
  // In portions whose plans' own closures are all at hand, each of them made once.
  for (std::size_t first = 0; first < missing.size();) {
    std::vector<const PlanRecord*> plans;
    std::size_t last = first;
    for (; last < missing.size(); ++last) {
      if (std::find(plans.begin(), plans.end(), missing[last].plan) != plans.end()) continue;
      if (plans.size() == kStates / 2) break;
      plans.push_back(missing[last].plan);
    }
    for_each_index(static_cast<int>(plans.size()), options_.threads, [&](int i) {
      if (!stopped(phase)) state_of(*plans[i]);
    });
    if (stopped(phase)) break;
    const std::vector<Task> tasks = with_frames(std::span(missing).subspan(first, last - first));
    for (auto level = tasks.begin(); level != tasks.end();) {
      const auto next = std::find_if(level, tasks.end(),
                                     [&](const Task& task) { return task.level > level->level; });
      for_each_index(static_cast<int>(next - level), options_.threads, [&](int i) {
        if (stopped(phase)) return;
        const Task& task = level[i];
        if (task.wanted)
          close_one(*task.plan, task.disturbance);
        else
          closure_of(*task.plan, *state_of(*task.plan), task.disturbance);
      });
      level = next;
    }
    first = last;
  }
  return std::all_of(missing.begin(), missing.end(), [](const Wanted& one) {
    return one.plan->closures.contains(one.disturbance);
  });
}

bool PlanEvaluations::close_here(PlanRecord& plan, int count) {
  for (int d = 0; d < count && plan.possible; ++d) {
    if (take_known(plan, d)) continue;
    if (monitor_.search_stopped() || failed_) return false;
    close_one(plan, d);
  }
  return true;
}

std::map<std::string, int> PlanEvaluations::rejections() const {
  std::map<std::string, int> count;
  for (const auto& [key, record] : records_)
    if (!record->rejected_by.empty()) ++count[record->rejected_by];
  return count;
}

CostTerms PlanEvaluations::terms(const PlanRecord& plan, int count) const {
  CostTerms all;
  if (!plan.possible) {
    all[CostTerm::Untrusted] = 10.0;
    return all;
  }
  std::vector<ScoredClosure> closures;
  for (const auto& [disturbance, closure] : plan.closures) {
    if (disturbance >= count) break;
    closures.push_back({closure, region_share(disturbances()[disturbance])});
  }
  assert(std::ssize(closures) == count);
  all = cost_terms(closures, plan.effort, context_);
  if (count > 1 && plan.opening) all.amounts += opening_terms(*plan.opening).amounts;
  return all;
}

double PlanEvaluations::cost(const PlanRecord& plan, int count) const {
  return price(terms(plan, count), options_.weights);
}

double PlanEvaluations::guide(const PlanRecord& plan, int count) const {
  if (options_.guide_by_price) return cost(plan, count);
  double mild = 0.0;
  for (const auto& [disturbance, closure] : plan.closures) {
    if (disturbance >= count) break;
    if (trusted(closure))
      mild += probability_mild(closure.leak_mm2, static_cast<int>(valve_.faces.rows())) / count;
  }
  CostTerms all = terms(plan, count);
  if (count >= kChosenBy)
    if (const std::optional<Durability> lasts = durability(plan))
      all.amounts += durability_terms(*lasts).amounts;
  OperationMerits merits = operation_of(plan);
  merits.avoidable_warnings +=
      !tethered_ && raises_sam_risk(plan.closures.at(0).leaflet_ratio, leaflet_ratio_before_);
  return coapt::guide(all, mild, merits);
}

void PlanEvaluations::tell(const Diagnosis& diagnosis) {
  tethered_ = diagnosis.type_sure && may_be(diagnosis, CarpentierType::IIIb) &&
              !may_be(diagnosis, CarpentierType::II);
  untethered_ = diagnosis.type_sure && !may_be(diagnosis, CarpentierType::IIIb);
}

double PlanEvaluations::movement_guide() const {
  return (options_.guide_by_price ? options_.weights : kGuideWeights).movement;
}

}  // namespace coapt
