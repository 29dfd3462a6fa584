#include "lab/closures/stability_level.h"

#include <cmath>
#include <limits>

#include "core/closure/crossing.h"
#include "core/closure/relaxation.h"
#include "core/closure/residual.h"
#include "core/metrics/measure.h"
#include "lab/closures/closure_study.h"
#include "lab/closures/processor_time.h"
#include "search/evaluator.h"

namespace coapt {
namespace {

constexpr double kGranted = 1.5;  // of the residual, see kStabilityResidual
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr int kEndSteps = 20000;

}  // namespace

StabilityLevel::StabilityLevel(const StabilityScene& scene, Membrane membrane)
    : scene_(scene), model_(make_closure_model(scene.valve, membrane)), attempt_{scene.step, {}} {
  options_.membrane = membrane;
  options_.contact_pressure_mpa *= scene.contact_stiffness;
  const double thickness = scene.valve.tissue.thickness_mm;
  attempt_.contact = {thickness, options_.contact_pressure_mpa / (thickness * thickness), false};
  reference_ = close_valve(scene.valve, to_the_end(options_));
}

StabilityCell StabilityLevel::close(const StabilityMethod& method) const {
  StabilityCell cell;
  cell.method = method.name;
  const double start = processor_seconds();
  const ClosureRun run = method.close(model_, attempt_);
  cell.seconds = processor_seconds() - start;
  cell.steps = run.steps;
  judge(run, attempt_.contact, cell);
  return cell;
}

StabilityCell StabilityLevel::close_with_ladder() const {
  StabilityCell cell;
  cell.method = kLadderName;
  ClosureRun run;
  const double start = processor_seconds();
  const ClosureResult closed = close_valve(scene_.valve, options_);
  cell.seconds = processor_seconds() - start;
  cell.steps = closed.steps;
  cell.attempts = static_cast<int>(closed.attempts.size());
  run.status = closed.status;
  run.x_mm = all_nodes(closed);
  run.guarded_faces = closed.guarded_faces;
  ContactLaw contact = attempt_.contact;
  contact.edges = closed.guarded_faces.empty() && cell.attempts > 1;  // as every rung but the first
  judge(run, contact, cell);
  return cell;
}

/// |N| x 3 of a closure's vertices and branch points.
Points StabilityLevel::all_nodes(const ClosureResult& closed) const {
  Points x = model_.target_mm;
  x.topRows(model_.vertices) = closed.closed_mm;
  for (const Cable& cable : model_.cables)
    if (cable.end.front().node >= model_.vertices)
      x.row(cable.end.front().node) =
          closed.branch_points_mm[static_cast<std::size_t>(cable.chorda)].row(cable.segment);
  return x;
}

void StabilityLevel::judge(const ClosureRun& run, const ContactLaw& contact,
                           StabilityCell& cell) const {
  cell.from_reference_mm = cell.end_from_reference_mm = cell.leak_difference_mm2 = kNone;
  if (run.status == ClosureStatus::Diverged || has_diverged(run.x_mm)) {
    cell.outcome = StabilityOutcome::BlowsUp;
    cell.residual = kNone;
    return;
  }
  Points force = Points::Zero(run.x_mm.rows(), 3);
  add_elastic_forces(model_, run.x_mm, force);
  add_pressure_forces(model_, run.x_mm, force);
  Contact(contact, run.guarded_faces).add_forces(model_, run.x_mm, force);
  cell.residual = residual(model_, run.x_mm, force);
  cell.crossing_pairs = static_cast<int>(crossing_pairs(model_.faces, run.x_mm).size());
  const bool rests =
      run.status == ClosureStatus::Converged && cell.residual <= kGranted * kStabilityResidual;
  cell.outcome = !rests                    ? StabilityOutcome::Stalls
                 : cell.crossing_pairs > 0 ? StabilityOutcome::Crosses
                                           : StabilityOutcome::Settles;
  if (cell.outcome == StabilityOutcome::Settles && trusted(reference_)) compare(run, contact, cell);
}

void StabilityLevel::compare(const ClosureRun& run, const ContactLaw& contact,
                             StabilityCell& cell) const {
  ClosureResult answer = reference_;
  answer.closed_mm = run.x_mm.topRows(model_.vertices);
  answer.samples_mm = {answer.closed_mm};
  const ClosureError error = closure_error(scene_.valve, answer, reference_);
  cell.from_reference_mm = cell.end_from_reference_mm = error.rms_mm;
  cell.leak_difference_mm2 = error.leak_mm2;
  if (error.rms_mm <= kOtherEquilibrium_mm) return;
  // Stopped early, or on the way to somewhere else?
  const ClosureOptions to_end = to_the_end({});
  RelaxationSettings settings;
  settings.residual_tolerance = to_end.residual_tolerance;
  settings.way_tolerance_mm = to_end.way_tolerance_mm;
  settings.max_steps = kEndSteps;
  settings.contact = contact;
  const ClosureRun end = relax<double>(model_, settings, &run);
  if (end.status != ClosureStatus::Converged) return;
  const Points apart = end.x_mm.topRows(model_.vertices) - reference_.closed_mm;
  cell.end_from_reference_mm = std::sqrt(apart.squaredNorm() / static_cast<double>(apart.rows()));
  if (!(cell.end_from_reference_mm <= kOtherEquilibrium_mm))
    cell.outcome = StabilityOutcome::OtherEquilibrium;
}

}  // namespace coapt
