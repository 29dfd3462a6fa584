#include "search/plans/verdict.h"

#include <algorithm>
#include <cmath>

#include "core/closed/diagnosis.h"
#include "core/valve/number_text.h"
#include "search/plans/plan_order.h"

namespace coapt {
namespace {

std::string anchor_words(Anchor anchor) {
  switch (anchor) {
    case Anchor::IpsilateralTrigone:
      return "the trigone";
    case Anchor::SaddlePeak:
      return "the saddle peak";
    case Anchor::AnnulusPoint:
      return "a free point of the annulus";
  }
  return "";
}

/// Of a mean leak, within less than which two are alike.
std::string tenths_above(double leak_mm2) {
  return with_decimals(std::max(0.1, std::ceil(10.0 * leak_mm2) / 10.0), 1) + " mm²";
}

/// Where its papillary sutures are anchored, and what the other anchor would change; empty without such figures.
std::string anchors_of(const RankedPlan& plan) {
  std::string words;
  for (const OtherAnchor& anchor : plan.other_anchors) {
    const double apart = std::abs(anchor.more_mm2);
    words += std::string(" The anchor of the ") + to_string(anchor.side) + " muscle is " +
             anchor_words(anchor.anchor) + "; " + anchor_words(anchor.other) +
             (apart < kTraceLeak_mm2 ? " is equal within " + tenths_above(apart) + " of leak"
                                     : " leaks " + with_decimals(apart, 1) + " mm² " +
                                           (anchor.more_mm2 > 0.0 ? "more" : "less")) +
             ", over errors of the hand.";
  }
  return words;
}

/// Which plans come first in other settings of the thresholds; empty if none does.
std::string choice_of(const std::vector<RankedPlan>& plans) {
  std::string others;
  for (const RankedPlan& plan : plans)
    if (plan.rank > 1 && plan.times_first > 0)
      others += (others.empty() ? "plan " : ", plan ") + std::to_string(plan.rank) + " in " +
                std::to_string(plan.times_first);
  if (others.empty()) return "";
  return " Which plan comes first depends on thresholds that no measurement fixes: plan 1 does "
         "in " +
         std::to_string(plans.front().times_first) + " of " +
         std::to_string(threshold_settings().size()) + " settings, " + others +
         ". Take it as a choice.";
}

/// To a tenth near all and nothing, as tables print it.
std::string percent_words(double share) {
  const double value = 100.0 * share;
  const bool near_an_end = (value > 0.0 && value < 10.0) || (value > 90.0 && value < 100.0);
  return with_decimals(value, near_an_end ? 1 : 0) + " %";
}

}  // namespace

std::string verdict_of(const std::vector<RankedPlan>& plans) {
  if (plans.empty()) return "";
  const RankedPlan& first = plans.front();
  const std::string likely = "leaks less than " + shown(kMildLeak_mm2) +
                             " mm² with a probability of " +
                             percent_words(first.acceptable_probability);
  if (first.plan.steps.empty())
    return "As it is the valve " + likely + ", over what is not known of tissue and mesh" +
           (first.is_acceptable ? ": no operation is needed." : ".");
  if (first.region.closures < 2)
    return "It is not known whether a plan is acceptable: none was closed under errors of the "
           "hand.";
  if (!first.is_acceptable) return "No plan is acceptable: the first one " + likely + ".";
  const auto alike = std::count_if(plans.begin(), plans.end(), [&](const RankedPlan& plan) {
    return plan.of_class == first.of_class;
  });
  const std::string who = alike > 1
                              ? "Plans 1 to " + std::to_string(alike) +
                                    " cannot be told apart; plan 1 is the simplest of them. It"
                              : std::string("Plan 1");
  return who + " " + likely + ", over errors of the hand, tissue and mesh." + anchors_of(first) +
         choice_of(plans);
}

}  // namespace coapt
