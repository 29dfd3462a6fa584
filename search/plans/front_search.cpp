#include "search/plans/front_search.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <span>

#include "search/parallel.h"
#include "search/plans/durability.h"
#include "search/plans/place_model.h"
#include "search/random_share.h"

namespace coapt {
namespace {

constexpr int kAtFirst = 4, kAtOnce = 2;
constexpr double kScatters = 2.0;      // better than expected
constexpr double kLeastShare = 0.001;  // of the volume: then nothing more is expected
constexpr int kDoubts = 3;  // times that a few at random are measured before that is believed
constexpr std::size_t kMostKnown = 200;        // plans that the models take
constexpr double kUnknownOpening_mm2 = 100.0;  // above the least, while none is known
// What these differ by from plan to plan; the leak as its asinh.
constexpr double kUsualLeak = 1.5, kUsualOpening_mm2 = 100.0, kUsualDurability_mm = 4.0;
constexpr double kMostLeak_mm2 = 100.0;  // for closures that failed, too

/// A plan with what is known of it.
struct Known {
  const PlanRecord* plan = nullptr;
  double leak = 0.0;  ///< asinh(mm2), over the nodes closed
  std::optional<double> opening_mm2, durability_mm;
};

/// @pre closed as planned.
Known known_of(const PlanRecord& plan) {
  int nodes = 0;
  while (nodes < kChosenBy && plan.closures.contains(nodes)) ++nodes;
  const double mm2 = region_leak_mm2(plan, nodes);
  Known known{
      &plan, std::asinh(std::isnan(mm2) ? kMostLeak_mm2 : std::min(mm2, kMostLeak_mm2)), {}, {}};
  if (plan.opening && trusted(*plan.opening))
    known.opening_mm2 = plan.opening->measure.opening_area_mm2;
  if (const auto lasts = durability(plan)) known.durability_mm = lasts->expected_mm;
  return known;
}

/// Models of what is known.
class Expectations {
 public:
  /// Of the last kMostKnown.
  explicit Expectations(const std::vector<Known>& known)
      : leak_(model(known, kUsualLeak, [](const Known& one) { return std::optional(one.leak); })),
        opening_(model(known, kUsualOpening_mm2, [](const Known& one) { return one.opening_mm2; })),
        durability_(model(known, kUsualDurability_mm,
                          [](const Known& one) { return one.durability_mm; })) {}

  TradeOff at(const Eigen::VectorXd& place, double scatters) const {
    const PlaceModel::Guess leak = leak_->at(place);
    TradeOff expected = {std::max(0.0, std::sinh(leak.mean - scatters * leak.sd)),
                         kWorstAccepted.opening_mm2 + kUnknownOpening_mm2, kFurthestCourse_mm};
    if (opening_) {
      const PlaceModel::Guess opening = opening_->at(place);
      expected.opening_mm2 = opening.mean + scatters * opening.sd;
    }
    if (durability_) {
      const PlaceModel::Guess lasts = durability_->at(place);
      expected.durability_mm =
          std::clamp(lasts.mean + scatters * lasts.sd, 0.0, kFurthestCourse_mm);
    }
    return expected;
  }

 private:
  template <class Value>
  static std::optional<PlaceModel> model(const std::vector<Known>& known, double usual_sd,
                                         Value value) {
    std::vector<Eigen::VectorXd> places;
    std::vector<double> values;
    const std::size_t first = known.size() - std::min(known.size(), kMostKnown);
    for (const Known& one : std::span(known).subspan(first))
      if (const std::optional<double> of = value(one)) {
        places.push_back(one.plan->place);
        values.push_back(*of);
      }
    if (values.empty()) return std::nullopt;
    const auto n = static_cast<Eigen::Index>(values.size());
    return PlaceModel(std::move(places), Eigen::Map<const Eigen::VectorXd>(values.data(), n),
                      usual_sd);
  }

  std::optional<PlaceModel> leak_, opening_, durability_;
};

/// A few scatters better than expected, as far as what is known of the plan allows.
TradeOff at_best(const Expectations& expected, const PlanRecord& plan) {
  TradeOff may = expected.at(plan.place, kScatters);
  if (!plan.closures.contains(0)) return may;
  const Known known = known_of(plan);
  may.leak_mm2 = std::max(may.leak_mm2, std::sinh(known.leak));
  if (plan.opening) may.opening_mm2 = known.opening_mm2.value_or(0.0);
  may.durability_mm = std::min(may.durability_mm, most_durable_mm(plan));
  return may;
}

double improvement(std::vector<TradeOff> front, double volume, const TradeOff& by) {
  if (by.leak_mm2 >= kWorstAccepted.leak_mm2 || by.opening_mm2 <= kWorstAccepted.opening_mm2)
    return 0.0;
  front.push_back(by);
  return dominated_volume(front) - volume;
}

std::vector<PlanRecord*> at_random(std::vector<PlanRecord*> plans, int count, std::uint64_t seed) {
  std::mt19937_64 engine(seed);
  for (std::size_t i = 0; i < plans.size(); ++i) {
    const auto left = static_cast<double>(plans.size() - i);
    std::swap(plans[i], plans[i + static_cast<std::size_t>(random_share(engine) * left)]);
  }
  if (std::ssize(plans) > count) plans.resize(static_cast<std::size_t>(count));
  return plans;
}

/// Those that are expected to add most, the second as if the first were as expected.
std::vector<PlanRecord*> most_promising(const std::vector<PlanRecord*>& left,
                                        std::vector<Known> known, std::vector<TradeOff> front,
                                        Expectations expected, int threads) {
  std::vector<PlanRecord*> chosen;
  std::vector<double> adds(left.size());
  while (std::ssize(chosen) < std::min<std::ptrdiff_t>(kAtOnce, std::ssize(left))) {
    const double volume = dominated_volume(front);
    for_each_index(static_cast<int>(left.size()), threads, [&](int i) {
      adds[i] = improvement(front, volume, at_best(expected, *left[i]));
    });
    for (PlanRecord* plan : chosen)
      adds[std::find(left.begin(), left.end(), plan) - left.begin()] = 0.0;
    const auto best = std::max_element(adds.begin(), adds.end());
    if (*best <= kLeastShare * volume) break;
    chosen.push_back(left[best - adds.begin()]);
    if (std::ssize(chosen) == kAtOnce) break;
    const TradeOff middle = expected.at(chosen.back()->place, 0.0);
    known.push_back(
        {chosen.back(), std::asinh(middle.leak_mm2), middle.opening_mm2, middle.durability_mm});
    if (improvement(front, volume, middle) > 0.0) front.push_back(middle);
    expected = Expectations(known);
  }
  return chosen;
}

/// Measures plans by and by, each as long as it may still add something. False if it was stopped.
bool measure(PlanEvaluations& evaluations, std::vector<PlanRecord*> plans,
             const Expectations& expected, const std::vector<TradeOff>& front) {
  const double volume = dominated_volume(front);
  const auto leave = [&] {
    std::erase_if(plans, [&](const PlanRecord* plan) {
      return improvement(front, volume, at_best(expected, *plan)) <= kLeastShare * volume;
    });
  };
  for (const int upto : kRungs) {
    std::vector<PlanEvaluations::Wanted> wanted;
    for (PlanRecord* plan : plans)
      for (int d = 0; d < upto; ++d) wanted.push_back({plan, d});
    if (!evaluations.close(wanted, PlanEvaluations::Phase::Searching)) return false;
    leave();
  }
  if (!evaluations.open(plans, PlanEvaluations::Phase::Searching)) return false;
  leave();
  for (int step = 0; step <= kCourseSteps; ++step) {
    if (!close_disease_step(evaluations, plans, PlanEvaluations::Phase::Searching)) return false;
    leave();
  }
  return true;
}

}  // namespace

std::vector<FrontPlan> search_front(PlanEvaluations& evaluations,
                                    const std::vector<PlanRecord*>& candidates,
                                    const FrontSearchOptions& options) {
  const int closures_before = evaluations.closures(), openings_before = evaluations.openings();
  std::vector<PlanRecord*> left;
  std::vector<FrontPlan> asked;
  std::vector<Known> known;
  std::vector<TradeOff> front;
  const auto learn = [&](PlanRecord& plan) {
    std::erase_if(known, [&](const Known& one) { return one.plan == &plan; });
    known.push_back(known_of(plan));
    const std::optional<TradeOff> found = trade_off(plan, kChosenBy);
    if (found && improvement(front, dominated_volume(front), *found) > 0.0) front.push_back(*found);
    asked.push_back({&plan, evaluations.closures() - closures_before,
                     evaluations.openings() - openings_before});
  };
  for (PlanRecord* plan : candidates) {
    if (trade_off(*plan, kChosenBy)) {
      learn(*plan);
      continue;
    }
    const bool scored = !std::isnan(region_leak_mm2(*plan, kChosenBy));
    if (scored) known.push_back(known_of(*plan));
    const double leak = region_leak_mm2(*plan, scored ? kChosenBy : 1);
    if (std::isnan(leak) || leak < kWorstAccepted.leak_mm2) left.push_back(plan);
  }
  for (int doubts = 0; !left.empty();) {
    const bool few = std::ssize(known) < kAtFirst;
    const int most = (kChosenBy + kDisease.count) * (few ? kAtFirst : kAtOnce);
    if (evaluations.closures() - closures_before + most > options.closures) break;
    std::optional<Expectations> expected;
    std::vector<PlanRecord*> next;
    if (!few) {
      expected.emplace(known);
      next = most_promising(left, known, front, *expected, evaluations.threads());
    }
    const bool adds = !next.empty();
    if (!adds) {
      if (!few && ++doubts > kDoubts) break;
      next = at_random(left, few ? kAtFirst : kAtOnce,
                       options.seed + static_cast<std::uint64_t>(doubts));
    }
    const bool measured =
        adds ? measure(evaluations, next, *expected, front)
             : measure_trade_offs(evaluations, next, kChosenBy, PlanEvaluations::Phase::Searching);
    for (PlanRecord* plan : next)
      if (plan->closures.contains(0)) learn(*plan);
    if (!measured) break;
    std::erase_if(left, [&](const PlanRecord* plan) {
      return std::find(next.begin(), next.end(), plan) != next.end();
    });
  }
  return asked;
}

}  // namespace coapt
