#include "lab/lattices/solved_front.h"

#include <algorithm>

namespace coapt {
namespace {

constexpr std::size_t kPlansAtOnce = 64;  // plans measured at once

PlanOutcome outcome_of(const PlanRecord& plan) {
  const auto closures = static_cast<int>(plan.closures.size());
  int nodes = 0;
  while (nodes < kChosenBy && plan.closures.contains(nodes)) ++nodes;
  return {trade_off(plan, kChosenBy), region_leak_mm2(plan, nodes),
          closures + (plan.opening ? kOpeningClosures : 0)};
}

}  // namespace

std::optional<SolvedFront> solve_front(const LatticeCase& lattice, int threads,
                                       const SearchContext& context, KnownOpenings openings,
                                       const std::function<void(const KnownOpenings&)>& keep) {
  SolvedFront solved{.of = lattice,
                     .space = std::make_shared<PlanSpace>(lattice.valve, lattice.rules)};
  solved.flat = std::make_shared<FlatSpace>(*solved.space);
  SearchMonitor monitor(0.0, context.cancelled, context.progress);
  const Evaluator evaluate = context.evaluate ? context.evaluate : closing_evaluator({});
  PlanEvaluationOptions options;
  options.threads = threads;
  options.known = context.known;
  options.keep = context.keep;
  options.open = context.open ? context.open : Opener{open_plan};
  options.known_openings = openings;
  PlanEvaluations evaluations(evaluate, lattice.valve, std::move(options), monitor);
  solved.before = evaluations.before();
  auto [plans, numbers] = plans_of(*solved.space, *solved.flat, evaluations);
  solved.numbers = std::move(numbers);
  monitor.plan(1 + (kChosenBy + kDisease.count) * static_cast<int>(plans.size()),
               "solving lattice " + lattice.name);
  for (std::size_t first = 0; first < plans.size(); first += kPlansAtOnce) {
    const auto portion =
        std::span(plans).subspan(first, std::min(kPlansAtOnce, plans.size() - first));
    if (!measure_trade_offs(evaluations, portion, kChosenBy, PlanEvaluations::Phase::Ranking))
      return std::nullopt;
    const std::size_t known = openings.size();
    for (const PlanRecord* plan : portion)
      if (plan->opening) openings.try_emplace(plan->key, *plan->opening);
    if (keep && openings.size() > known) keep(openings);
  }
  std::vector<TradeOff> accepted;
  for (const PlanRecord* plan : plans) {
    solved.closures[plan->key] = plan->closures;
    solved.outcomes.push_back(outcome_of(*plan));
    if (const auto& found = solved.outcomes.back().trade_off) accepted.push_back(*found);
  }
  solved.openings = std::move(openings);
  solved.volume = dominated_volume(accepted);
  return solved;
}

VolumeRise volume_rise(const SolvedFront& front, const std::vector<int>& numbers) {
  VolumeRise rise;
  std::vector<bool> paid(front.outcomes.size());
  std::vector<TradeOff> found;
  int closures = 0;
  for (const int number : numbers) {
    if (number < 0 || paid[static_cast<std::size_t>(number)]) continue;
    paid[static_cast<std::size_t>(number)] = true;
    const PlanOutcome& outcome = front.outcomes[static_cast<std::size_t>(number)];
    closures += outcome.closures;
    if (!outcome.trade_off) continue;
    found.push_back(*outcome.trade_off);
    const double share = dominated_volume(found) / front.volume;
    if (rise.empty() || share > rise.back().second) {
      rise.emplace_back(closures, share);
    } else {
      found.pop_back();  // another is as good: the volume of thousands takes long
    }
  }
  return rise;
}

}  // namespace coapt
