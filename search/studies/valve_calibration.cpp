#include "search/studies/valve_calibration.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <set>

#include "core/presets/taut_valve.h"
#include "search/least_squares.h"
#include "search/parallel.h"

namespace coapt {
namespace {

constexpr double kMostBandCost = 30.0;
// Steps times vertices: twelve times what a preset takes; a valve that needs more is no answer.
constexpr double kMostVertexSteps = 6e6;

std::vector<PhysiologyTrial> trials_for(const std::vector<CalibrationBand>& bands, int valve) {
  std::set<PhysiologyTrial> trials;
  for (const CalibrationBand& band : bands)
    if (band.valve == valve) trials.insert(band.quantity->trial);
  return {trials.begin(), trials.end()};
}

std::vector<double> values_at(const CalibrationProblem& problem, const Eigen::VectorXd& point) {
  std::vector<double> values;
  for (std::size_t i = 0; i < problem.unknowns.size(); ++i) {
    const CalibrationUnknown& unknown = problem.unknowns[i];
    values.push_back(unknown.low + point[static_cast<Index>(i)] * (unknown.high - unknown.low));
  }
  return values;
}

}  // namespace

const char* to_string(CalibrationStop stop) {
  switch (stop) {
    case CalibrationStop::Settled:
      return "settled";
    case CalibrationStop::EvaluationLimit:
      return "evaluation_limit";
    case CalibrationStop::TimeLimit:
      return "time_limit";
    case CalibrationStop::Cancelled:
      return "cancelled";
  }
  return "";
}

double band_cost(const CalibrationBand& band, double value) {
  if (!std::isfinite(value)) return band.weight * kMostBandCost;
  const double outside = std::max({band.low - value, value - band.high, 0.0}) / band.scale;
  return band.weight *
         std::min(kMostBandCost, outside < 1.0 ? outside * outside : 2.0 * outside - 1.0);
}

std::vector<Expected<Valve>> make_calibrated(const CalibrationValves& valves, int triangles) {
  ParametricValve dimensions = valves.dimensions;
  dimensions.triangles = triangles;
  const Expected<Valve> healthy = make_taut_valve(dimensions, {.vertex_steps = kMostVertexSteps});
  std::vector<Expected<Valve>> made;
  for (const CalibratedValve& valve : valves.valves) {
    made.push_back(healthy && valve.change ? remodel(*healthy, *valve.change) : healthy);
    if (made.back()) made.back()->name = valve.name;
  }
  return made;
}

std::vector<double> band_costs(const CalibrationProblem& problem,
                               const std::vector<double>& values) {
  const Expected<CalibrationValves> valves = problem.valves_at(values);
  std::vector<Expected<Valve>> made;
  if (valves) made = make_calibrated(*valves);
  PhysiologyOptions options;
  options.budget.vertex_steps = kMostVertexSteps;
  options.threads = 1;
  std::vector<PhysiologyValues> of_valves(made.size());
  for (std::size_t v = 0; v < made.size(); ++v) {
    options.trials = trials_for(problem.bands, static_cast<int>(v));
    if (made[v]) of_valves[v] = physiology_values(*made[v], options);
  }
  std::vector<double> costs;
  for (const CalibrationBand& band : problem.bands) {
    const auto v = static_cast<std::size_t>(band.valve);
    costs.push_back(band_cost(band, v < of_valves.size() ? of_valves[v].*band.quantity->value
                                                         : PhysiologyValues::kUnknown));
  }
  return costs;
}

ValveCalibration calibrate_valves(const CalibrationProblem& problem,
                                  const ValveCalibrationOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  Eigen::VectorXd first(static_cast<Index>(problem.unknowns.size()));
  for (std::size_t i = 0; i < problem.unknowns.size(); ++i) {
    const CalibrationUnknown& unknown = problem.unknowns[i];
    first[static_cast<Index>(i)] = (unknown.start - unknown.low) / (unknown.high - unknown.low);
  }
  ValveCalibration calibration;
  const auto residuals_at = [&](const std::vector<Eigen::VectorXd>& points) {
    std::vector<Eigen::VectorXd> residuals(points.size());
    for_each_index(static_cast<int>(points.size()), options.threads, [&](int i) {
      const auto at = static_cast<std::size_t>(i);
      const std::vector<double> costs = band_costs(problem, values_at(problem, points[at]));
      residuals[at] =
          Eigen::Map<const Eigen::VectorXd>(costs.data(), std::ssize(costs)).cwiseSqrt();
    });
    if (calibration.evaluations == 0) calibration.cost_before = residuals.front().squaredNorm();
    calibration.evaluations += static_cast<int>(points.size());
    return residuals;
  };
  LeastSquaresOptions search;
  search.most_rounds = std::numeric_limits<int>::max();
  search.progress = [&](int, double best) {
    if (options.progress) options.progress(calibration.evaluations, best);
    const std::chrono::duration<double> past = std::chrono::steady_clock::now() - start;
    if (options.cancelled != nullptr && *options.cancelled)
      calibration.stop = CalibrationStop::Cancelled;
    else if (past.count() > options.seconds)
      calibration.stop = CalibrationStop::TimeLimit;
    else if (calibration.evaluations >= options.evaluations)
      calibration.stop = CalibrationStop::EvaluationLimit;
    return calibration.stop == CalibrationStop::Settled;
  };
  const LeastSquaresFit fit = fit_least_squares(residuals_at, first, search);
  calibration.values = values_at(problem, fit.point);
  calibration.cost = fit.cost;
  return calibration;
}

}  // namespace coapt
