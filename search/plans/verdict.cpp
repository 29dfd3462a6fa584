#include "search/plans/verdict.h"

#include <algorithm>
#include <cmath>

#include "core/closed/diagnosis.h"
#include "core/valve/number_text.h"
#include "search/plans/plan_opening.h"
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
    words +=
        std::string(" The ") + to_string(anchor.side) + " papillary muscle is anchored to " +
        anchor_words(anchor.anchor) + "; anchoring it to " + anchor_words(anchor.other) +
        (apart < kTraceLeak_mm2 ? " changes the mean leak by less than " + tenths_above(apart)
                                : std::string(anchor.more_mm2 > 0.0 ? " raises" : " lowers") +
                                      " the mean leak by " + with_decimals(apart, 1) + " mm²") +
        ", with errors of execution.";
  }
  return words;
}

/// Which plans come first in other settings of the thresholds; empty if none does.
std::string choice_of(const std::vector<RankedPlan>& plans) {
  const auto settings = static_cast<int>(threshold_settings().size());
  const int first = plans.front().times_first;
  if (first == 0 || first == settings) return "";  // ordered otherwise, or by no threshold
  int left = settings - first;
  std::string others;
  for (const RankedPlan& plan : plans) {
    if (plan.rank == 1 || plan.times_first == 0) continue;
    others += (others.empty() ? "plan " : ", plan ") + std::to_string(plan.rank) + " in " +
              std::to_string(plan.times_first);
    left -= plan.times_first;
  }
  if (left > 0)
    others +=
        (others.empty() ? "unlisted plans in " : ", unlisted plans in ") + std::to_string(left);
  return " The order depends on thresholds that are not known from measurements: plan 1 ranks "
         "first in " +
         std::to_string(first) + " of " + std::to_string(settings) + " settings, " + others + ".";
}

std::string how_likely(const RankedPlan& plan) {
  return "leaks less than " + shown(kMildLeak_mm2) + " mm² with a probability of " +
         probability_words(plan.acceptable_probability);
}

}  // namespace

std::string known_errors(const RankedPlan& plan) {
  const bool tissue = plan.model && plan.model->draws > 0;
  if (plan.plan.steps.empty())
    return tissue ? "the errors of tissue and mesh" : "the error of the mesh";
  return tissue ? "the errors of execution, tissue and mesh" : "the errors of execution and mesh";
}

std::string why_not_acceptable(const RankedPlan& plan) {
  if (plan.is_acceptable) return "";
  if (plan.tier == PlanTier::Rejected) return "a rule of practice rejects it";
  if (plan.tier == PlanTier::Untrusted) return "its closure failed";
  if (plan.tier == PlanTier::FailsOften) return "too many closures with errors of execution failed";
  if (plan.tier == PlanTier::Stenotic) return "it opens to less than 1.5 cm²";
  if (plan.acceptable_probability < kAcceptable)
    return "it " + how_likely(plan) + ", below the " + shown(100.0 * kAcceptable) + " % required";
  if (plan.opening && trusted(*plan.opening) &&
      plan.opening->measure.gradient_mmhg > kStenosis_mmhg)
    return "its mean gradient at rest is " + gradient_words(plan.opening->measure.gradient_mmhg);
  if (plan.fine && plan.fine_levels > 0 && !closes_finely(plan))
    return "on the finer mesh it leaks " + with_decimals(plan.fine->leak_mm2, 1) + " mm²";
  return "it was not closed on the finer mesh or with all errors that were requested";
}

std::string verdict_of(const std::vector<RankedPlan>& plans) {
  if (plans.empty()) return "";
  const RankedPlan& first = plans.front();
  const std::string likely = how_likely(first);
  if (first.plan.steps.empty())
    return "Without repair the valve " + likely + ", given " + known_errors(first) +
           (first.is_acceptable ? "; no repair is needed." : ".");
  if (first.region.closures < 2)
    return "It is unknown whether a plan is acceptable, because none was closed with errors of "
           "execution.";
  if (!first.is_acceptable)
    return "No plan is acceptable; plan 1 is not, because " + why_not_acceptable(first) + ".";
  const auto alike = std::count_if(plans.begin(), plans.end(), [&](const RankedPlan& plan) {
    return plan.of_class == first.of_class;
  });
  const std::string who = alike > 1 ? (alike == 2 ? "Plans 1 and " : "Plans 1 to ") +
                                          std::to_string(alike) +
                                          " are equivalent; plan 1 is the simplest of them. It"
                                    : std::string("Plan 1");
  return who + " " + likely + ", given " + known_errors(first) + "." + anchors_of(first) +
         choice_of(plans);
}

}  // namespace coapt
