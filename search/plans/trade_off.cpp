#include "search/plans/trade_off.h"

#include <algorithm>
#include <limits>
#include <vector>

#include "search/plans/durability.h"
#include "search/plans/region_report.h"

namespace coapt {
namespace {

bool is_accepted(const PlanRecord& plan, int nodes) {
  return region_leak_mm2(plan, nodes) < kWorstAccepted.leak_mm2;
}

bool opens_enough(const PlanRecord& plan) {
  return plan.opening && trusted(*plan.opening) &&
         plan.opening->measure.opening_area_mm2 > kWorstAccepted.opening_mm2;
}

/// Between the axes and steps down from plan to plan, of leak and opening alone.
double dominated_area(std::span<const TradeOff> plans) {
  std::vector<TradeOff> order(plans.begin(), plans.end());
  std::sort(order.begin(), order.end(),
            [](const TradeOff& a, const TradeOff& b) { return a.leak_mm2 < b.leak_mm2; });
  double area = 0.0, opening = kWorstAccepted.opening_mm2;
  for (const TradeOff& plan : order) {
    if (plan.opening_mm2 <= opening) continue;
    area += (kWorstAccepted.leak_mm2 - plan.leak_mm2) * (plan.opening_mm2 - opening);
    opening = plan.opening_mm2;
  }
  return area;
}

}  // namespace

double region_leak_mm2(const PlanRecord& plan, int nodes) {
  for (int d = 0; d < nodes; ++d)
    if (const auto found = plan.closures.find(d);
        found == plan.closures.end() || !trusted(found->second))
      return std::numeric_limits<double>::quiet_NaN();
  const LeakStatistics leak = leak_statistics(plan, nodes);
  return nodes == 1 ? leak.nominal : leak.mean + leak.sd;
}

std::optional<TradeOff> trade_off(const PlanRecord& plan, int nodes) {
  if (!is_accepted(plan, nodes) || !opens_enough(plan)) return std::nullopt;
  const std::optional<Durability> lasts = durability(plan);
  if (!lasts) return std::nullopt;
  return TradeOff{region_leak_mm2(plan, nodes), plan.opening->measure.opening_area_mm2,
                  lasts->expected_mm};
}

double dominated_volume(std::span<const TradeOff> plans) {
  std::vector<TradeOff> order(plans.begin(), plans.end());
  std::sort(order.begin(), order.end(),
            [](const TradeOff& a, const TradeOff& b) { return a.durability_mm > b.durability_mm; });
  double volume = 0.0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const double below =
        i + 1 < order.size() ? order[i + 1].durability_mm : kWorstAccepted.durability_mm;
    if (order[i].durability_mm > below)
      volume += (order[i].durability_mm - below) * dominated_area(std::span(order).first(i + 1));
  }
  return volume;
}

bool measure_trade_offs(PlanEvaluations& evaluations, std::span<PlanRecord* const> plans, int nodes,
                        PlanEvaluations::Phase phase) {
  std::vector<PlanRecord*> left(plans.begin(), plans.end());
  for (const int upto : {1, nodes}) {
    std::vector<PlanEvaluations::Wanted> wanted;
    for (PlanRecord* plan : left)
      for (int d = 0; d < upto; ++d) wanted.push_back({plan, d});
    if (!evaluations.close(wanted, phase)) return false;
    std::erase_if(left, [&](const PlanRecord* plan) { return !is_accepted(*plan, upto); });
  }
  if (!evaluations.open(left, phase)) return false;
  std::erase_if(left, [](const PlanRecord* plan) { return !opens_enough(*plan); });
  return close_disease(evaluations, left, phase);
}

}  // namespace coapt
