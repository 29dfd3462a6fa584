#include "search/plans/plan_leak.h"

#include <algorithm>

#include "core/metrics/area_error.h"

namespace coapt {
namespace {

/// Of the finer mesh if its closure is to be trusted, else of the measure's own.
std::optional<Interval> numerical(const ValveMeasure& measure, const PlanClosure* finer,
                                  int triangles) {
  if (finer == nullptr || !trusted(*finer))
    return area_interval(measure.leak.area_mm2, measure.leak_error_mm2);
  return area_interval(finer->leak_mm2, area_error_mm2(finer->leak_mm2, {.triangles = triangles}));
}

/// Leaks of those closures that are to be trusted, as far from the measured one as each is from `as_planned_mm2`.
std::optional<Interval> changed(const std::vector<const PlanClosure*>& closures,
                                double as_planned_mm2, double measured_mm2) {
  std::vector<double> leaks_mm2;
  for (const PlanClosure* closure : closures)
    if (trusted(*closure))
      leaks_mm2.push_back(std::max(0.0, measured_mm2 + closure->leak_mm2 - as_planned_mm2));
  return sampled_interval(leaks_mm2);
}

std::vector<const PlanClosure*> addresses(const std::vector<PlanClosure>& closures) {
  std::vector<const PlanClosure*> all;
  for (const PlanClosure& closure : closures) all.push_back(&closure);
  return all;
}

}  // namespace

Estimate plan_leak(const PlanRecord& plan, const ValveMeasure& measure, int nodes,
                   const FineClosures& fine, const ModelClosures& model) {
  Estimate leak{measure.leak.area_mm2};
  const auto finer = fine.plans.find(&plan);
  leak.numerical =
      numerical(measure, finer == fine.plans.end() ? nullptr : &finer->second, fine.mesh.triangles);
  const PlanClosure& own = plan.closures.at(0);
  if (!trusted(own)) return leak;
  if (const auto drawn = model.plans.find(&plan); drawn != model.plans.end() && !model.contradicts)
    leak.tissue = changed(addresses(drawn->second), own.leak_mm2, leak.value);
  std::vector<const PlanClosure*> region;
  for (int node = 0; node < nodes; ++node) region.push_back(&plan.closures.at(node));
  leak.execution = changed(region, own.leak_mm2, leak.value);
  return leak;
}

Estimate leak_before(const ValveMeasure& before, double estimated_mm2, const FineMesh& fine,
                     const ModelClosures& model) {
  Estimate leak{before.leak.area_mm2};
  leak.numerical = numerical(before, fine.before ? &*fine.before : nullptr, fine.triangles);
  if (!model.contradicts) leak.tissue = changed(addresses(model.before), estimated_mm2, leak.value);
  return leak;
}

}  // namespace coapt
