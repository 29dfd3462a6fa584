#include "search/plans/plan_search.h"

#include <algorithm>
#include <array>
#include <utility>

#include "core/repair/apply_plan.h"
#include "search/plans/exploration.h"
#include "search/plans/ranking.h"

namespace coapt {
namespace {

void check_weights(ProblemList& problems, const CostWeights& weights) {
  // Names all fields, so that this does not compile when there is one more.
  const auto& [leak, sd_share, incompetence, margin, coaptation, gap, movement, movement_above_10,
               undersizing, undersizing_above_4, step, tension, untrusted] = weights;
  const std::array<std::pair<const char*, double>, 13> all = {{
      {"leak", leak},
      {"sd_share", sd_share},
      {"incompetence", incompetence},
      {"margin", margin},
      {"coaptation", coaptation},
      {"gap", gap},
      {"movement", movement},
      {"movement_above_10", movement_above_10},
      {"undersizing", undersizing},
      {"undersizing_above_4", undersizing_above_4},
      {"step", step},
      {"tension", tension},
      {"untrusted", untrusted},
  }};
  for (const auto& [name, weight] : all)
    check_range(problems, std::string("/weights/") + name, weight, {0.0, 1e6});
}

ProblemList check(const SearchOptions& options) {
  ProblemList problems;
  check_range(problems, "/evaluations", options.evaluations, {1.0, 1e6});
  check_range(problems, "/threads", options.threads, {0.0, 1024.0});
  check_range(problems, "/plans", options.plans, {1.0, 50.0});
  check_range(problems, "/region_points", options.region_points, {1.0, 1089.0});
  check_range(problems, "/seconds", options.seconds, {0.0, 1e6});
  check_range(problems, "/no_improvement", options.no_improvement, {0.0, 1e6});
  check_range(problems, "/target_mm2", options.target_mm2, {-1.0, 1e6});
  check_weights(problems, options.weights);
  return problems;
}

PlanDeskOptions desk_options(const SearchOptions& options, const SearchContext& context) {
  return {options.threads, context.known, context.keep, options.weights, options.rules.fixed};
}

/// What the desk and the ranked plans say of a search.
void summarise(const PlanDesk& desk, const Watch& watch, SearchResult& result) {
  result.any_competent = std::any_of(result.plans.begin(), result.plans.end(),
                                     [](const RankedPlan& plan) { return closes_robustly(plan); });
  if (watch.cancelled()) {
    result.stop = SearchStop::Cancelled;
  } else if (watch.stopped()) {
    result.stop = SearchStop::TimeLimit;
  }
  result.closures = desk.closures();
  result.closures_known = desk.known();
  result.closures_not_converged = desk.not_converged();
  result.closures_crossed = desk.crossed();
  result.seconds = watch.seconds();
}

Evaluator evaluator(const SearchOptions& options, const SearchContext& context) {
  return context.evaluate ? context.evaluate : closing_evaluator(options.closure);
}

}  // namespace

bool closes_robustly(const SearchResult& result) {
  return !result.plans.empty() && closes_robustly(result.plans.front());
}

Errors check_search(const Valve& valve, const SearchOptions& options,
                    const std::vector<RingShape>& catalogue) {
  ProblemList problems = check(options);
  for (const Error& error : check_rules(valve, catalogue, options.rules))
    problems.add(error.code, "/rules" + error.path, error.message);
  if (!problems.empty()) return std::move(problems).take();
  const PlanSpace space(valve, catalogue, options.rules);
  if (!space.branches().empty()) return {};
  std::string why;
  for (const CutBranches& cut : space.cut()) why += "; " + cut.what + ": " + cut.why;
  return {Error{ErrorCode::ImpossibleStep, "/rules", "leave no plan to try" + why}};
}

Expected<SearchResult> search_plans(const Valve& valve, const SearchOptions& options,
                                    const SearchContext& context) {
  if (Errors errors = check_search(valve, options, context.catalogue); !errors.empty())
    return errors;
  const PlanSpace space(valve, context.catalogue, options.rules);
  Watch watch(options.seconds, context.cancelled, context.progress);
  watch.plan(1 + options.evaluations + ranking_closures(options), "searching");
  const Evaluator evaluate = evaluator(options, context);
  PlanDesk desk(evaluate, valve, context.catalogue, desk_options(options, context), watch);
  Exploration exploration(desk, space, options, watch);
  exploration.run();

  SearchResult result;
  result.before = desk.before();
  result.evaluations = desk.closures() - 1;
  result.stop = exploration.stop();
  result.progress = exploration.progress();
  result.random_progress = exploration.random_progress();
  result.ladder = exploration.ladder();
  result.pareto_front = pareto_front(desk, exploration.scored(), kChosenBy);
  result.cut = space.cut();
  for (const auto& [rule, count] : desk.rejections())
    result.cut.push_back(
        {std::to_string(count) + (count == 1 ? " plan" : " plans"), "rejected by rule " + rule});
  result.branches = static_cast<int>(space.branches().size());
  for (const Branch& branch : space.branches()) result.plans_possible += point_count(branch);
  result.plans_tried = exploration.plans_tried();

  watch.plan(1 + result.evaluations + ranking_closures(options), "ranking");
  const int share = result.ladder.back().skipped ? kFinalists : kFinalists - 1;
  result.plans = rank(
      desk, close_finalists(desk, exploration.best(share * options.plans), options, result.ladder),
      options.region_points);
  summarise(desk, watch, result);
  return result;
}

Expected<SearchResult> evaluate_plans(const Valve& valve, const std::vector<NamedPlan>& plans,
                                      const SearchOptions& options, const SearchContext& context) {
  ProblemList problems = check(options);
  for (std::size_t i = 0; i < plans.size(); ++i)
    if (const Expected<Valve> repaired = apply_plan(valve, plans[i].plan, context.catalogue);
        !repaired)
      for (const Error& error : repaired.errors())
        problems.add(error.code, "/plans/" + std::to_string(i) + error.path, error.message);
  if (plans.empty()) problems.add(ErrorCode::OutOfRange, "/plans", "is empty, must hold a plan");
  if (!problems.empty()) return std::move(problems).take();

  SearchOptions all = options;
  all.plans = static_cast<int>(plans.size());
  Watch watch(options.seconds, context.cancelled, context.progress);
  watch.plan(1 + ranking_closures(all), "ranking");
  const Evaluator evaluate = evaluator(options, context);
  PlanDesk desk(evaluate, valve, context.catalogue, desk_options(options, context), watch);
  std::vector<PlanRecord*> records;
  for (const NamedPlan& named : plans) {
    PlanRecord& record = desk.record(named.plan);
    if (std::find(records.begin(), records.end(), &record) == records.end())
      records.push_back(&record);
  }
  SearchResult result;
  result.before = desk.before();
  result.plans = rank(desk, close_finalists(desk, records, all, result.ladder), all.region_points);
  for (RankedPlan& ranked : result.plans)
    for (const NamedPlan& named : plans)
      if (&desk.record(named.plan) == &desk.record(ranked.plan))
        ranked.name += (ranked.name.empty() ? "" : ", ") + named.name;
  result.plans_tried = static_cast<int>(records.size());
  result.evaluations = desk.closures() - 1;
  summarise(desk, watch, result);
  return result;
}

}  // namespace coapt
