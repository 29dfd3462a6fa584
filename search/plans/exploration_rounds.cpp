#include <algorithm>
#include <random>
#include <set>

#include "search/parallel.h"
#include "search/plans/exploration.h"
#include "search/plans/region_report.h"
#include "search/random_share.h"

namespace coapt {
namespace {

constexpr int kLastRung = static_cast<int>(std::size(kRungs)) - 1;
constexpr std::uint64_t kGolden = 0x9e3779b97f4a7c15;  // keeps seeds of branches apart
constexpr int kHopeful = 4;  // one branch in so many is refined for what it could cost at best
constexpr std::size_t kMeasured = 12;  // plans on all rungs

}  // namespace

void Exploration::try_random(int count) {
  std::vector<std::int64_t> upto;
  std::int64_t all = 0;
  for (const Branch& branch : space_.branches()) upto.push_back(all += point_count(branch));
  std::mt19937_64 engine(options_.seed);
  std::vector<Point> points;
  for (int i = 0; i < count; ++i) {
    const auto number = static_cast<std::int64_t>(random_share(engine) * static_cast<double>(all));
    const auto branch =
        static_cast<std::size_t>(std::upper_bound(upto.begin(), upto.end(), number) - upto.begin());
    const Branch& of = space_.branches()[branch];
    points.push_back({branch, point_at(of, number - upto[branch] + point_count(of))});
  }
  std::vector<PlanDesk::Wanted> wanted;
  std::vector<PlanRecord*> records;
  for (const Point& point : points) {
    records.push_back(&desk_.record(space_.plan(space_.branches()[point.branch], point.at)));
    if (!is_out(*records.back()) && !records.back()->closures.contains(0))
      wanted.push_back({records.back(), 0});
  }
  if (!desk_.close(wanted, PlanDesk::Phase::Searching)) return;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (is_out(*records[i])) continue;
    random_.push_back(records[i]);
    take(*records[i], points[i]);
  }
  std::vector<double> costs;
  for (const Progress& expected : random_progress()) costs.push_back(expected.cost);
  watch_.expect_of_random(std::move(costs));
}

void Exploration::measure_ladder() {
  std::vector<const PlanRecord*> order = random_;
  std::stable_sort(order.begin(), order.end(), [this](const PlanRecord* a, const PlanRecord* b) {
    return desk_.cost(*a, 1) < desk_.cost(*b, 1);
  });
  std::set<const PlanRecord*> seen;
  std::erase_if(order,
                [&](const PlanRecord* plan) {  // those that climbed would be guessed by themselves
                  return !seen.insert(plan).second || tried_[index_.at(plan)].rung > 0;
                });
  order.resize(order.size() / 2);
  if (order.size() < kMeasured || left() < static_cast<int>(kMeasured) * (kChosenBy - 1)) return;
  std::vector<std::size_t> climbing;
  for (std::size_t k = 0; k < kMeasured; ++k) {
    climbing.push_back(index_.at(order[k * order.size() / kMeasured]));
    const Tried& plan = tried_[climbing.back()];
    guessed_.push_back(plan.expected.cost);
  }
  climb(climbing, kLastRung);
  learn();
  for (const std::size_t i : climbing)
    if (tried_[i].rung == kLastRung) measured_.push_back(tried_[i].record);
  if (measured_.size() < kMeasured) measured_.clear();  // stopped
}

void Exploration::climb(const std::vector<std::size_t>& climbing, int to_rung) {
  std::vector<PlanDesk::Wanted> wanted;
  for (const std::size_t i : climbing)
    for (int d = kRungs[tried_[i].rung]; d < kRungs[std::max(to_rung, tried_[i].rung)]; ++d)
      wanted.push_back({tried_[i].record, d});
  if (!desk_.close(wanted, PlanDesk::Phase::Searching)) return;
  for (const std::size_t i : climbing) {
    Tried& plan = tried_[i];
    plan.rung = std::max(to_rung, plan.rung);
    plan.expected = expected(*plan.record, plan.rung);
    double& best = best_scored_[plan.branch];
    if (kRungs[plan.rung] != kChosenBy || plan.expected.cost >= best) continue;
    best = plan.expected.cost;
    if (scored_progress_.empty() || best < scored_progress_.back().cost) {
      scored_progress_.push_back({desk_.closures(), best});
      improved_at_ = desk_.closures();
    }
    const RegionReport region = region_report(*plan.record, kChosenBy);
    if (region.failures == 0 && region.leak_mm2.mean + region.leak_mm2.sd <= options_.target_mm2)
      stop_ = SearchStop::TargetReached;
  }
  update_to_beat();
}

void Exploration::sprint() {
  std::size_t best = tried_.size();
  for (std::size_t i = 0; i < tried_.size(); ++i)
    if (best == tried_.size() || tried_[i].expected.cost < tried_[best].expected.cost) best = i;
  if (best == tried_.size() || kRungs[tried_[best].rung] == kChosenBy || left() < kChosenBy) return;
  climb({best}, kLastRung);
  learn();
}

void Exploration::race(int most, double optimism) {
  for (int done = 0; done < most && !over();) {
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < tried_.size(); ++i)
      if (tried_[i].rung + 1 < std::ssize(kRungs) &&
          ClimbModel::least(tried_[i].expected, optimism) < to_beat(tried_[i].branch))
        order.push_back(i);
    std::stable_sort(order.begin(), order.end(), [this](std::size_t a, std::size_t b) {
      return tried_[a].expected.cost < tried_[b].expected.cost;
    });
    // The best of as many branches as race at once.
    std::vector<std::size_t> racing;
    int closures = 0;
    for (const std::size_t i : order) {
      const int more = kRungs[tried_[i].rung + 1] - kRungs[tried_[i].rung];
      const bool same = std::any_of(racing.begin(), racing.end(), [&](std::size_t r) {
        return tried_[r].branch == tried_[i].branch;
      });
      if (same) continue;
      if (closures + more > left()) {
        short_ = true;
        break;
      }
      if (std::ssize(racing) == std::min(kRaceBatch, most - done)) break;
      racing.push_back(i);
      closures += more;
    }
    if (racing.empty()) break;
    const auto before = desk_.closures();
    for (int rung = kLastRung; rung > 0; --rung) {  // from above: one step each
      std::vector<std::size_t> here;
      for (const std::size_t i : racing)
        if (tried_[i].rung + 1 == rung) here.push_back(i);
      climb(here, rung);
    }
    if (desk_.closures() == before) break;  // stopped
    done += static_cast<int>(racing.size());
  }
  learn();
}

std::vector<std::size_t> Exploration::by_cost() const {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < searches_.size(); ++i)
    if (!searches_[i].costs.empty() && !is_exhausted(searches_[i]) && !idle_[i] &&
        lowest_[i] < to_beat(i))
      order.push_back(i);
  std::stable_sort(order.begin(), order.end(), [this](std::size_t a, std::size_t b) {
    return searches_[a].best_cost < searches_[b].best_cost;
  });
  return order;
}

void Exploration::refine_best(int count, int quota) {
  const std::vector<std::size_t> likely = by_cost();
  std::vector<std::size_t> chosen;
  const auto fill = [&](const std::vector<std::size_t>& order, int upto) {
    for (const std::size_t i : order)
      if (std::ssize(chosen) < upto && std::find(chosen.begin(), chosen.end(), i) == chosen.end())
        chosen.push_back(i);
  };
  std::vector<std::size_t> possible = likely;
  std::stable_sort(possible.begin(), possible.end(),
                   [this](std::size_t a, std::size_t b) { return lowest_[a] < lowest_[b]; });
  fill(likely, count - count / kHopeful);
  fill(possible, count);
  const int each = std::min(quota, left() / std::max(1, static_cast<int>(chosen.size())));
  short_ = short_ || (!chosen.empty() && each < 1);
  if (chosen.empty() || each < 1) return;
  std::vector<std::vector<std::pair<PlanRecord*, LatticePoint>>> found(chosen.size());
  for_each_index(static_cast<int>(chosen.size()), options_.threads, [&](int k) {
    const auto slot = static_cast<std::size_t>(k);
    const std::size_t i = chosen[slot];
    const TryPoint try_point = [&](const Branch& branch,
                                   const LatticePoint& at) -> std::optional<PointCost> {
      PlanRecord& record = desk_.record(space_.plan(branch, at));
      if (is_out(record)) return PointCost{kOut, 0, true};
      if (record.lowest_cost >= to_beat(i)) return PointCost{record.lowest_cost, 0, true};
      const bool is_new = !record.closures.contains(0);
      if (!desk_.close_here(record, 1)) return std::nullopt;
      found[slot].emplace_back(&record, at);
      return PointCost{expected(record, 0).cost, is_new ? 1 : 0, false};
    };
    refine(searches_[i], each, options_.seed + i * kGolden, try_point);
  });
  for (std::size_t k = 0; k < chosen.size(); ++k) {
    idle_[chosen[k]] = found[k].empty();
    for (const auto& [record, at] : found[k]) take(*record, {chosen[k], at});
  }
}

void Exploration::lend() {
  std::vector<Point> points;
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < searches_.size(); ++i)
    if (!searches_[i].costs.empty()) order.push_back(i);
  std::stable_sort(order.begin(), order.end(), [this](std::size_t a, std::size_t b) {
    return searches_[a].best_cost < searches_[b].best_cost;
  });
  if (std::ssize(order) > options_.plans) order.resize(static_cast<std::size_t>(options_.plans));
  for (const std::size_t from : order)
    for (std::size_t to = 0; to < searches_.size(); ++to) {
      const Branch &a = *searches_[from].branch, &b = *searches_[to].branch;
      if (differences(a.choice, b.choice) != 1) continue;
      const LatticePoint at = lent(a, searches_[from].best, b);
      if (!searches_[to].costs.contains(at)) points.push_back({to, at});
    }
  try_points(points);
}

}  // namespace coapt
