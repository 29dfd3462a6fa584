#include "search/plans/plan_row.h"

#include <algorithm>
#include <cmath>

#include "core/metrics/estimate_text.h"
#include "core/repair/approximation.h"
#include "core/valve/counted.h"
#include "core/valve/number_text.h"

namespace coapt {
namespace {

const char* const kNotKnown = "not known";

/// Mean + sd over the region, and not less than as planned, which is all where that was not closed.
std::string leak_words(const RankedPlan& plan) {
  const LeakStatistics& leak = plan.region.leak_mm2;
  const bool varied = plan.region.closures > 1 && std::isfinite(leak.mean);
  const double planned = plan.measure.leak.area_mm2;
  const double left = varied ? std::max(leak.mean + leak.sd, planned) : planned;
  if (!std::isfinite(left)) return kNotKnown;
  const std::string words = left < kTraceLeak_mm2  ? "none or trace"
                            : left < kMildLeak_mm2 ? "mild"
                                                   : fixed(left, 0) + " mm²";
  return varied ? words + " (" + probability_text(plan.acceptable_probability) + ")" : words;
}

std::string reserve_words(const RankedPlan& plan) {
  if (!plan.durability) return kNotKnown;
  if (plan.durability->expected_mm >= kFurthestCourse_mm)
    return "≥ " + shown(kFurthestCourse_mm) + " mm";
  return known_tenths(plan.estimates.durability_mm) + " mm";
}

std::string opening_words(const RankedPlan& plan) {
  if (!plan.opening || !trusted(*plan.opening)) return kNotKnown;
  constexpr double kCm2 = 0.01;  // of 1 mm2
  return known_tenths(plan.estimates.opening_mm2, kCm2) + " cm², " +
         known_tenths(plan.estimates.gradient_mmhg) + " mmHg";
}

std::string effort_words(const RankedPlan& plan) {
  constexpr double kLeast = 0.05;  // sizes that are printed
  const std::vector<RepairStep>& steps = plan.plan.steps;
  if (steps.empty()) return "none";
  std::string words = counted(std::ssize(steps), "step");
  if (const int muscles = sutured_muscles(plan.plan); muscles > 0)
    words += ", " + counted(muscles, "muscle");
  if (plan.effort.sizes_below >= kLeast)
    words += ", " + fixed(plan.effort.sizes_below, 1) + " sizes below";
  return words;
}

}  // namespace

PlanRow row_of(const RankedPlan& plan) {
  return {leak_words(plan), reserve_words(plan), opening_words(plan), effort_words(plan)};
}

PlanRow take_shared(std::vector<PlanRow>& rows) {
  PlanRow shared;
  if (rows.size() < 2) return shared;
  for (const auto& [name, cell] : kPlanColumns) {
    const std::string first = rows.front().*cell;
    if (!std::all_of(rows.begin(), rows.end(),
                     [&, at = cell](const PlanRow& row) { return row.*at == first; }))
      continue;
    shared.*cell = first;
    for (PlanRow& row : rows) (row.*cell).clear();
  }
  return shared;
}

std::string words_of(const PlanRow& shared) {
  std::string words;
  for (const auto& [name, cell] : kPlanColumns)
    if (const std::string& shown = shared.*cell; !shown.empty())
      words += (words.empty() ? "" : "; ") + std::string(name) + ": " + shown;
  return words;
}

}  // namespace coapt
