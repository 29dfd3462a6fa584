// Fits what images do not show of a valve (fit_parameters.h) to its closed state as it was measured: a closed surface, and
// the leak where that is known.
//
// Bounded Levenberg-Marquardt (least_squares.h) on distances from measured points to the closed model, kept near the
// prior: sum of (distance / noise)^2 over as many points as are independent, plus sum of ((value - prior) / prior sd)^2.
// Noise and number of independent points are those of the residuals, found in a first pass: neighbouring points err alike
// (smoothing, mesh, what the model lacks), so that a thousand points may weigh as thirty. Standard deviations are those of
// the linearised posterior, (J'J + prior)^-1 (Bard 1974, Nonlinear Parameter Estimation).
//
// A model that cannot reach the surface leaves residuals that are one broad bulge: a variance with a length of its own, of which a
// surface holds few. What is most probable by such weights is near the priors, and lets go of a nearer place that was met on the
// way. The answer is then the nearest place of all, and its covariance is the second moment about it, that of the posterior and
// the square of its distance from the most probable values: such parameters are known no better than that.
//
// A closure may take ten times the steps of the valve as given; one that takes more counts as a valve that does not close.
// Some anatomies climb the ladder of closures to its end (hypertrophic, tips drawn: half of the closures at 50,000
// steps, 376 as given), and a fit of them would take an hour.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/closed/closed_valve.h"
#include "search/fit/fit_parameters.h"
#include "search/fit/measured_surface.h"
#include "search/least_squares.h"

namespace coapt {

struct MeasuredClosure {
  Points points_mm;  ///< of the closed surface, in the valve's frame
  MeasuredSide side = MeasuredSide::Atrial;
  std::optional<double> leak_mm2;  ///< of the least surface (core/metrics/leak.h)
  double leak_sd_mm2 = 3.0;        ///< how well that is known
};

/// A fit between two rounds: from here it goes on as it would have without a break.
struct FitState {
  int pass = 0;
  double noise_mm = 0.0, independent_points = 0.0,
         outlier_mm = 0.0;  ///< by which the pass weighs distances
  LeastSquaresState squares;
  int rounds = 0;                ///< of the passes before
  int closures = 0;              ///< made until now
  Eigen::VectorXd nearest = {};  ///< of the places met until now
  double nearest_rms_mm = 0.0;
};

struct FitOptions {
  FitUnknowns unknowns;
  ClosureOptions closure;
  int most_points = 2000;  ///< [100, 10000]; more are thinned
  int most_rounds = 30;    ///< of either pass
  int threads = 0;         ///< 0: all cores
  /// Of a mitral valve: fits it with the marginal chordae of a scallop ruptured, too, where that may explain the surface better,
  /// and takes the more probable one (rupture_fit.h).
  bool ruptures = false;
  std::map<std::string, double> start =
      {};  ///< values by name that it begins at; others at their priors
  /// Of the clock; the closures that the uncertainty takes at the end are counted in, by how long others took.
  double most_seconds = std::numeric_limits<double>::infinity();
  /// Rounds done of at most twice most_rounds (six times with `ruptures`), rms in mm; false stops.
  std::function<bool(int, double)> progress{};
  /// Called after each round, before `progress`; with `ruptures` only in the fit of the valve as given.
  std::function<void(const FitState&)> keep{};
  std::optional<FitState> from = {};  ///< of the same valve, surface and options
  /// Asked during closures, on any thread; true stops. Empty: nobody asks.
  std::function<bool()> cancelled{};
};

/// Why it ended. Only AtRest and RoundLimit have the same bits every time.
enum class FitStop { AtRest, RoundLimit, TimeLimit, Cancelled };

const char* to_string(FitStop stop);

struct FittedParameter {
  FitParameter parameter;
  double value = 0.0, sd = 0.0;
  /// The data halve at least what was not known: sd below half the prior one.
  bool identifiable = false;
};

/// A leak with the standard deviation that the parameters' leave it.
struct FittedLeak {
  double mm2 = 0.0, sd_mm2 = 0.0;
};

/// The valve as given ("intact"), or with chordae ruptured ("ruptured_P2"), as an explanation of the surface.
struct FitHypothesis {
  std::string name;
  double rms_mm = 0.0,
         leak_mm2 = 0.0;     ///< fitted, else of its better screen; nan if that did not close
  double objective = 0.0;    ///< sum of squares; of one that was not fitted a bound from above
  double probability = 0.0;  ///< among all hypotheses
  bool refitted = false;
};

struct ValveFit {
  ClosedValve before, closed;  ///< the valve as given and as fitted (with Valve::fitted), closed
  std::vector<FittedParameter> parameters;
  Eigen::MatrixXd covariance;        ///< of the values
  Points points_mm;                  ///< that were used
  std::vector<double> distances_mm;  ///< of them, signed_distances_mm()
  double rms_before_mm = 0.0, rms_mm = 0.0;
  double best_rms_mm = 0.0;  ///< of all places that were met; rms_mm is at most 2 % more
  double independent_points = 0.0;
  FittedLeak leak;
  int rounds = 0, closures = 0;
  FitStop stop = FitStop::AtRest;  ///< else it has the best so far
  /// With FitOptions::ruptures: "intact", then by segment. The valve is that of `taken`.
  std::vector<FitHypothesis> hypotheses;
  std::string taken;
  std::vector<std::string> left_out;  ///< that there was no time to screen, or to refit
};

/// What a person should check of it against the images, a clause each: it ends more than 2 mm rms from the surface, or more than 0.3 mm and the
/// surface has fewer independent points than the fit has parameters. Empty: nothing.
std::vector<std::string> doubts_of(const ValveFit& fit);

/// Deterministic, for any number of threads. Errors: "/points_mm" too few or far from the valve, "/leak_mm2", nothing unknown, a valve that does not close.
/// @pre the valve is valid.
Expected<ValveFit> fit_valve(const Valve& valve, const MeasuredClosure& measured,
                             const FitOptions& options);

}  // namespace coapt
