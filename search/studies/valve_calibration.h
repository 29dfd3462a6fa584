// Valves that meet their physiology: unknowns of a healthy valve's dimensions and of what disease does to it, moved until rows of
// physiology.h lie within targets.
//
// All valves come from one healthy one: its chordae are taut in its own closed state, and each disease remodels it. A target costs
// nothing inside its band; outside, the square of the distance over its scale, twice the distance beyond one scale, thirty at most.
//
// Costs are squares, so least_squares.h minimises their sum. Measured on the healthy valve (21 unknowns, 16 targets, a start of cost
// 57): after about 80, 120 and 200 evaluations 0.33, 0.03 and 0.01; an evolution strategy with covariance matrix adaptation 2.3, 0.6
// and 0.1, NLopt's (ESCH) 8.6, 3.8 and 3.8.
#pragma once

#include <atomic>
#include <functional>
#include <string>
#include <vector>

#include "core/valve/parametric.h"
#include "core/valve/remodel.h"
#include "search/studies/physiology.h"

namespace coapt {

struct CalibratedValve {
  std::string name;
  ValveKind kind = ValveKind::Healthy;
  Species species = Species::Human;
  std::optional<Remodelling> change{};  ///< none: the healthy valve itself
  std::string disease{};                ///< in words
};

struct CalibrationValves {
  ParametricValve dimensions;  ///< of the healthy valve
  std::vector<CalibratedValve> valves;
};

struct CalibrationBand {
  int valve = 0;  ///< index into CalibrationValves::valves
  const PhysiologyQuantity* quantity = nullptr;
  double low = 0.0, high = 0.0;
  double scale = 1.0;  ///< > 0, of the quantity
  double weight = 1.0;
};

struct CalibrationUnknown {
  double low = 0.0, high = 1.0;
  double start = 0.0;  ///< within them
};

struct CalibrationProblem {
  std::vector<CalibrationUnknown> unknowns;
  /// The valves at values of the unknowns. Errors: dimensions out of their ranges.
  std::function<Expected<CalibrationValves>(const std::vector<double>&)> valves_at;
  std::vector<CalibrationBand> bands;
};

struct ValveCalibrationOptions {
  int evaluations = 400;  ///< no new round after so many; one takes as many as unknowns and eight
  int threads = 0;        ///< 0: all cores; does not change the answer
  double seconds = 1e9;   ///< no new round after so long; reported
  std::function<void(int, double)> progress;  ///< evaluations made, best cost
  const std::atomic<bool>* cancelled = nullptr;
};

/// Settled: no step along or away from any unknown's axis is better, down to a hundredth of its range.
enum class CalibrationStop { Settled, EvaluationLimit, TimeLimit, Cancelled };
const char* to_string(CalibrationStop stop);

struct ValveCalibration {
  std::vector<double> values;  ///< of the unknowns
  double cost_before = 0.0, cost = 0.0;
  int evaluations = 0;
  CalibrationStop stop = CalibrationStop::Settled;
};

/// Of one value.
double band_cost(const CalibrationBand& band, double value);

/// Of each band at values of the unknowns; a valve that cannot be made or closed costs the most. |bands|.
std::vector<double> band_costs(const CalibrationProblem& problem,
                               const std::vector<double>& values);

ValveCalibration calibrate_valves(const CalibrationProblem& problem,
                                  const ValveCalibrationOptions& options = {});

/// The healthy valve, and what became of it, in the order of `valves`; errors of each in its place.
std::vector<Expected<Valve>> make_calibrated(const CalibrationValves& valves, int triangles = 650);

}  // namespace coapt
