#include "search/plans/plan_estimates.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "core/metrics/area_error.h"
#include "core/metrics/figure_error.h"
#include "search/plans/durability.h"

namespace coapt {
namespace {

struct Weighed {
  std::vector<const PlanClosure*> closures;
  std::vector<double> weights;  ///< empty: all alike
};

/// One valve, repaired or not, closed in all the ways that say something of its figures.
struct Measured {
  const ValveMeasure& measure;
  PlanClosure own;  ///< as a search closes it
  int triangles = 0;
  const PlanClosure* finer = nullptr;  ///< null: not closed, or not to be trusted
  int finer_triangles = 0;
  Weighed draws{}, region{};
  Weighed measured_draws{};  ///< their leaks by the surface; empty: as `draws`
  std::optional<PlanOpening> opening{};
};

int triangles_of(const PlanEvaluations& evaluations) {
  return static_cast<int>(evaluations.valve().faces.rows());
}

/// A draw that was picked several times is one that weighs more: it says no more of the others.
Weighed each_once(const std::vector<PlanClosure>& closures, const std::vector<int>& picked) {
  Weighed all;
  for (std::size_t i = 0; i < closures.size(); ++i) {
    if (i > 0 && i < picked.size() && picked[i] == picked[i - 1]) {
      all.weights.back() += 1.0;
      continue;
    }
    all.closures.push_back(&closures[i]);
    all.weights.push_back(1.0);
  }
  return all;
}

/// Of those closures that are to be trusted: as far from `measured` as each is from that of the valve's own.
std::optional<Interval> changed(const Weighed& of, double PlanClosure::*figure,
                                const PlanClosure& own, double measured) {
  std::vector<double> values, weights;
  for (std::size_t i = 0; i < of.closures.size(); ++i) {
    if (!trusted(*of.closures[i]) || !std::isfinite(of.closures[i]->*figure)) continue;
    values.push_back(std::max(0.0, measured + of.closures[i]->*figure - own.*figure));
    if (!of.weights.empty()) weights.push_back(of.weights[i]);
  }
  return sampled_interval(values, weights);
}

Estimate with_spread(Estimate estimate, const Measured& known, double PlanClosure::*figure) {
  if (!trusted(known.own) || !std::isfinite(known.own.*figure)) return estimate;
  estimate.tissue = changed(known.draws, figure, known.own, estimate.value);
  estimate.execution = changed(known.region, figure, known.own, estimate.value);
  return estimate;
}

Estimate leak(const Measured& known) {
  const ValveMeasure& measure = known.measure;
  Estimate leak{measure.leak.area_mm2,
                area_interval(measure.leak.area_mm2, measure.leak_error_mm2)};
  if (known.finer != nullptr)
    leak.numerical =
        area_interval(known.finer->leak_mm2,
                      area_error_mm2(known.finer->leak_mm2, {.triangles = known.finer_triangles}));
  leak = with_spread(leak, known, &PlanClosure::leak_mm2);
  if (known.measured_draws.closures.empty() || !trusted(known.own)) return leak;
  PlanClosure own = known.own;
  own.leak_mm2 = leak.value;
  leak.tissue = changed(known.measured_draws, &PlanClosure::leak_mm2, own, leak.value);
  return leak;
}

Estimate closed(const Measured& known, Figure of, double PlanClosure::*figure) {
  Estimate estimate{known.own.*figure};
  if (known.finer != nullptr)
    estimate.numerical = figure_interval(of, known.finer->*figure, known.finer_triangles);
  else if (trusted(known.own))
    estimate.numerical = figure_interval(of, estimate.value, known.triangles);
  return with_spread(estimate, known, figure);
}

Estimate opened(const Measured& known, Figure of, double OpeningMeasure::*figure) {
  if (!known.opening || !trusted(*known.opening)) return {};
  const double value = known.opening->measure.*figure;
  return {value, figure_interval(of, value, known.triangles)};
}

std::vector<double> figures_of(const std::vector<PlanOpening>& openings,
                               double OpeningMeasure::*figure) {
  std::vector<double> figures;
  for (const PlanOpening& opening : openings)
    if (trusted(opening)) figures.push_back(opening.measure.*figure);
  return figures;
}

/// One that closures of a search do not keep.
Estimate from_measure(const Measured& known, Figure of, double value) {
  if (!trusted(known.own)) return {value};
  return {value, figure_interval(of, value, known.triangles)};
}

PlanEstimates estimates_of(const Measured& known) {
  const ValveMeasure& measure = known.measure;
  return {.leak_mm2 = leak(known),
          .coaptation_mm = closed(known, Figure::Coaptation, &PlanClosure::coaptation_mm),
          .tension_max_n = closed(known, Figure::Tension, &PlanClosure::tension_max_n),
          .leaflet_ratio = closed(known, Figure::LeafletRatio, &PlanClosure::leaflet_ratio),
          .strain_circumferential = from_measure(known, Figure::CircumferentialStrain,
                                                 measure.strain_circumferential_max),
          .strain_radial = from_measure(known, Figure::RadialStrain, measure.strain_radial_max),
          .opening_mm2 = opened(known, Figure::Opening, &OpeningMeasure::opening_area_mm2),
          .gradient_mmhg = opened(known, Figure::Gradient, &OpeningMeasure::gradient_mmhg)};
}

}  // namespace

PlanEstimates plan_estimates(const PlanEvaluations& evaluations, const PlanRecord& plan,
                             const ValveMeasure& measure, int nodes, const FineClosures& fine,
                             const ModelClosures& model) {
  Measured known{.measure = measure,
                 .own = plan.closures.at(0),
                 .triangles = triangles_of(evaluations),
                 .finer_triangles = fine.mesh.triangles,
                 .opening = plan.opening};
  if (const auto finer = fine.plans.find(&plan);
      finer != fine.plans.end() && trusted(finer->second))
    known.finer = &finer->second;
  if (const auto drawn = model.plans.find(&plan); drawn != model.plans.end() && !model.contradicts)
    known.draws = each_once(drawn->second, model.picked);
  if (const auto drawn = model.measured.find(&plan);
      drawn != model.measured.end() && !model.contradicts)
    known.measured_draws = each_once(drawn->second, model.picked);
  for (int node = 0; node < nodes; ++node) known.region.closures.push_back(&plan.closures.at(node));
  PlanEstimates estimates = estimates_of(known);
  if (const std::optional<Durability> lasts = durability(plan))
    estimates.durability_mm = {lasts->expected_mm, durability_interval(plan, known.triangles)};
  return estimates;
}

PlanEstimates estimates_before(const PlanEvaluations& evaluations, const ValveMeasure& measure,
                               const std::optional<PlanOpening>& opening, const FineMesh& fine,
                               const ModelClosures& model) {
  Measured known{.measure = measure,
                 .own = plan_closure(evaluations.before()),
                 .triangles = triangles_of(evaluations),
                 .finer_triangles = fine.triangles,
                 .opening = opening};
  known.own.leak_mm2 = measure.leak.area_mm2;  // as the draws'
  if (fine.before && trusted(*fine.before)) known.finer = &*fine.before;
  if (!model.contradicts) known.draws = each_once(model.before, model.picked);
  return estimates_of(known);
}

void add_spread(PlanEstimates& estimates, const std::optional<PlanOpening>& own,
                const DrawnOpenings& drawn) {
  if (!own || !trusted(*own)) return;
  for (const auto& [estimate, figure] :
       {std::pair{&estimates.opening_mm2, &OpeningMeasure::opening_area_mm2},
        std::pair{&estimates.gradient_mmhg, &OpeningMeasure::gradient_mmhg}}) {
    estimate->tissue = sampled_interval(figures_of(drawn.draws, figure));
    estimate->execution = sampled_interval(figures_of(drawn.errors, figure));
  }
}

}  // namespace coapt
