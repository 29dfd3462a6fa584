#include "search/plans/plan_closure.h"

#include <cmath>

namespace coapt {

PlanClosure plan_closure(const Evaluation& evaluation) {
  const ValveMeasure& measure = evaluation.measure;
  const auto& sections = measure.coaptation.sections;
  return {evaluation.status,
          evaluation.crossing,
          measure.orifice.area_mm2,
          measure.coaptation.gap_area_mm2,
          (sections[3].height_mm + sections[4].height_mm + sections[5].height_mm) / 3.0,
          measure.coaptation.distance_max_mm,
          measure.tension_max_n};
}

double leak_mm2(const PlanClosure& closure) {
  return leak_mm2(closure.orifice_mm2, closure.gap_mm2);
}

bool trusted(const PlanClosure& closure) {
  return closure.status == ClosureStatus::Converged && !closure.crossing &&
         std::isfinite(leak_mm2(closure));
}

}  // namespace coapt
