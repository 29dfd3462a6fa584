#include "search/rings/ring_trial.h"

#include <algorithm>

#include "core/metrics/annular_force.h"
#include "core/repair/apply_plan.h"
#include "core/repair/limits.h"
#include "core/repair/rings.h"
#include "core/valve/annulus_frame.h"
#include "search/parallel.h"
#include "search/plans/disturbance.h"
#include "search/plans/durability.h"
#include "search/plans/effort.h"
#include "search/plans/plan_opening.h"

namespace coapt {
namespace {

/// A member with a ring, closed as planned.
struct Ringed {
  const Valve& before;
  const RepairPlan& plan;
  Valve repaired;
  ClosedPlan as_planned;
};

Evaluation close_disturbed(const Evaluator& evaluate, const Ringed& ringed, int disturbance) {
  if (disturbance == 0) return ringed.as_planned.evaluation;
  const Valve valve = disturb(ringed.before, ringed.repaired, ringed.plan,
                              disturbances()[static_cast<std::size_t>(disturbance)]);
  return evaluate(valve, ringed.as_planned.closure.get()).evaluation;
}

/// Each course is closed up to where it leaks, as close_disease() does.
double durability_of(const Evaluator& evaluate, const Ringed& ringed) {
  PlanRecord record;
  for (const DiseaseCourse& course : disease_courses())
    for (const int index : course.indices) {
      const auto [found, is_new] = record.closures.try_emplace(index);
      if (is_new) found->second = plan_closure(close_disturbed(evaluate, ringed, index));
      if (!trusted(found->second) || found->second.leak_mm2 > kMildLeak_mm2) break;
    }
  return most_durable_mm(record);
}

}  // namespace

Annuloplasty sized_ring(const RingCandidate& candidate, const Valve& valve) {
  const double share = candidate.width_over_transverse;
  if (const auto* shape = std::get_if<DesignedShape>(&candidate.shape))
    return sized_ring(RingDesign{*shape, share}, valve);
  const auto& name = std::get<std::string>(candidate.shape);
  const double transverse = transverse_diameter_mm(valve);
  return {
      CatalogueRing{name, ring_size_mm(share / find_ring(name)->transverse_factor, transverse)}};
}

int price_of(const RingQuestion& question) {
  const int courses = static_cast<int>(disease_courses().size()) * kCourseSteps;
  return static_cast<int>(question.disturbances.size()) + (question.opening ? 1 : 0) +
         (question.durability ? courses : 0);
}

RingTrial closing_trial(const ClosureOptions& options) {
  return [evaluate = closing_evaluator(options)](const RingMember& member, const Annuloplasty& ring,
                                                 const RingQuestion& question) {
    RingOutcome outcome;
    const RepairPlan plan{{ring}};
    const Expected<Valve> repaired = apply_plan(member.valve, plan);
    if (!repaired) return outcome;
    outcome.is_possible = true;
    outcome.sizes_below = ring_sizes_below(member.valve, *repaired);
    const Ringed ringed{member.valve, plan, *repaired, evaluate(*repaired, member.before.get())};
    for (const int index : question.disturbances) {
      const Evaluation closed = close_disturbed(evaluate, ringed, index);
      outcome.leaks_mm2.push_back(trusted(closed) ? closed.measure.leak.area_mm2
                                                  : std::numeric_limits<double>::quiet_NaN());
    }
    if (trusted(ringed.as_planned.evaluation)) {
      outcome.tenting_mm = ringed.as_planned.evaluation.measure.tenting_height_mm;
      const SutureLoad load =
          suture_load(ringed.repaired, *ringed.as_planned.closure, kRingSutureCount);
      outcome.suture_max_n = load.max_n;
      outcome.suture_mean_n = load.mean_n;
      outcome.suture_normal_n = load.out_of_plane_n;
    }
    if (question.opening)
      if (const PlanOpening opening = open_plan(ringed.repaired); trusted(opening))
        outcome.gradient_mmhg = opening.measure.gradient_mmhg;
    if (question.durability) outcome.durability_mm = durability_of(evaluate, ringed);
    return outcome;
  };
}

std::vector<RingMember> prepare_members(std::vector<RingMember> members,
                                        const ClosureOptions& options, int threads) {
  for_each_index(static_cast<int>(members.size()), threads, [&](int i) {
    RingMember& member = members[static_cast<std::size_t>(i)];
    member.before = std::make_shared<const ClosureResult>(close_valve(member.valve, options));
  });
  std::erase_if(members, [](const RingMember& member) { return !trusted(*member.before); });
  return members;
}

std::vector<RingOutcome> try_ring(const RingTrial& trial, const std::vector<RingMember>& members,
                                  const RingCandidate& candidate, const RingQuestion& question,
                                  int threads) {
  std::vector<RingOutcome> outcomes(members.size());
  for_each_index(static_cast<int>(members.size()), threads, [&](int i) {
    const RingMember& member = members[static_cast<std::size_t>(i)];
    const Annuloplasty ring = sized_ring(candidate, member.valve);
    RingOutcome& outcome = outcomes[static_cast<std::size_t>(i)];
    outcome = trial(member, ring, question);
    if (const auto* designed = std::get_if<DesignedRing>(&ring.ring))
      outcome.size_mm = designed->size_mm;
    else
      outcome.size_mm = std::get<CatalogueRing>(ring.ring).size_mm;
  });
  return outcomes;
}

}  // namespace coapt
