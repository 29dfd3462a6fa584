#include "lab/closures/accuracy_study.h"

#include <cmath>
#include <limits>

#include "core/metrics/leak.h"
#include "core/metrics/quantile.h"
#include "core/presets/presets.h"
#include "lab/closures/closure_study.h"
#include "lab/closures/matching_points.h"
#include "lab/closures/processor_time.h"
#include "lab/leak/reference_leak.h"
#include "search/evaluator.h"

namespace coapt {
namespace {

constexpr double kWayPerTolerance_mm = 4.0;  // as the defaults: 0.02 mm at 0.005
constexpr int kRepeats = 3;
constexpr double kLongClosure_seconds = 1.0;

struct Reference {
  ClosedMesh mesh;
  double leak_mm2 = 0.0;
};

Reference make_reference(const std::string& preset, int triangles) {
  Reference reference;
  reference.mesh.valve = *make_preset(preset, triangles);
  const ClosureResult closed =
      close_valve(reference.mesh.valve, to_the_end({.membrane = Membrane::Continuum}));
  reference.mesh.coordinates = leaflet_coordinates(reference.mesh.valve);
  reference.mesh.closed_mm = closed.closed_mm;
  reference.leak_mm2 =
      reference_leak(leak_surface(reference.mesh.valve, closed.closed_mm)).area_mm2;
  if (!trusted(closed)) {
    // Nothing can be told against it.
    reference.mesh.closed_mm.setConstant(std::numeric_limits<double>::quiet_NaN());
    reference.leak_mm2 = std::numeric_limits<double>::quiet_NaN();
  }
  return reference;
}

std::vector<AccuracyCase> cases(const AccuracyStudyOptions& options) {
  std::vector<AccuracyCase> all;
  for (const Membrane membrane : {Membrane::Springs, Membrane::Continuum})
    for (const int triangles : options.triangles)
      for (const double tolerance : options.tolerances)
        all.push_back({Method::Fast, membrane, triangles, tolerance});
  for (const int triangles : options.triangles)
    for (const double tolerance : options.thesis_tolerances)
      if (triangles <= options.most_thesis_triangles)
        all.push_back({Method::Thesis, Membrane::Springs, triangles, tolerance});
  return all;
}

AccuracyPoint close_case(const AccuracyCase& of, const Valve& valve, const Points& there,
                         const ClosureResult& end, double reference_leak_mm2) {
  ClosureOptions options;
  options.method = of.method;
  options.membrane = of.membrane;
  options.residual_tolerance = of.tolerance;
  options.way_tolerance_mm = kWayPerTolerance_mm * of.tolerance;
  AccuracyPoint point;
  point.of = of;
  point.triangles = static_cast<int>(valve.faces.rows());
  std::vector<double> seconds;
  ClosureResult closed;
  do {
    const double start = processor_seconds();
    closed = close_valve(valve, options);
    seconds.push_back(processor_seconds() - start);
  } while (seconds.back() < kLongClosure_seconds && seconds.size() < kRepeats);
  point.seconds = quantile(seconds, 0.5);
  point.status = closed.status;
  point.crossing = closed.crossing;
  const Eigen::VectorXd apart = (closed.closed_mm - there).rowwise().norm();
  point.rms_mm = std::sqrt(apart.squaredNorm() / static_cast<double>(apart.size()));
  point.max_mm = apart.maxCoeff();
  point.leak_error_mm2 = measure_leak(valve, closed.closed_mm).area_mm2 - reference_leak_mm2;
  const ClosureError own = closure_error(valve, closed, end);
  point.own_rms_mm = own.rms_mm;
  point.own_leak_error_mm2 = own.leak_mm2;
  return point;
}

}  // namespace

std::vector<AccuracyPoint> study_accuracy(const AccuracyStudyOptions& options,
                                          const std::function<void(int, int)>& progress) {
  const std::vector<AccuracyCase> all = cases(options);
  const int planned = static_cast<int>(all.size() * options.presets.size());
  std::vector<AccuracyPoint> points;
  for (const std::string& preset : options.presets) {
    const Reference reference = make_reference(preset, options.reference_triangles);
    Valve valve;
    Points there;
    ClosureResult end;
    const AccuracyCase* last = nullptr;
    for (const AccuracyCase& of : all) {
      if (last == nullptr || last->triangles != of.triangles) {
        valve = *make_preset(preset, of.triangles);
        there = matching_points_mm(valve, reference.mesh);
      }
      if (last == nullptr || last->triangles != of.triangles || last->method != of.method ||
          last->membrane != of.membrane) {
        ClosureOptions to_end = to_the_end({.method = of.method, .membrane = of.membrane});
        if (of.method == Method::Thesis) to_end.residual_tolerance = 1e-5;
        end = close_valve(valve, to_end);
      }
      last = &of;
      points.push_back(close_case(of, valve, there, end, reference.leak_mm2));
      points.back().scene = preset;
      if (progress) progress(static_cast<int>(points.size()), planned);
    }
  }
  return points;
}

}  // namespace coapt
