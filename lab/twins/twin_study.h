// Fits judged on valves whose unknowns are known: a twin's parameters are drawn from their priors, it is closed on a finer
// mesh and seen as in an echocardiogram; the fit gets the valve with all parameters at their priors, on its own mesh.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "lab/twins/echo_view.h"
#include "search/fit/fit.h"

namespace coapt {

struct TwinStudyOptions {
  int twins = 40;
  std::uint64_t seed = 1;
  int refinements = 1;  ///< of the mesh that twins are closed on
  bool leak_known =
      true;  ///< to within FitOptions' MeasuredClosure::leak_sd_mm2, with such an error
  EchoOptions echo;
  /// With FitOptions::ruptures every second pair of twins has the marginal chordae of a random scallop ruptured; the fit gets
  /// them whole.
  FitOptions fit;
};

struct TwinParameter {
  FittedParameter fitted;
  double truth = 0.0;
};

struct Twin {
  int number = 0;
  int points = 0;
  std::vector<TwinParameter> parameters;
  double rms_before_mm = 0.0, rms_mm = 0.0;  ///< of the points
  /// Of the closed fit's nodes from those of the twin, on the mesh that both have; and from its surface.
  double node_rms_mm = 0.0, surface_rms_mm = 0.0;
  double node_rms_before_mm = 0.0;
  double leak_mm2 = 0.0, leak_before_mm2 = 0.0;  ///< of the twin; of the valve as given
  FittedLeak fitted_leak;
  double independent_points = 0.0;
  int rounds = 0, closures = 0;
  std::string lesion = "intact";  ///< its own, as a FitHypothesis is named; of ValveFit the others
  std::string taken;
  std::vector<FitHypothesis> hypotheses;
};

/// Twins that do not close are drawn again.
std::vector<Twin> study_twins(const TwinStudyOptions& options,
                              const std::function<void(int, int)>& progress = {});

}  // namespace coapt
