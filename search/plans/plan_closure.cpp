#include "search/plans/plan_closure.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/closed/diagnosis.h"
#include "core/metrics/area_error.h"

namespace coapt {

PlanClosure plan_closure(const Evaluation& evaluation) {
  const ValveMeasure& measure = evaluation.measure;
  return {evaluation.status,
          evaluation.crossing,
          measure.leak.area_mm2,
          coaptation_a2_p2_mm(measure),
          measure.coaptation.distance_max_mm,
          measure.tension_max_n,
          leaflet_ratio(measure)};
}

bool raises_sam_risk(double ratio, double before) {
  constexpr double kAlike = 0.05;  // figures are told to a tenth
  return ratio < kLowLeafletRatio && !(ratio >= before - kAlike);
}

bool trusted(const PlanClosure& closure) {
  return closure.status == ClosureStatus::Converged && !closure.crossing &&
         std::isfinite(closure.leak_mm2);
}

double probability_mild(double leak_mm2, int triangles) {
  const double leak = std::max(0.0, leak_mm2);
  const double sd = area_error_mm2(leak, {.triangles = triangles}) / kAreaErrorSds;
  return 0.5 * std::erfc((leak - kMildLeak_mm2) / (sd * std::numbers::sqrt2));
}

}  // namespace coapt
