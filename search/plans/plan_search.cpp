#include "search/plans/plan_search.h"

#include <algorithm>
#include <set>
#include <utility>

#include "core/repair/apply_plan.h"
#include "core/valve/counted.h"
#include "search/plans/drawn_openings.h"
#include "search/plans/exploration.h"
#include "search/plans/fine_closures.h"
#include "search/plans/front_search.h"
#include "search/plans/model_closures.h"
#include "search/plans/pareto.h"
#include "search/plans/plan_estimates.h"
#include "search/plans/plan_key.h"
#include "search/plans/ranking.h"
#include "search/plans/search_option_table.h"

namespace coapt {
namespace {

constexpr int kFrontCandidates = 2000;  // at random, beside those tried

PlanEvaluationOptions evaluation_options(const SearchOptions& options,
                                         const SearchContext& context) {
  // What stands in for closures need not have a valve that opens.
  const Opener open = context.open ? context.open : context.evaluate ? Opener{} : Opener{open_plan};
  return {options.threads,    context.known,         context.keep,
          options.weights,    options.rank_by_price, options.openings ? open : Opener{},
          options.rules.fixed};
}

/// The valve as it is, and why it leaks.
void tell_before(PlanEvaluations& evaluations, SearchResult& result) {
  const Valve& valve = evaluations.valve();
  const ClosedPlan before = with_leak_surface(valve, evaluations.closed_before());
  result.before = before.evaluation;
  result.before_estimates = estimates_before(evaluations, before.evaluation.measure, {}, {}, {});
  result.closed_before = closed_valve(valve, before);
  if (result.closed_before)
    result.diagnosis = diagnose(valve, result.closed_before->closure, before.evaluation.measure);
  if (result.diagnosis) evaluations.tell(*result.diagnosis);
}

bool any_acceptable(const std::vector<RankedPlan>& plans) {
  return std::any_of(plans.begin(), plans.end(),
                     [](const RankedPlan& plan) { return plan.is_acceptable; });
}

/// The first plan is acceptable and, unless plans are ranked by price, without an avoidable warning.
bool is_settled(const std::vector<RankedPlan>& plans, const SearchOptions& options) {
  return options.rank_by_price ? any_acceptable(plans)
                               : !plans.empty() && plans.front().tier == PlanTier::Acceptable;
}

/// What all evaluations and the ranked plans add to a result.
void summarise(const PlanEvaluations& evaluations, const SearchMonitor& monitor,
               SearchResult& result) {
  result.any_acceptable = any_acceptable(result.plans);
  if (monitor.cancelled()) {
    result.stop = SearchStop::Cancelled;
  } else if (monitor.stopped()) {
    result.stop = SearchStop::TimeLimit;
  }
  result.closures = evaluations.closures();
  result.closures_known = evaluations.known();
  result.closures_not_converged = evaluations.not_converged();
  result.closures_crossed = evaluations.crossed();
  result.seconds = monitor.seconds();
}

/// Adds what tissue and hand make of openings, before and of the plans that are reported.
void open_under_draws(PlanEvaluations& evaluations, const ModelClosures& model,
                      SearchResult& result) {
  std::vector<const PlanRecord*> plans{nullptr};
  for (const RankedPlan& plan : result.plans) plans.push_back(&evaluations.record(plan.plan));
  const std::vector<DrawnOpenings> drawn = open_under_draws(evaluations, plans, model);
  add_spread(result.before_estimates, result.opening_before, drawn.front());
  for (std::size_t i = 0; i < result.plans.size(); ++i)
    add_spread(result.plans[i].estimates, result.plans[i].opening, drawn[i + 1]);
}

/// Fills what a result says of the best plans. `reserve`: plans that join where none of the finalists ranks first without reproach. `map_nodes`: of the region, for the first of them.
void rank_finalists(PlanEvaluations& evaluations, std::vector<PlanRecord*> finalists,
                    const std::vector<PlanRecord*>& reserve, const SearchOptions& options,
                    int map_nodes, SearchResult& result) {
  evaluations.open(finalists, PlanEvaluations::Phase::Ranking);
  auto [kept, others] = close_finalists(evaluations, std::move(finalists), options, result.ladder);
  finalists = std::move(kept);
  FineClosures fine;
  ModelClosures model;
  const auto judge = [&] {
    fine = close_fine(evaluations, finalists, options.fine_levels, std::move(fine));
    model = close_under_draws(evaluations, finalists, options.model_draws, std::move(model));
    result.plans = rank(evaluations, finalists, options, fine, model);
  };
  judge();
  // Nodes took plans for acceptable that are not so with other tissue or on the finer mesh; those that they put behind may be.
  if (!others.empty() && !is_settled(result.plans, options)) {
    finalists.insert(finalists.end(), others.begin(), others.end());
    judge();
  }
  if (options.evidence && !reserve.empty() && !is_settled(result.plans, options) &&
      close_reserve(evaluations, reserve, options)) {
    finalists.insert(finalists.end(), reserve.begin(), reserve.end());
    judge();
  }
  std::vector<PlanRecord*> reported;
  for (const RankedPlan& plan : result.plans) reported.push_back(&evaluations.record(plan.plan));
  const bool maps = map_nodes > options.region_points && !reported.empty();
  if (options.evidence) close_evidence(evaluations, reported);
  if (maps) close_map(evaluations, *reported.front(), map_nodes);
  if (options.evidence || maps) result.plans = rank(evaluations, finalists, options, fine, model);
  if (options.evidence)
    for (RankedPlan& plan : result.plans)
      plan.starts = check_starts(evaluations, evaluations.record(plan.plan), plan.region.closures);
  if (options.evidence && !result.plans.empty()) {
    RankedPlan& first = result.plans.front();
    const PlanRecord& record = evaluations.record(first.plan);
    first.other_anchors = compare_anchors(evaluations, record, options);
    first.tolerance = step_tolerances(evaluations, record);
  }
  result.opening_before = evaluations.opened(evaluations.valve());
  result.fine_mesh = fine.mesh;
  result.model_draws = model.draws;
  result.draws_fit = evaluations.valve().fitted.has_value();
  result.draws_chordae = redraws_chordae(evaluations.valve());
  result.model_closures = model.closures;
  if (!model.before.empty()) result.before_under_draws = model_spread(model.before);
  if (model.draws > 0) result.observed = evaluations.valve().observed;
  result.effective_draws = model.effective;
  result.observed_contradicts = model.contradicts;
  result.before_estimates =
      estimates_before(evaluations, result.before.measure, result.opening_before, fine.mesh, model);
  if (!result.plans.empty())
    result.information = information_rows(model, evaluations.record(result.plans.front().plan));
  if (model.draws > 0) open_under_draws(evaluations, model, result);
}

/// None if too few for a round.
int front_closures(const SearchOptions& options) {
  const auto most = static_cast<int>(options.front_share * options.evaluations);
  return options.openings && most >= kLeastFrontClosures ? most : 0;
}

/// Plans asked what they trade, among those tried and some at random.
std::vector<PlanRecord*> trading_plans(PlanEvaluations& evaluations, const PlanSpace& space,
                                       const ExplorationState& exploration) {
  const SearchOptions& options = exploration.in.options;
  const bool stopped =
      exploration.stop != SearchStop::EvaluationLimit && exploration.stop != SearchStop::Exhausted;
  if (front_closures(options) == 0 || !evaluations.opens() || stopped) return {};
  std::vector<PlanRecord*> candidates;
  std::set<const PlanRecord*> seen;
  const auto add = [&](PlanRecord& plan) {
    if (!is_infeasible(plan) && seen.insert(&plan).second) candidates.push_back(&plan);
  };
  for (const Trial& trial : exploration.trials) add(*trial.record);
  for (const BranchPoint& point : random_points(exploration, kFrontCandidates))
    add(evaluations.record(space.plan(space.branches()[point.branch], point.at)));
  std::vector<PlanRecord*> plans;
  for (const FrontPlan& asked : search_front(
           evaluations, candidates, {.closures = front_closures(options), .seed = options.seed}))
    plans.push_back(asked.plan);
  return plans;
}

/// Adds the cheapest of `from` that are not among `finalists` yet, `most` at most.
void add_cheapest(const std::vector<ParetoPlan>& from, int most, PlanEvaluations& evaluations,
                  std::vector<PlanRecord*>& finalists) {
  for (const ParetoPlan& plan : from) {
    if (most == 0) break;
    PlanRecord* const record = &evaluations.record(plan.plan);
    if (std::find(finalists.begin(), finalists.end(), record) != finalists.end()) continue;
    finalists.push_back(record);
    --most;
  }
}

/// With its rank among `ranked`.
TriedPlan tried_plan(const PlanEvaluations& evaluations, const PlanRecord& record,
                     const std::vector<RankedPlan>& ranked) {
  TriedPlan tried;
  tried.plan = record.plan;
  tried.planned = record.closures.at(0);
  while (tried.nodes < kRegion.count && record.closures.contains(tried.nodes)) {
    tried.failures += !trusted(record.closures.at(tried.nodes));
    ++tried.nodes;
  }
  tried.cost_as_planned = evaluations.cost(record, 1);
  tried.cost = evaluations.cost(record, tried.nodes);
  tried.leak_mm2 = leak_statistics(record, tried.nodes);
  for (const RankedPlan& plan : ranked)
    if (plan_key(plan.plan) == record.key) tried.rank = plan.rank;
  return tried;
}

Evaluator evaluator(const SearchOptions& options, const SearchContext& context) {
  return context.evaluate ? context.evaluate : closing_evaluator(options.closure);
}

}  // namespace

Errors check_search(const Valve& valve, const SearchOptions& options) {
  ProblemList problems;
  check_option_ranges(problems, options);
  for (const Error& error : check_plan_space(valve, options.rules))
    problems.add(error.code, "/rules" + error.path, error.message);
  return std::move(problems).take();
}

Expected<SearchResult> search_plans(const Valve& valve, const SearchOptions& options,
                                    const SearchContext& context) {
  if (Errors errors = check_search(valve, options); !errors.empty()) return errors;
  SearchMonitor monitor(options.seconds, context.cancelled, context.progress, context.now);
  monitor.plan(1 + options.evaluations + front_closures(options) + ranking_closures(options) +
                   anchor_closures(options),
               "searching");
  const Evaluator evaluate = evaluator(options, context);
  PlanEvaluations evaluations(evaluate, valve, evaluation_options(options, context), monitor);
  SearchResult result;
  tell_before(evaluations, result);
  const PlanSpace space(valve, options.rules, result.diagnosis);
  result.cut = space.cut();
  if (space.branches().empty()) {  // nothing that is indicated is left
    summarise(evaluations, monitor, result);
    result.stop = SearchStop::Exhausted;
    return result;
  }
  const ExplorationState exploration = explore({evaluations, space, options, monitor});

  result.evaluations = evaluations.closures() - 1;
  result.stop = exploration.stop;
  result.progress = exploration.progress;
  result.random_progress = random_progress(exploration);
  result.ladder = ladder_of(exploration);
  for (const auto& [rule, count] : evaluations.rejections()) {
    std::string words = rule;
    std::replace(words.begin(), words.end(), '_', ' ');
    result.cut.push_back({counted(count, "plan"), "rejected by the rule " + words});
  }
  result.branches = static_cast<int>(space.branches().size());
  for (const Branch& branch : space.branches()) result.plans_possible += point_count(branch);

  std::vector<const PlanRecord*> tried, scored = scored_plans(exploration);
  for (const Trial& trial : exploration.trials) tried.push_back(trial.record);
  const std::vector<PlanRecord*> trading = trading_plans(evaluations, space, exploration);
  for (const PlanRecord* plan : trading) {
    if (std::find(tried.begin(), tried.end(), plan) == tried.end()) tried.push_back(plan);
    if (std::find(scored.begin(), scored.end(), plan) == scored.end()) scored.push_back(plan);
  }
  result.plans_tried = static_cast<int>(tried.size());
  if (!trading.empty() && monitor.search_stopped()) result.stop = SearchStop::TimeLimit;

  const int wanted = wanted_finalists(options, result.ladder.back().skipped);
  std::vector<PlanRecord*> reserve = best_plans(exploration, wanted + kReserve);
  const auto last = reserve.begin() + std::min<std::ptrdiff_t>(wanted, std::ssize(reserve));
  std::vector<PlanRecord*> finalists(reserve.begin(), last);
  if (!trading.empty())
    add_cheapest(pareto_front(evaluations, scored, kChosenBy), kFrontFinalists, evaluations,
                 finalists);
  std::erase_if(reserve, [&](const PlanRecord* plan) {
    return std::find(finalists.begin(), finalists.end(), plan) != finalists.end();
  });
  SearchOptions ordering = options;
  ordering.region_points = std::min(options.region_points, kBeforeTheRegion);
  monitor.plan(evaluations.closures() + ranking_closures(ordering, finalists) +
                   anchor_closures(options) + options.region_points - ordering.region_points,
               "ranking");
  rank_finalists(evaluations, finalists, reserve, ordering, options.region_points, result);
  result.pareto_front = pareto_front(evaluations, scored, kChosenBy);
  for (const PlanRecord* plan : tried)
    result.tried.push_back(tried_plan(evaluations, *plan, result.plans));
  summarise(evaluations, monitor, result);
  return result;
}

Expected<SearchResult> evaluate_plans(const Valve& valve, const std::vector<NamedPlan>& plans,
                                      const SearchOptions& options, const SearchContext& context) {
  ProblemList problems;
  check_option_ranges(problems, options);
  for (std::size_t i = 0; i < plans.size(); ++i)
    if (const Expected<Valve> repaired = apply_plan(valve, plans[i].plan); !repaired)
      for (const Error& error : repaired.errors())
        problems.add(error.code, "/plans/" + std::to_string(i) + error.path, error.message);
  if (plans.empty())
    problems.add(ErrorCode::OutOfRange, "/plans", "is empty, must contain at least one plan");
  if (!problems.empty()) return std::move(problems).take();

  SearchOptions all = options;
  all.plans = static_cast<int>(plans.size());
  SearchMonitor monitor(options.seconds, context.cancelled, context.progress, context.now);
  monitor.plan(1 + ranking_closures(all) + anchor_closures(all), "ranking");
  const Evaluator evaluate = evaluator(options, context);
  PlanEvaluations evaluations(evaluate, valve, evaluation_options(options, context), monitor);
  std::vector<PlanRecord*> records;
  for (const NamedPlan& named : plans) {
    PlanRecord& record = evaluations.record(named.plan);
    if (std::find(records.begin(), records.end(), &record) == records.end())
      records.push_back(&record);
  }
  monitor.plan(1 + ranking_closures(all, records) + anchor_closures(all), "ranking");
  SearchResult result;
  tell_before(evaluations, result);
  rank_finalists(evaluations, records, {}, all, all.region_points, result);
  for (RankedPlan& ranked : result.plans)
    for (const NamedPlan& named : plans)
      if (&evaluations.record(named.plan) == &evaluations.record(ranked.plan))
        ranked.name += (ranked.name.empty() ? "" : ", ") + named.name;
  result.plans_tried = static_cast<int>(records.size());
  summarise(evaluations, monitor, result);
  return result;
}

}  // namespace coapt
