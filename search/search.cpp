// 1. Every sensible choice once, at its default lengths (half of the evaluations at most).
// 2. The best rings one size up and down.
// 3. Successive halving: the best strategies refine their lengths with equal quotas, the better half
//    goes on with what is left, and so to the last two (a pilot: 1,764 evaluations to within 0.1 mm2
//    of the best, against 70,036 for random search).
// 4. Re-scoring over the region of interest (rank.h).
//
// Strategies run side by side, each one by itself in order, and every quota is fixed before it is
// spent: the result cannot depend on the number of threads.

#include "search/search.h"

#include <algorithm>
#include <set>

#include "core/repair/apply_plan.h"
#include "core/valve/problem_list.h"
#include "search/objective.h"
#include "search/parallel.h"
#include "search/rank.h"
#include "search/refine.h"
#include "search/strategies.h"
#include "search/watch.h"

namespace coapt {
namespace {

constexpr int kRingRounds = 2;         // a ring can get two sizes away from its default
constexpr int kRingParents = 4;        // strategies whose neighbours are tried, each round
constexpr int kMostRefined = 8;        // strategies in the first round of halving
constexpr int kTrialsPerRefined = 10;  // fewer strategies start if there are not that many each

Errors check(const SearchOptions& options) {
  ProblemList problems;
  check_range(problems, "/evaluations", options.evaluations, {1.0, 1e6});
  check_range(problems, "/threads", options.threads, {0.0, 1024.0});
  check_range(problems, "/plans", options.plans, {1.0, 50.0});
  check_range(problems, "/region_points", options.region_points, {1.0, 1089.0});
  check_range(problems, "/seconds", options.seconds, {0.0, 1e6});
  return std::move(problems).take();
}

class PlanSearch {
 public:
  PlanSearch(const RankRequest& request, Watch& watch)
      : request_(request), watch_(watch), left_(request.options.evaluations) {}

  void run() {
    start(sensible_choices(request_.valve, request_.catalogue),
          std::max(1, request_.options.evaluations / 2));
    for (int round = 0; round < kRingRounds; ++round) start(better_rings(), left_ / 6);
    int count = std::clamp(left_ / kTrialsPerRefined, 1, kMostRefined);
    for (; count > 2; count /= 2) refine_best(count, left_ / rounds_from(count));
    while (left_ > 0 && !watch_.search_stopped() && refine_best(count, left_)) {
    }
  }

  const std::vector<StrategySearch>& searches() const { return searches_; }
  const std::vector<double>& history() const { return history_; }

 private:
  /// Rounds of halving from so many strategies down to two or one.
  static int rounds_from(int count) { return count > 2 ? 1 + rounds_from(count / 2) : 1; }

  std::optional<Trial> try_point(const Strategy& strategy, const std::vector<int>& at) {
    if (watch_.search_stopped()) return std::nullopt;
    Trial trial;
    trial.plan = plan_at(strategy, at);
    const Expected<Valve> repaired = apply_plan(request_.valve, trial.plan, request_.catalogue);
    assert(repaired);  // the strategy's bounds leave out what is impossible
    trial.evaluation = request_.evaluate(*repaired);
    watch_.closed(trial.evaluation, true);
    trial.cost = cost(trial.evaluation, effort(request_.valve, *repaired, trial.plan),
                      request_.valve.tissue.thickness_mm, request_.before.measure.tension_max_n);
    return trial;
  }

  /// Tries the choices that are new, the first `most` of them.
  void start(const std::vector<Choice>& choices, int most) {
    const std::size_t first = searches_.size();
    for (const Choice& choice : choices) {
      if (static_cast<int>(searches_.size() - first) >= std::min(most, left_)) break;
      std::optional<Strategy> strategy = make_strategy(request_.valve, request_.catalogue, choice);
      if (!strategy || !seen_.insert(key(strategy->plan)).second) continue;
      searches_.emplace_back().strategy = std::move(*strategy);
    }
    const TryPoint try_it = [this](const auto& s, const auto& at) { return try_point(s, at); };
    for_each_index(
        static_cast<int>(searches_.size() - first), request_.options.threads,
        [&](int i) { try_start(searches_[first + static_cast<std::size_t>(i)], try_it); });
    std::vector<std::size_t> started;
    for (std::size_t i = first; i < searches_.size(); ++i) started.push_back(i);
    account(started);
  }

  std::string key(const RepairPlan& plan) const {
    std::string text;
    for (const std::string& line : describe(request_.valve, plan)) text += line + '\n';
    return text;
  }

  /// Indices of searches with a closed plan, cheapest first.
  std::vector<std::size_t> by_cost() const {
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < searches_.size(); ++i)
      if (searches_[i].best) order.push_back(i);
    std::stable_sort(order.begin(), order.end(), [this](std::size_t a, std::size_t b) {
      return searches_[a].best->cost < searches_[b].best->cost;
    });
    return order;
  }

  std::vector<Choice> better_rings() const {
    std::vector<Choice> neighbours;
    int parents = 0;
    for (const std::size_t i : by_cost()) {
      const Choice& choice = searches_[i].strategy.choice;
      if (!choice.ring) continue;
      if (++parents > kRingParents) break;
      for (const Choice& neighbour : ring_neighbours(request_.valve, request_.catalogue, choice))
        neighbours.push_back(neighbour);
    }
    return neighbours;
  }

  /// Spends `quota` on the best `count` strategies that have lengths left to try. False if there
  /// are none.
  bool refine_best(int count, int quota) {
    std::vector<std::size_t> chosen;
    for (const std::size_t i : by_cost())
      if (!is_exhausted(searches_[i]) && std::ssize(chosen) < std::min(count, quota))
        chosen.push_back(i);
    if (chosen.empty()) return false;
    const TryPoint try_it = [this](const auto& s, const auto& at) { return try_point(s, at); };
    const int team = static_cast<int>(chosen.size());
    for_each_index(team, request_.options.threads, [&](int k) {
      const std::size_t i = chosen[static_cast<std::size_t>(k)];
      const int share = quota / team + (k < quota % team ? 1 : 0);
      refine(searches_[i], share, request_.options.seed + i, try_it);
    });
    account(chosen);
    return true;
  }

  /// Takes the new costs of these searches into the history, in their order.
  void account(const std::vector<std::size_t>& indices) {
    for (const std::size_t i : indices) {
      for (const double value : searches_[i].history) {
        history_.push_back(history_.empty() ? value : std::min(value, history_.back()));
        --left_;
      }
      searches_[i].history.clear();
    }
  }

  const RankRequest& request_;
  Watch& watch_;
  int left_;  // evaluations
  std::vector<StrategySearch> searches_;
  std::set<std::string> seen_;
  std::vector<double> history_;
};

}  // namespace

Expected<SearchResult> search_plans_with(const Evaluator& evaluate, const Valve& valve,
                                         const SearchOptions& options,
                                         const std::vector<RingShape>& catalogue,
                                         const std::function<void(const SearchProgress&)>& progress,
                                         const std::atomic<bool>* cancelled) {
  if (Errors errors = check(options); !errors.empty()) return errors;
  Watch watch(options.seconds, cancelled, progress);
  watch.plan(1 + options.evaluations + ranking_closures(options));
  const Evaluation before = evaluate(valve);
  watch.closed(before, false);
  const RankRequest request{evaluate, valve, options, catalogue, before};
  PlanSearch search(request, watch);
  search.run();

  SearchResult result;
  result.before = before.measure;
  result.before_status = before.status;
  result.before_crossing = before.crossing;
  result.plans = rank_plans(request, finalists(search.searches(), options), watch);
  result.best_cost_history = search.history();
  result.stop = watch.stop();
  result.closures = watch.closures();
  result.evaluations = static_cast<int>(search.history().size());
  result.closures_not_converged = watch.not_converged();
  result.closures_crossed = watch.crossed();
  result.seconds = watch.seconds();
  return result;
}

Expected<SearchResult> search_plans(const Valve& valve, const SearchOptions& options,
                                    const std::vector<RingShape>& catalogue,
                                    const std::function<void(const SearchProgress&)>& progress,
                                    const std::atomic<bool>* cancelled) {
  return search_plans_with(closing_evaluator(options.closure), valve, options, catalogue, progress,
                           cancelled);
}

}  // namespace coapt
