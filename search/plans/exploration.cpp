#include "search/plans/exploration.h"

#include <algorithm>
#include <limits>

namespace coapt {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr std::size_t kStartBatch = 8;
constexpr int kFewPoints = 6;     // a branch of so many is tried whole
constexpr int kHalved = 8;        // branches in the first round of a bracket
constexpr int kQuota = 8;         // plans each, in the first round of a bracket
constexpr int kRandomShare = 20;  // one of so many closures is spent on plans at random, up to
constexpr int kMostRandom = 100;
constexpr double kMoreOptimism = 0.5;  // scatters, from bracket to bracket
constexpr double kFreely = 2.0;        // scatters, where few nodes say little about more

}  // namespace

Exploration::Exploration(PlanDesk& desk, const PlanSpace& space, const SearchOptions& options,
                         Watch& watch)
    : desk_(desk), space_(space), options_(options), watch_(watch), enter_(kInfinite) {
  for (std::size_t r = 0; r + 1 < std::size(kRungs); ++r)
    climbs_.emplace_back(kRungs[r], kRungs[r + 1]);
  for (const Branch& branch : space.branches()) {
    searches_.emplace_back().branch = &branch;
    // A suture's length is rounded to the lattice: by half a step, of two sutures.
    lowest_.push_back(desk.record(space.plan(branch, mildest_of(branch))).lowest_cost -
                      options.weights.movement * options.rules.suture_lattice_mm);
    idle_.push_back(false);
    best_scored_.push_back(kInfinite);
  }
}

std::vector<Exploration::Point> Exploration::make_starts() {
  std::vector<std::pair<double, Point>> order;
  const auto bound = [&](std::size_t branch, const LatticePoint& at) {
    const PlanRecord& record = desk_.record(space_.plan(space_.branches()[branch], at));
    return is_out(record) ? kOut : record.lowest_cost;
  };
  for (std::size_t i = 0; i < searches_.size(); ++i) {
    const Branch& branch = space_.branches()[i];
    if (point_count(branch) <= kFewPoints) {
      for (std::int64_t number = 0; number < point_count(branch); ++number)
        order.push_back({bound(i, point_at(branch, number)), {i, point_at(branch, number)}});
      continue;
    }
    const LatticePoint start = start_of(branch), mildest = mildest_of(branch);
    const bool usual = bound(i, start) < kOut;
    order.push_back({bound(i, usual ? start : mildest), {i, usual ? start : mildest}});
  }
  std::stable_sort(order.begin(), order.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<Point> starts;
  for (const auto& [cost, point] : order)
    if (std::ssize(starts) < std::max(1, options_.evaluations / 2)) starts.push_back(point);
  return starts;
}

void Exploration::run() {
  const std::vector<Point> starts = make_starts();
  for (std::size_t first = 0; first < starts.size() && !over(); first += kStartBatch) {
    const auto last = std::min(starts.size(), first + kStartBatch);
    try_points({starts.begin() + static_cast<std::ptrdiff_t>(first),
                starts.begin() + static_cast<std::ptrdiff_t>(last)});
    sprint();
  }
  double optimism = 1.0;
  for (; !by_cost().empty() && !over(); optimism += kMoreOptimism) {
    const int before = desk_.closures();
    int each = kQuota;
    for (int count = kHalved; count >= 2 && !over(); count /= 2, each *= 2) {
      refine_best(count, each);
      race(2 * kRaceBatch, 1.0);
    }
    if (random_.empty() && !over()) {
      try_random(std::min({kMostRandom, options_.evaluations / kRandomShare, left()}));
      measure_ladder();
    }
    if (!over()) lend();
    if (!over()) race(std::numeric_limits<int>::max(), optimism);
    if (ladder()[1].skipped) optimism = std::max(optimism, kFreely);
    if (short_ && before == desk_.closures()) break;
  }
  if (!over() && !short_) stop_ = SearchStop::Exhausted;
  if (!progress_.empty() && progress_.back().closures < desk_.closures())
    progress_.push_back({desk_.closures(), progress_.back().cost});
}

int Exploration::left() const { return options_.evaluations + 1 - desk_.closures(); }

bool Exploration::over() {
  if (watch_.cancelled()) {
    stop_ = SearchStop::Cancelled;
  } else if (watch_.search_stopped()) {
    stop_ = SearchStop::TimeLimit;
  } else if (options_.no_improvement > 0 &&
             desk_.closures() - improved_at_ >= options_.no_improvement) {
    stop_ = SearchStop::NoImprovement;
  } else if (stop_ != SearchStop::TargetReached) {
    return left() <= 0;
  }
  return true;
}

double Exploration::to_beat(std::size_t branch) const {
  return std::min(enter_, best_scored_[branch]);
}

void Exploration::update_to_beat() {
  std::vector<double> best = best_scored_;
  const auto place = static_cast<std::size_t>(options_.plans) - 1;
  if (best.size() <= place) return;
  std::nth_element(best.begin(), best.begin() + options_.plans - 1, best.end());
  enter_ = best[place];
}

ClimbModel::Expectation Exploration::expected(const PlanRecord& record, int rung) const {
  if (kRungs[rung] < kChosenBy)
    return climbs_[static_cast<std::size_t>(rung)].expected(desk_, record);
  const double cost = desk_.cost(record, kRungs[rung]);
  return {cost, cost, 0.0, 0.0, cost};
}

void Exploration::learn() {
  for (std::size_t r = 0; r < climbs_.size(); ++r) {
    std::vector<const PlanRecord*> climbed;
    for (const Tried& plan : tried_)
      if (plan.rung > static_cast<int>(r)) climbed.push_back(plan.record);
    climbs_[r].learn(desk_, climbed);
  }
  for (BranchSearch& search : searches_) {
    search.best.clear();
    search.best_cost = kInfinite;
  }
  for (Tried& plan : tried_) {
    plan.expected = expected(*plan.record, plan.rung);
    BranchSearch& search = searches_[plan.branch];
    for (const LatticePoint& at : plan.at) search.costs[at] = plan.expected.cost;
    if (plan.expected.cost >= search.best_cost) continue;
    search.best = plan.at.front();
    search.best_cost = plan.expected.cost;
  }
}

void Exploration::take(PlanRecord& record, const Point& point) {
  const double cost = desk_.cost(record, 1);
  const ClimbModel::Expectation likely = expected(record, 0);
  if (!searches_[point.branch].costs.contains(point.at))
    add_point(searches_[point.branch], point.at, {likely.cost, 0, false});
  const auto [found, is_new] = index_.try_emplace(&record, tried_.size());
  if (!is_new) {
    std::vector<LatticePoint>& known = tried_[found->second].at;
    if (std::find(known.begin(), known.end(), point.at) == known.end()) known.push_back(point.at);
    return;
  }
  tried_.push_back({&record, point.branch, {point.at}, 0, likely});
  if (progress_.empty() || cost < progress_.back().cost) {
    if (!progress_.empty() && progress_.back().closures == desk_.closures()) progress_.pop_back();
    progress_.push_back({desk_.closures(), cost});
    improved_at_ = desk_.closures();
    watch_.found(cost);
  }
}

void Exploration::try_points(const std::vector<Point>& points) {
  std::vector<PlanRecord*> records;
  std::vector<Point> chosen;
  std::vector<PlanDesk::Wanted> wanted;
  for (const Point& point : points) {
    PlanRecord& record = desk_.record(space_.plan(space_.branches()[point.branch], point.at));
    if (is_out(record) || record.lowest_cost >= to_beat(point.branch)) {
      if (!searches_[point.branch].costs.contains(point.at))
        add_point(searches_[point.branch], point.at,
                  {is_out(record) ? kOut : record.lowest_cost, 0, true});
      continue;
    }
    if (std::ssize(wanted) >= left()) {
      short_ = true;
      break;
    }
    records.push_back(&record);
    chosen.push_back(point);
    if (!record.closures.contains(0)) wanted.push_back({&record, 0});
  }
  desk_.close(wanted, PlanDesk::Phase::Searching);
  for (std::size_t i = 0; i < records.size(); ++i)
    if (records[i]->closures.contains(0)) take(*records[i], chosen[i]);
}

std::vector<PlanRecord*> Exploration::best(int count) const {
  std::vector<const Tried*> order;
  for (const Tried& plan : tried_) order.push_back(&plan);
  std::stable_sort(order.begin(), order.end(), [](const Tried* a, const Tried* b) {
    if (a->rung != b->rung) return a->rung > b->rung;
    return a->expected.cost < b->expected.cost;
  });
  std::vector<bool> seen(searches_.size(), false);
  std::stable_partition(order.begin(), order.end(), [&seen](const Tried* plan) {
    const bool is_first = !seen[plan->branch];
    seen[plan->branch] = true;
    return is_first;
  });
  std::vector<PlanRecord*> plans;
  for (const Tried* plan : order)
    if (std::ssize(plans) < count) plans.push_back(plan->record);
  return plans;
}

std::vector<const PlanRecord*> Exploration::scored() const {
  std::vector<const PlanRecord*> plans;
  for (const Tried& plan : tried_)
    if (kRungs[plan.rung] == kChosenBy) plans.push_back(plan.record);
  return plans;
}

}  // namespace coapt
