#include "search/plans/verdict.h"

#include <algorithm>

#include "core/closed/diagnosis.h"
#include "core/repair/approximation.h"
#include "core/valve/number_text.h"
#include "search/plans/plan_order.h"

namespace coapt {
namespace {

/// Of the papillary suture, where a plan has one alone; else null.
const PapillaryApproximation* only_suture(const RepairPlan& plan) {
  const PapillaryApproximation* const al = suture_of(plan, Side::Anterolateral);
  const PapillaryApproximation* const pm = suture_of(plan, Side::Posteromedial);
  return al && pm ? nullptr : al ? al : pm;
}

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

/// Which anchors of the same muscle are in the first plan's class; empty if there is but one.
std::string anchors_of_class(const std::vector<RankedPlan>& plans) {
  const PapillaryApproximation* const own = only_suture(plans.front().plan);
  if (!own) return "";
  std::string others;
  std::vector<Anchor> seen = {own->anchor};
  for (const RankedPlan& plan : plans) {
    const PapillaryApproximation* const suture = only_suture(plan.plan);
    if (plan.of_class != plans.front().of_class || !suture || suture->side != own->side ||
        std::find(seen.begin(), seen.end(), suture->anchor) != seen.end())
      continue;
    seen.push_back(suture->anchor);
    others += (others.empty() ? "" : " and ") + anchor_words(suture->anchor) + " (plan " +
              std::to_string(plan.rank) + ")";
  }
  if (others.empty()) return "";
  return " Its anchor is " + anchor_words(own->anchor) + "; " + others +
         (seen.size() > 2 ? " do" : " does") + " as well.";
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
  return who + " " + likely + ", over errors of the hand, tissue and mesh." +
         anchors_of_class(plans) + choice_of(plans);
}

}  // namespace coapt
