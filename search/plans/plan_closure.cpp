#include "search/plans/plan_closure.h"

#include <cmath>

namespace coapt {

PlanClosure plan_closure(const Evaluation& evaluation) {
  const ValveMeasure& measure = evaluation.measure;
  const auto& sections = measure.coaptation.sections;
  return {evaluation.status,
          evaluation.crossing,
          measure.leak.area_mm2,
          (sections[3].height_mm + sections[4].height_mm + sections[5].height_mm) / 3.0,
          measure.coaptation.distance_max_mm,
          measure.tension_max_n};
}

bool trusted(const PlanClosure& closure) {
  return closure.status == ClosureStatus::Converged && !closure.crossing &&
         std::isfinite(closure.leak_mm2);
}

}  // namespace coapt
