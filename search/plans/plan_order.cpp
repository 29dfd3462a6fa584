#include "search/plans/plan_order.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "core/closed/diagnosis.h"
#include "search/plans/plan_opening.h"

namespace coapt {
namespace {

bool is_simpler(const PlanMerits& a, const PlanMerits& b) {
  const auto merits = [](const PlanMerits& plan) {
    return std::tuple(plan.steps, plan.muscles, plan.free_anchors, plan.resections,
                      std::lround(plan.sizes_below), std::max(kTraceLeak_mm2, plan.leak_mm2),
                      std::isnan(plan.durability_mm) ? 0.0 : -tenths(plan.durability_mm),
                      std::isnan(plan.gradient_mmhg) ? 0.0 : tenths(plan.gradient_mmhg), plan.cost);
  };
  return merits(a) < merits(b);
}

/// Takes the best class from `left` (acceptable plans of one tier), the simplest first.
std::vector<int> take_class(const std::vector<PlanMerits>& plans, std::vector<int>& left,
                            const OrderThresholds& thresholds) {
  double longest = -std::numeric_limits<double>::infinity();
  for (const int i : left) longest = std::fmax(longest, plans[i].durability_mm);
  const double long_mm =
      std::min(longest - thresholds.same_durability_mm, thresholds.enough_durability_mm);
  const auto lasts = [&](int i) { return !(plans[i].durability_mm < long_mm); };
  double least = std::numeric_limits<double>::infinity();
  for (const int i : left)
    if (lasts(i)) least = std::fmin(least, plans[i].gradient_mmhg);
  const double most = std::max(kUsualGradient_mmhg, least + thresholds.same_gradient_mmhg);
  const auto rest = std::stable_partition(left.begin(), left.end(), [&](int i) {
    return !(lasts(i) && !(plans[i].gradient_mmhg > most));
  });
  std::vector<int> taken(rest, left.end());
  left.erase(rest, left.end());
  std::stable_sort(taken.begin(), taken.end(),
                   [&](int a, int b) { return is_simpler(plans[a], plans[b]); });
  return taken;
}

}  // namespace

std::vector<OrderThresholds> threshold_settings() {
  std::vector<OrderThresholds> settings;
  for (const double acceptable : {0.90, kAcceptable, 0.98})
    for (const auto& [same_mm, enough_mm] : {std::pair{3.0, 5.0}, {2.0, 6.5}, {1.0, 8.0}})
      for (const double gradient_mmhg : {0.5, 1.0, 2.0})
        settings.push_back({acceptable, same_mm, gradient_mmhg, enough_mm});
  return settings;
}

bool is_acceptable(const PlanMerits& plan, double acceptable) {
  return plan.trusted && plan.varied && !plan.fails_often && !plan.rejected && !plan.stenotic &&
         !(plan.gradient_mmhg > kStenosis_mmhg) && plan.acceptable_probability >= acceptable &&
         plan.closes_finely;
}

PlanTier tier_of(const PlanMerits& plan, double acceptable) {
  if (plan.rejected) return PlanTier::Rejected;
  if (!plan.trusted) return PlanTier::Untrusted;
  if (plan.fails_often) return PlanTier::FailsOften;
  if (plan.stenotic) return PlanTier::Stenotic;
  if (!is_acceptable(plan, acceptable)) return PlanTier::NotAcceptable;
  return plan.avoidable_warnings > 0 ? PlanTier::Warned : PlanTier::Acceptable;
}

const char* to_string(PlanTier tier) {
  switch (tier) {
    case PlanTier::Acceptable:
      return "acceptable";
    case PlanTier::Warned:
      return "warned";
    case PlanTier::NotAcceptable:
      return "not_acceptable";
    case PlanTier::Stenotic:
      return "stenotic";
    case PlanTier::FailsOften:
      return "fails_often";
    case PlanTier::Untrusted:
      return "untrusted";
    case PlanTier::Rejected:
      return "rejected";
  }
  return "";
}

std::vector<PlanPlace> order_of(const std::vector<PlanMerits>& plans, bool by_price,
                                const OrderThresholds& thresholds) {
  std::vector<PlanPlace> order;
  int of_class = 0;
  for (int tier = 0; tier < kPlanTiers; ++tier) {
    const auto now = static_cast<PlanTier>(tier);
    std::vector<int> left;
    for (int i = 0; i < std::ssize(plans); ++i)
      if (const PlanTier of = tier_of(plans[i], thresholds.acceptable);
          (by_price && of == PlanTier::Warned ? PlanTier::Acceptable : of) == now)
        left.push_back(i);
    if (now > PlanTier::Warned || by_price) {
      std::stable_sort(left.begin(), left.end(), [&](int a, int b) {
        if (!by_price && plans[a].acceptable_probability != plans[b].acceptable_probability)
          return plans[a].acceptable_probability > plans[b].acceptable_probability;
        return plans[a].cost < plans[b].cost;
      });
      for (const int i : left) order.push_back({i, ++of_class});
      continue;
    }
    while (!left.empty()) {
      ++of_class;
      for (const int i : take_class(plans, left, thresholds)) order.push_back({i, of_class});
    }
  }
  return order;
}

std::vector<int> times_first(const std::vector<PlanMerits>& plans) {
  std::vector<int> times(plans.size());
  if (plans.empty()) return times;
  for (const OrderThresholds& thresholds : threshold_settings())
    ++times[order_of(plans, false, thresholds).front().index];
  return times;
}

}  // namespace coapt
