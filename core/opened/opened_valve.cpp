#include "core/opened/opened_valve.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <utility>

#include "core/closure/prepared_valve.h"
#include "core/metrics/annulus.h"
#include "core/metrics/orifice.h"
#include "core/opened/flow_load.h"
#include "core/valve/number_text.h"

namespace coapt {
namespace {

constexpr double kKpaPerMmhg = 0.133322;
constexpr double kGorlin = 37.7;  // of a steady flow: ml/s, cm2, mmHg
constexpr double kPulse = 0.25 * std::numbers::pi * kPeakOverMean;
constexpr double kHumanFlow_ml_s = 155.0;
constexpr double kHumanAnnulus_mm2 = 735.0;  // the smallest that a healthy adult's has in systole
// Opening areas are within 0.03 cm2 of those at the tolerances of closures, in half of the steps.
constexpr double kResidual = 0.02, kWay_mm = 0.1;
constexpr double kRoughResidual = 0.1,
                 kRoughWay_mm = 0.3;  // of the first shape, under a guessed load
constexpr double kSettled = 0.005;    // of the jet's area, between two shapes
constexpr int kMostShapes = 12;
constexpr double kMixed = 0.5;  // of a new load; all of it swings

/// Adds areas and gradients to what is known of the flow.
void measure_opening(OpenedValve& opened) {
  constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
  OpeningMeasure& measure = opened.measure;
  measure.annulus_area_mm2 = measure_annulus(opened.valve).area_mm2;
  measure.projected_area_mm2 = kUnknown;
  if (trusted(opened.closure)) {
    opened.leak = measure_leak(opened.valve, opened.closure.closed_mm);
    measure.projected_area_mm2 = orifice_mm2(opened.valve, opened.closure.closed_mm);
  }
  measure.opening_area_mm2 = opened.leak.area_mm2;
  measure.gradient_mmhg = mean_gradient_mmhg(measure.opening_area_mm2, measure.flow_ml_s);
  measure.gradient_exercise_mmhg =
      mean_gradient_mmhg(measure.opening_area_mm2, measure.flow_exercise_ml_s);
}

/// Of the heart over a human's, at most 1.
double size_of(const Valve& valve) {
  Valve unstressed = valve;
  unstressed.annulus_mm = valve.rest_mm(valve.annulus, Eigen::all);
  return std::min(1.0, measure_annulus(unstressed).area_mm2 / kHumanAnnulus_mm2);
}

/// At rest under the load of the flow; its pressure is the valve's. @param peak_ml_s at the peak of filling
ClosureResult rest_in_flow(double peak_ml_s, const OpeningOptions& options, Valve& open) {
  const std::vector<double> heights = leaflet_coordinates(open).height;
  const auto needed_mmhg = [&](const FlowLoad& load) {
    return options.pressure_mmhg.value_or(std::clamp(bernoulli_mmhg(peak_ml_s, load.jet_mm2),
                                                     kFillingPressures_mmhg.min,
                                                     kFillingPressures_mmhg.max));
  };
  ClosureOptions closing;
  closing.motion = options.motion;
  closing.budget = options.budget;
  FlowLoad load = flow_load(open, heights, open.rest_mm);
  double pressure_mmhg = needed_mmhg(load);
  ClosureResult closure;
  for (int shape = 0; shape < kMostShapes; ++shape) {
    closing.residual_tolerance = shape > 0 ? kResidual : kRoughResidual;
    closing.way_tolerance_mm = shape > 0 ? kWay_mm : kRoughWay_mm;
    open.pressure_kpa = -kKpaPerMmhg * pressure_mmhg;
    const ClosureResult before = std::move(closure);
    closure = close_valve(PreparedValve(open, closing, load.share), open, closing,
                          shape > 0 ? &before : nullptr);
    closing.budget.vertex_steps -= static_cast<double>(closure.steps * open.rest_mm.rows());
    closure.steps += before.steps;
    closure.motion_mm.insert(closure.motion_mm.begin(), before.motion_mm.begin(),
                             before.motion_mm.end());
    if (!trusted(closure)) break;
    const FlowLoad now = flow_load(open, heights, closure.closed_mm);
    if (shape > 0 && std::abs(now.jet_mm2 - load.jet_mm2) < kSettled * load.jet_mm2) break;
    for (std::size_t f = 0; f < load.share.size(); ++f)
      load.share[f] += kMixed * (now.share[f] - load.share[f]);
    load.jet_mm2 = now.jet_mm2;
    pressure_mmhg = std::sqrt(pressure_mmhg * needed_mmhg(now));
  }
  return closure;
}

}  // namespace

double mean_gradient_mmhg(double area_mm2, double flow_ml_s) {
  return kPulse * std::pow(flow_ml_s / (kGorlin * 0.01 * area_mm2), 2.0);
}

double filling_flow_ml_s(const Valve& valve) { return kHumanFlow_ml_s * size_of(valve); }

std::vector<std::string> opening_warnings(const OpenedValve& opened) {
  std::vector<std::string> warnings;
  const OpeningMeasure& measure = opened.measure;
  if (measure.tied_n > kMostTied_n)
    warnings.push_back("the edge-to-edge ties carry " + with_decimals(measure.tied_n, 1) +
                       " N in diastole, more than " + shown(kMostTied_n) +
                       ", because the leaflets are too far apart");
  const double size = size_of(opened.valve), area_mm2 = measure.annulus_area_mm2;
  const Range healthy{size * kHealthyAnnulus_mm2.min, size * kHealthyAnnulus_mm2.max};
  if (opened.valve.systole == SystolicMotion{} &&
      !(area_mm2 >= healthy.min && area_mm2 <= healthy.max))
    warnings.push_back(
        "annulus of " + with_decimals(0.01 * area_mm2, 1) + " cm2 in diastole, " +
        with_decimals(0.01 * healthy.min, 1) + " to " + with_decimals(0.01 * healthy.max, 1) +
        " in healthy valves: it is dilated, or its contraction (systole) is abnormal");
  return warnings;
}

Expected<OpenedValve> open_valve(const Valve& valve, const OpeningOptions& options) {
  ProblemList problems;
  if (options.pressure_mmhg)
    check_range(problems, "/pressure_mmhg", *options.pressure_mmhg, kFillingPressures_mmhg,
                " mmHg");
  if (options.flow_ml_s)
    check_range(problems, "/flow_ml_s", *options.flow_ml_s, kFillingFlows_ml_s, " ml/s");
  check_range(problems, "/exercise", options.exercise, kExercises);
  if (!problems.empty()) return std::move(problems).take();
  Expected<Valve> open = in_diastole(valve);
  if (!open) return open.errors();
  OpeningMeasure measure;
  measure.flow_ml_s = options.flow_ml_s.value_or(filling_flow_ml_s(valve));
  measure.flow_exercise_ml_s = options.exercise * measure.flow_ml_s;
  ClosureResult closure = rest_in_flow(kPeakOverMean * measure.flow_ml_s, options, *open);
  measure.pressure_mmhg = -open->pressure_kpa / kKpaPerMmhg;
  measure.tied_n = std::accumulate(closure.tie_tension_n.begin(), closure.tie_tension_n.end(), 0.0);
  OpenedValve opened{*std::move(open), std::move(closure), measure, {}};
  measure_opening(opened);
  return opened;
}

}  // namespace coapt
