#include "search/plans/plan_opening.h"

#include <algorithm>
#include <cmath>

#include "core/valve/number_text.h"
#include "search/plans/gate_parts.h"

namespace coapt {
namespace {

constexpr const char* kGradientSource =
    "guidelines: a mean gradient above 5 mmHg at rest is stenosis";

}  // namespace

bool trusted(const PlanOpening& opening) {
  return opening.status == ClosureStatus::Converged && !opening.crossing && !opening.two_orifices &&
         std::isfinite(opening.measure.opening_area_mm2) &&
         std::isfinite(opening.measure.gradient_mmhg);
}

PlanOpening open_plan(const Valve& repaired) {
  const Expected<OpenedValve> opened = open_valve(repaired);
  if (!opened) return {ClosureStatus::Diverged, false, {}};
  const bool two_orifices = !repaired.ties.empty() && opened->leak.openings.size() > 1;
  return {opened->closure.status, opened->closure.crossing, opened->measure, two_orifices};
}

std::string gradient_words(double mmhg) {
  const bool above = mmhg > kStenosis_mmhg;
  const int decimals =
      above && std::lround(10.0 * mmhg) <= std::lround(10.0 * kStenosis_mmhg) ? 2 : 1;
  return with_decimals(mmhg, decimals) + " mmHg, " + (above ? "above 5 mmHg" : "not above 5 mmHg");
}

CostTerms opening_terms(const PlanOpening& opening) {
  CostTerms terms;
  if (!trusted(opening)) return terms;
  const double gradient = opening.measure.gradient_mmhg;
  terms[CostTerm::GradientAbove3] = std::max(0.0, gradient - kUsualGradient_mmhg);
  terms[CostTerm::GradientAbove5] = std::max(0.0, gradient - kStenosis_mmhg);
  return terms;
}

std::vector<Gate> opening_gates(const std::optional<PlanOpening>& opening) {
  Gate area{"opening_area", GateSeverity::NotAssessed, "", kPractice};
  Gate gradient{"mean_gradient", GateSeverity::NotAssessed, "", kGradientSource};
  if (!opening || !trusted(*opening)) {
    area.finding = gradient.finding =
        !opening ? "the repaired valve was not opened"
        : opening->two_orifices
            ? kUnknownOpening
            : "the open valve did not reach equilibrium without crossing leaflets";
    return {area, gradient};
  }
  const double mm2 = opening->measure.opening_area_mm2, mmhg = opening->measure.gradient_mmhg;
  const std::string figure = "the opening area is " + with_decimals(0.01 * mm2, 1) + " cm²";
  if (mm2 < kStenosis_mm2) {
    area.severity = GateSeverity::Reject;
    area.finding = figure + "; less than 1.5 cm² is not accepted in practice";
  } else if (mm2 < kNarrow_mm2) {
    area.severity = GateSeverity::Warn;
    area.finding = figure + "; less than 2.0 cm² calls for caution";
  } else {
    area.severity = GateSeverity::Pass;
    area.finding = figure + ", at least 2.0 cm²";
  }
  gradient.severity = mmhg > kStenosis_mmhg ? GateSeverity::Warn : GateSeverity::Pass;
  gradient.finding = "the mean gradient at rest is " + gradient_words(mmhg);
  return {area, gradient};
}

bool is_stenotic(const std::optional<PlanOpening>& opening) {
  return opening && trusted(*opening) && opening->measure.opening_area_mm2 < kStenosis_mm2;
}

}  // namespace coapt
