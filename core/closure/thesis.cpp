#include "core/closure/thesis.h"

#include <algorithm>
#include <cmath>

#include "core/closure/crossing.h"
#include "core/closure/residual.h"

namespace coapt {
namespace {

constexpr double kBoundaryTravel_ms = 4.0;
constexpr double kLongestMove = 0.1;  // as a share of the contact thickness
constexpr double kLongestStep_ms = 0.025;
constexpr double kSampleInterval_ms = 0.5;
constexpr int kResidualEvery_steps = 20;

struct State {
  Points x, v, force;
  Contact contact;
  double time_ms = 0.0;
};

void compute_forces(const ClosureModel& model, State& state) {
  state.force.setZero();
  add_elastic_forces(model, state.x, state.force);
  add_pressure_forces(model, state.x, state.force);
  state.contact.add_forces(model, state.x, state.force);
}

/// False, and no step, once the state has diverged.
bool step(const ClosureModel& model, double dt, double damping_per_ms, double longest_move_mm,
          State& state) {
  if (has_diverged(state.x)) return false;
  compute_forces(model, state);
  state.time_ms += dt;
  const double travelled = std::min(1.0, state.time_ms / kBoundaryTravel_ms);
  const double keep = std::exp(-damping_per_ms * dt);
  for (Index i = 0; i < state.x.rows(); ++i) {
    if (model.fixed[i]) {
      state.x.row(i) =
          model.rest_mm.row(i) + travelled * (model.target_mm.row(i) - model.rest_mm.row(i));
      continue;
    }
    Vec3 v = keep * state.v.row(i) + (dt / model.mass_g[i]) * state.force.row(i);
    const double move = dt * v.norm();
    if (move > longest_move_mm) v *= longest_move_mm / move;
    state.v.row(i) = v;
    state.x.row(i) += dt * v;
  }
  return true;
}

}  // namespace

ClosureRun run_thesis(const ClosureModel& model, const ThesisSettings& settings) {
  const Points zero = Points::Zero(model.rest_mm.rows(), 3);
  State state{model.rest_mm, zero, zero, Contact(settings.contact)};
  const double dt =
      settings.speed * settings.step * std::min(kLongestStep_ms, model.stable_step_ms);
  const double longest_move = settings.speed * kLongestMove * settings.contact.thickness_mm;
  ClosureRun run;
  const auto steps = [&](int count) {
    for (int k = 0; k < count && run.steps < settings.max_steps; ++k, ++run.steps) {
      if (step(model, dt, settings.damping_per_ms, longest_move, state)) continue;
      run.status = ClosureStatus::Diverged;
      break;
    }
    run.x_mm = state.x;
  };
  const auto affordable = [&] {
    return settings.allowance == nullptr || settings.allowance->spend(kResidualEvery_steps);
  };
  while (run.status == ClosureStatus::StepLimit && run.steps < settings.max_steps && affordable()) {
    steps(kResidualEvery_steps);
    run.residual = residual(model, state.x, state.force);
    if (run.status == ClosureStatus::StepLimit && state.time_ms > kBoundaryTravel_ms &&
        run.residual <= settings.residual_tolerance)
      run.status = ClosureStatus::Converged;
  }
  if (run.status != ClosureStatus::Diverged)
    run.crossing_pairs = static_cast<int>(crossing_pairs(model.faces, run.x_mm).size());
  if (run.status != ClosureStatus::Converged) return run;
  const Points closed = run.x_mm;
  run.samples_mm.push_back(closed.topRows(model.vertices));
  const int apart = std::max(1, static_cast<int>(std::min(1e6, kSampleInterval_ms / dt)));
  for (int s = 1; s < settings.samples && run.steps + apart <= settings.max_steps; ++s) {
    steps(apart);
    run.samples_mm.push_back(state.x.topRows(model.vertices));
  }
  run.x_mm = closed;
  return run;
}

}  // namespace coapt
