// What plans trade: leak over the region, opening in diastole, durability. How much of what can be had a set of plans reaches is the volume that
// they dominate (Zitzler and Thiele 1999).
#pragma once

#include <optional>
#include <span>

#include "search/plans/plan_evaluations.h"

namespace coapt {

struct TradeOff {
  double leak_mm2 = 0.0;  ///< mean + sd; less is better
  double opening_mm2 = 0.0, durability_mm = 0.0;

  bool operator==(const TradeOff&) const = default;
};

/// A repair that practice accepts is better than this in leak and opening, and no worse in durability.
inline constexpr TradeOff kWorstAccepted = {kMildLeak_mm2, kStenosis_mm2, 0.0};

/// mean + sd over the first nodes of the region; of one node its leak. NaN if one is missing or failed.
double region_leak_mm2(const PlanRecord& plan, int nodes);

/// Of a plan closed at `nodes` of the region, opened, and closed under the courses of disease. None if something is missing, failed, or is not
/// better than kWorstAccepted: such a plan adds no volume.
std::optional<TradeOff> trade_off(const PlanRecord& plan, int nodes);

/// mm2 x mm2 x mm between kWorstAccepted and what the plans reach: what at least one of them is as good as.
double dominated_volume(std::span<const TradeOff> plans);

/// Closes a plan at `nodes` of the region, opens it and closes it under the courses of disease, as far as trade_off() asks: no further once the
/// plan leaks too much or opens too little. False if it was stopped.
bool measure_trade_offs(PlanEvaluations& evaluations, std::span<PlanRecord* const> plans, int nodes,
                        PlanEvaluations::Phase phase);

}  // namespace coapt
