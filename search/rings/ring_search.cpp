#include "search/rings/ring_search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <string_view>
#include <utility>

#include "core/repair/rings.h"
#include "search/latin_hypercube.h"
#include "search/nlopt_optimizer.h"
#include "search/random_share.h"

namespace coapt {
namespace {

constexpr std::size_t kTerms = kRingTerms.size();
constexpr double kRacingShare = 0.4, kDescentShare = 0.4, kFinalShare = 0.2;
constexpr int kFirstMembers = 8, kRacingNodes = 3, kStarts = 2, kFewestDesigns = 8;
constexpr int kDescentMembers = 16,
              kDescentCalls = 40;  // of one descent: fewer calls before fewer members
constexpr int kFewestCalls = 2 * static_cast<int>(kTerms + 1) + 1;  // BOBYQA's first model
constexpr double kFirstStep = 0.12, kDescentTolerance = 0.05;
constexpr int kFewestFinalists = 2, kMostFinalists = 8;
constexpr std::array kSizingShares = {0.8, 0.85, 0.9, 0.95, 1.0};
constexpr int kSizingMembers = 32;
constexpr double kUnsewableCost = 4.0, kUnsewableSlope = 50.0;  // above any ring's

/// Shares of the ranges, |7|: the terms, then the sizing rule.
using RingPoint = std::vector<double>;

/// To four decimals, 0.003 mm of a ring: what is reported is what was tried.
double of_range(Range range, double share) {
  return std::round(1e4 * (range.min + share * (range.max - range.min))) * 1e-4 + 0.0;
}
double share_of(Range range, double value) { return (value - range.min) / (range.max - range.min); }

RingDesign design_at(const RingPoint& point, const std::string& name) {
  RingDesign design{{name, {}}, of_range(kRingWidthShares, point[kTerms])};
  for (std::size_t k = 0; k < kTerms; ++k)
    design.shape.terms.*kRingTerms[k].member = of_range(kRingTerms[k].range, point[k]);
  return design;
}

RingPoint point_of(const RingTerms& terms, double width_over_transverse) {
  RingPoint point;
  for (const RingTermRow& row : kRingTerms) point.push_back(share_of(row.range, terms.*row.member));
  point.push_back(share_of(kRingWidthShares, width_over_transverse));
  return point;
}

/// A point whose shape cannot be sewn comes half way to a flat oval, until it can.
RingPoint sewable(RingPoint point) {
  const RingPoint oval = point_of({}, of_range(kRingWidthShares, point[kTerms]));
  while (unsewable(design_at(point, "").shape.terms) > 0.0)
    for (std::size_t k = 0; k < kTerms; ++k) point[k] = 0.5 * (point[k] + oval[k]);
  return point;
}

struct RatedPoint {
  RingPoint point;
  double cost = 0.0;
};

void sort_by_cost(std::vector<RatedPoint>& rated) {
  std::stable_sort(rated.begin(), rated.end(),
                   [](const RatedPoint& a, const RatedPoint& b) { return a.cost < b.cost; });
}

/// Members in an order of their own, lest their order in the population decide.
std::vector<RingMember> shuffled(std::vector<RingMember> members, std::uint64_t seed) {
  std::mt19937_64 engine(seed);
  for (std::size_t left = members.size(); left > 1; --left)
    std::swap(members[left - 1],
              members[static_cast<std::size_t>(static_cast<double>(left) * random_share(engine))]);
  return members;
}

class RingSearch {
 public:
  RingSearch(const RingTrial& trial, const std::vector<RingMember>& members,
             const RingSearchOptions& options)
      : trial_(trial), members_(shuffled(members, options.seed)), options_(options) {
    racing_.opening = descent_.opening = full_.opening = full_.durability = true;
    descent_.disturbances = full_.disturbances = options.disturbances;
    racing_.disturbances = options.disturbances;
    racing_.disturbances.resize(std::min<std::size_t>(racing_.disturbances.size(), kRacingNodes));
  }

  std::optional<RingSearchResult> run(const std::string& name) {
    const std::vector<RatedPoint> raced = race();
    std::vector<RatedPoint> known = descend(raced);
    RingSearchResult result;
    for (const RatedPoint& finalist : finalists(known, raced)) {
      const RingDesign design = design_at(finalist.point, name);
      add({design.shape, design.width_over_transverse}, "final", result);
    }
    result.evaluations = evaluations_;
    result.designs = designs_;
    try_generic(result);
    if (cancelled()) return std::nullopt;
    std::stable_sort(result.rivals.begin(), result.rivals.end(),
                     [](const RatedRing& a, const RatedRing& b) { return a.cost < b.cost; });
    const auto is_designed = [](const RatedRing& ring) {
      return std::holds_alternative<DesignedShape>(ring.candidate.shape);
    };
    const auto best = std::find_if(result.rivals.begin(), result.rivals.end(), is_designed);
    result.design = {std::get<DesignedShape>(best->candidate.shape),
                     best->candidate.width_over_transverse};
    result.cost = best->cost;
    result.generic = *std::find_if_not(result.rivals.begin(), result.rivals.end(), is_designed);
    return result;
  }

 private:
  bool cancelled() const { return options_.cancelled != nullptr && *options_.cancelled; }
  int all() const { return static_cast<int>(members_.size()); }

  /// Over the first `count` members; without meaning once it is cancelled.
  double cost(const RingCandidate& candidate, int count, const RingQuestion& question) {
    if (cancelled()) return 0.0;
    const std::vector<RingMember> asked(members_.begin(), members_.begin() + count);
    return ring_cost(try_ring(trial_, asked, candidate, question, options_.threads),
                     options_.weights);
  }

  double cost_at(const RingPoint& point, int count, const RingQuestion& question,
                 const char* stage) {
    const RingDesign design = design_at(point, "design");
    if (cancelled()) return 0.0;
    if (const double missing = unsewable(design.shape.terms); missing > 0.0)
      return kUnsewableCost + kUnsewableSlope * missing;
    const double found = cost({design.shape, design.width_over_transverse}, count, question);
    evaluations_ += count * price_of(question);
    ++designs_;
    tell(stage, found);
    return found;
  }

  void tell(const char* stage, double found) {
    if (stage_ != stage) best_ = INFINITY;
    stage_ = stage;
    best_ = std::min(best_, found);
    if (options_.progress) options_.progress({stage, evaluations_, options_.evaluations, best_});
  }

  /// Members asked on each rung: twice as many each time, up to all.
  std::vector<int> rungs() const {
    std::vector<int> counts = {std::min(kFirstMembers, all())};
    while (counts.back() < all()) counts.push_back(std::min(2 * counts.back(), all()));
    return counts;
  }

  /// Sorted by cost on the last rung that they came to, later rungs first.
  std::vector<RatedPoint> race() {
    const std::vector<int> counts = rungs();
    const double rung = kRacingShare * options_.evaluations / static_cast<double>(counts.size());
    const int count =
        std::max(kFewestDesigns, static_cast<int>(rung / (counts[0] * price_of(racing_))));
    std::vector<RatedPoint> running;
    for (const RingShape& shape : kRingShapes)
      running.push_back({point_of({.ap_over_transverse = shape.ap_over_transverse}, 0.85)});
    for (RingPoint& point : latin_hypercube(count - static_cast<int>(running.size()),
                                            static_cast<int>(kTerms) + 1, options_.seed))
      running.push_back({sewable(std::move(point))});
    std::vector<RatedPoint> out;
    for (const int members : counts) {
      for (RatedPoint& rated : running)
        rated.cost = cost_at(rated.point, members, racing_, "racing");
      sort_by_cost(running);
      if (members == counts.back()) break;
      const std::size_t left = std::max<std::size_t>((running.size() + 1) / 2, kStarts);
      if (left >= running.size()) continue;
      out.insert(out.begin(), running.begin() + static_cast<Index>(left), running.end());
      running.resize(left);
    }
    running.insert(running.end(), out.begin(), out.end());
    return running;
  }

  /// What the descents came by, sorted; their costs are of the same members.
  std::vector<RatedPoint> descend(const std::vector<RatedPoint>& raced) {
    const int price = price_of(descent_);
    const double all_descents = kDescentShare * options_.evaluations;
    const int few = std::min(kDescentMembers, all());
    const int starts = all_descents < kStarts * kDescentCalls * few * price ? 1 : kStarts;
    const double budget = all_descents / starts;  // of one descent
    const int members = std::clamp(static_cast<int>(budget / (kDescentCalls * price)), few, all());
    const int calls = static_cast<int>(budget / (members * price));
    std::vector<RatedPoint> known;
    if (calls < kFewestCalls) return known;
    for (int start = 0; start < starts; ++start) {
      const BoundedProblem problem{.lower = RingPoint(kTerms + 1, 0.0),
                                   .upper = RingPoint(kTerms + 1, 1.0),
                                   .start = raced[static_cast<std::size_t>(start)].point,
                                   .first_step = RingPoint(kTerms + 1, kFirstStep),
                                   .tolerance = kDescentTolerance,
                                   .most_calls = calls};
      const auto ask = [&](const RingPoint& point) -> std::optional<double> {
        if (cancelled()) return std::nullopt;
        const double found = cost_at(point, members, descent_, "descent");
        if (found < kUnsewableCost) known.push_back({point, found});
        return found;
      };
      minimise(problem, ask, options_.seed);
    }
    sort_by_cost(known);
    return known;
  }

  int sizing_members() const { return std::min(kSizingMembers, all()); }

  /// The same shape by the sizing rule that suits it best: sizes come in steps, over which a descent does not see.
  RingPoint with_best_rule(const RingPoint& point) {
    RatedPoint best{point, cost_at(point, sizing_members(), racing_, "sizing")};
    for (const double share : kSizingShares) {
      RatedPoint other{point};
      other.point[kTerms] = share_of(kRingWidthShares, share);
      other.cost = cost_at(other.point, sizing_members(), racing_, "sizing");
      if (other.cost < best.cost) best = other;
    }
    return best.point;
  }

  /// The best of the descents, by its own and by the best sizing rule, others of them, then the best of the race.
  std::vector<RatedPoint> finalists(const std::vector<RatedPoint>& descended,
                                    const std::vector<RatedPoint>& raced) {
    const double budget = kFinalShare * options_.evaluations;
    const int count = std::clamp(static_cast<int>(budget / (all() * price_of(full_))),
                                 kFewestFinalists, kMostFinalists);
    std::vector<RatedPoint> chosen(
        descended.begin(), descended.begin() + std::min<Index>(count - 1, std::ssize(descended)));
    for (const RatedPoint& point : raced)
      if (std::ssize(chosen) < count) chosen.push_back(point);
    const RingPoint sized = with_best_rule(chosen.front().point);
    if (sized != chosen.front().point) chosen.push_back({sized});
    return chosen;
  }

  void add(const RingCandidate& candidate, const char* stage, RingSearchResult& result) {
    const double found = cost(candidate, all(), full_);
    evaluations_ += all() * price_of(full_);
    tell(stage, found);
    result.rivals.push_back({candidate, found});
  }

  /// The best sizing rule of each shape, then everything of that on all members.
  void try_generic(RingSearchResult& result) {
    for (const RingShape& shape : kRingShapes) {
      RatedRing best{{}, INFINITY};
      for (const double share : kSizingShares) {
        const RingCandidate candidate{std::string(shape.name), share};
        const double found = cost(candidate, sizing_members(), racing_);
        tell("generic", found);
        if (found < best.cost) best = {candidate, found};
      }
      add(best.candidate, "generic", result);
    }
  }

  const RingTrial& trial_;
  std::vector<RingMember> members_;
  const RingSearchOptions& options_;
  RingQuestion racing_, descent_, full_;
  std::string_view stage_;
  double best_ = INFINITY;
  int evaluations_ = 0, designs_ = 0;
};

}  // namespace

std::optional<RingSearchResult> search_ring(const RingTrial& trial,
                                            const std::vector<RingMember>& members,
                                            const std::string& name,
                                            const RingSearchOptions& options) {
  return RingSearch(trial, members, options).run(name);
}

}  // namespace coapt
