// What accuracy costs: closures by every method, membrane, resolution and tolerance against one
// reference solution of the scene.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/closure/closure.h"

namespace coapt {

struct AccuracyCase {
  Method method = Method::Fast;
  Membrane membrane = Membrane::Springs;
  int triangles = 0;       ///< asked for
  double tolerance = 0.0;  ///< of the residual; the predicted way follows in proportion
};

/// Against the reference: vertices at the same leaflet coordinates. NaN if the reference did not
/// converge uncrossed.
struct AccuracyPoint {
  std::string scene;
  AccuracyCase of;
  int triangles = 0;
  ClosureStatus status = ClosureStatus::StepLimit;
  bool crossing = false;
  /// Processor time, median of three closures (one if it takes longer than a second).
  double seconds = 0.0;
  double rms_mm = 0.0, max_mm = 0.0;
  double leak_error_mm2 = 0.0;      ///< leak less that of the reference
  double own_rms_mm = 0.0;          ///< from its own end (residual 1e-6)
  double own_leak_error_mm2 = 0.0;  ///< likewise
};

/// The presets and cases of the chart; `finest`: triangles of the reference (membrane continuum,
/// residual 1e-6), and of the largest case.
struct AccuracyStudyOptions {
  std::vector<std::string> presets = {"human-normal", "human-functional-mr"};
  std::vector<int> triangles = {300, 650, 1300, 2600};
  std::vector<double> tolerances = {0.1, 0.03, 0.01, 0.005, 0.001};
  std::vector<double> thesis_tolerances = {0.03, 0.01};  ///< the reference method is slow
  int most_thesis_triangles = 1300;
  int reference_triangles = 5200;
};

/// In order of preset, method and membrane, resolution, tolerance. `progress`: done and planned.
std::vector<AccuracyPoint> study_accuracy(const AccuracyStudyOptions& options,
                                          const std::function<void(int, int)>& progress = {});

}  // namespace coapt
