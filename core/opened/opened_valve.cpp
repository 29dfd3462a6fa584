#include "core/opened/opened_valve.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "core/metrics/exact_orifice.h"
#include "core/opened/funnel.h"

namespace coapt {
namespace {

constexpr double kKpaPerMmhg = 0.133322;
constexpr double kGorlin = 37.7;  // ml/s, cm2, mmHg
// Opening areas are within 0.03 cm2 of those at the tolerances of closures, in half of the steps.
constexpr double kResidual = 0.02, kWay_mm = 0.1;

/// @param passage nothing where the closure is not to be trusted
OpeningMeasure measured(const Valve& valve, const Points& open_mm,
                        const std::optional<FunnelPassage>& passage,
                        const OpeningOptions& options) {
  constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
  OpeningMeasure measure;
  measure.annulus_area_mm2 = measure_annulus(valve).area_mm2;
  if (!passage) {
    measure.opening_area_mm2 = measure.passage_depth_mm = measure.tilt_deg = kUnknown;
    measure.projected_area_mm2 = measure.gradient_mmhg = measure.gradient_exercise_mmhg = kUnknown;
    return measure;
  }
  measure.opening_area_mm2 = passage->area_mm2;
  measure.passage_depth_mm = passage->depth_mm;
  const double cosine = -passage->axis.dot(annulus_frame(valve, AnnulusAxis::Commissures).normal);
  measure.tilt_deg = std::acos(std::min(1.0, cosine)) * 180.0 / std::numbers::pi;
  measure.projected_area_mm2 =
      exact_orifice(valve, open_mm, 0.5 * valve.tissue.thickness_mm).area_mm2;
  const double least_mm2 = opening_mm2(measure);
  measure.gradient_mmhg = gorlin_mmhg(least_mm2, options.flow_ml_s);
  measure.gradient_exercise_mmhg = gorlin_mmhg(least_mm2, options.exercise * options.flow_ml_s);
  return measure;
}

}  // namespace

double opening_mm2(const OpeningMeasure& measure) {
  return std::fmin(measure.opening_area_mm2, measure.projected_area_mm2);
}

double gorlin_mmhg(double area_mm2, double flow_ml_s) {
  return std::pow(flow_ml_s / (kGorlin * 0.01 * area_mm2), 2.0);
}

Expected<OpenedValve> open_valve(const Valve& valve, const OpeningOptions& options) {
  ProblemList problems;
  check_range(problems, "/pressure_mmhg", options.pressure_mmhg, kFillingPressures_mmhg, " mmHg");
  check_range(problems, "/flow_ml_s", options.flow_ml_s, kFillingFlows_ml_s, " ml/s");
  check_range(problems, "/exercise", options.exercise, kExercises);
  if (!problems.empty()) return std::move(problems).take();
  Expected<Valve> open = in_diastole(valve);
  if (!open) return open.errors();
  open->pressure_kpa = -kKpaPerMmhg * options.pressure_mmhg;
  ClosureOptions closing;
  closing.residual_tolerance = kResidual;
  closing.way_tolerance_mm = kWay_mm;
  closing.motion = options.motion;
  closing.budget = options.budget;
  ClosureResult closure = close_valve(*open, closing);
  std::optional<FunnelPassage> passage;
  if (trusted(closure)) passage = narrowest_passage(*open, closure.closed_mm);
  const OpeningMeasure measure = measured(*open, closure.closed_mm, passage, options);
  std::vector<Vec3> outline_mm;
  if (passage) outline_mm = std::move(passage->outline_mm);
  return OpenedValve{*std::move(open), std::move(closure), measure, std::move(outline_mm)};
}

}  // namespace coapt
