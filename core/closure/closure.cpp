// Method thesis: springs, pressure and contact in double precision, symplectic Euler, viscous
// damping. Plain on purpose: every faster method is compared with it.
//
// Start: the unstressed shape. Annulus and papillary tips travel to their places under pressure in
// the first kBoundaryTravel_ms while the full pressure already acts; then they are fixed. A step
// that would carry a node further than kLongestMove_mm is shortened to it, so that no leaflet jumps
// over another. At rest means: rms free force / rms pressure force below the tolerance. If leaflets
// have crossed by then, the closure is run again with contact between edges too, at half the speed,
// then at a quarter.

#include "core/closure/closure.h"

#include <algorithm>
#include <cmath>

#include "core/closure/contact.h"
#include "core/closure/crossing.h"
#include "core/closure/model.h"

namespace coapt {
namespace {

constexpr double kBoundaryTravel_ms = 4.0;
constexpr double kLongestMove_mm = 0.1;  // a tenth of the contact thickness
constexpr double kLongestStep_ms = 0.025;
constexpr int kResidualEvery_steps = 20;
constexpr int kReruns = 2;
constexpr double kLost_mm = 1000.0;  // a node this far out: diverged

/// Positions, velocities and forces of one run.
struct State {
  Points x, v, force;
  Contact contact;
  double time_ms = 0.0;
};

double rms_free(const ClosureModel& model, const Points& force, int nodes) {
  double sum = 0.0;
  int count = 0;
  for (int i = 0; i < nodes; ++i) {
    if (model.fixed[static_cast<std::size_t>(i)]) continue;
    sum += force.row(i).squaredNorm();
    ++count;
  }
  return std::sqrt(sum / std::max(1, count));
}

void compute_forces(const ClosureModel& model, State& state) {
  state.force.setZero();
  add_elastic_forces(model, state.x, state.force);
  add_pressure_forces(model, state.x, state.force);
  state.contact.add_forces(model, state.x, state.force);
}

double residual(const ClosureModel& model, const State& state) {
  Points pressure = Points::Zero(state.x.rows(), 3);
  add_pressure_forces(model, state.x, pressure);
  const auto nodes = static_cast<int>(state.x.rows());
  const double load = rms_free(model, pressure, model.vertices);
  return load > 0.0 ? rms_free(model, state.force, nodes) / load
                    : rms_free(model, state.force, nodes);
}

void step(const ClosureModel& model, double dt, double damping_per_ms, double longest_move_mm,
          State& state) {
  compute_forces(model, state);
  state.time_ms += dt;
  const double travelled = std::min(1.0, state.time_ms / kBoundaryTravel_ms);
  const double keep = std::exp(-damping_per_ms * dt);
  for (Eigen::Index i = 0; i < state.x.rows(); ++i) {
    if (model.fixed[static_cast<std::size_t>(i)]) {
      state.x.row(i) =
          model.rest_mm.row(i) + travelled * (model.target_mm.row(i) - model.rest_mm.row(i));
      continue;
    }
    Vec3 v = keep * state.v.row(i) +
             (dt / model.mass_g[static_cast<std::size_t>(i)]) * state.force.row(i);
    const double move = dt * v.norm();
    if (move > longest_move_mm) v *= longest_move_mm / move;
    state.v.row(i) = v;
    state.x.row(i) += dt * v;
  }
}

bool lost(const State& state) {
  return !state.x.allFinite() || state.x.cwiseAbs().maxCoeff() > kLost_mm;
}

ClosureResult run(const ClosureModel& model, const ClosureOptions& options, int attempt) {
  const double speed = attempt < 2 ? 1.0 : 0.5;
  State state{
      model.rest_mm, Points::Zero(model.rest_mm.rows(), 3), Points::Zero(model.rest_mm.rows(), 3),
      Contact({options.contact_thickness_mm, options.contact_stiffness_n_per_mm4, attempt > 0})};
  const double dt = speed * std::min(kLongestStep_ms, model.stable_step_ms);
  const double longest_move = speed * kLongestMove_mm * options.contact_thickness_mm;
  ClosureResult result;
  while (result.steps < options.max_steps) {
    step(model, dt, options.damping_per_ms, longest_move, state);
    ++result.steps;
    if (result.steps % kResidualEvery_steps != 0) continue;
    if (lost(state)) {
      result.status = ClosureStatus::Diverged;
      break;
    }
    result.residual = residual(model, state);
    if (state.time_ms > kBoundaryTravel_ms && result.residual <= options.residual_tolerance) {
      result.status = ClosureStatus::Converged;
      break;
    }
  }
  result.closed_mm = state.x;  // all nodes; trimmed below
  result.samples_mm.push_back(state.x.topRows(model.vertices));
  const int apart = std::max(1, static_cast<int>(std::lround(options.sample_interval_ms / dt)));
  for (int s = 1; s < options.samples && result.status != ClosureStatus::Diverged; ++s) {
    for (int k = 0; k < apart; ++k) step(model, dt, options.damping_per_ms, longest_move, state);
    result.samples_mm.push_back(state.x.topRows(model.vertices));
    result.steps += apart;
  }
  return result;
}

void read_chordae(const Valve& valve, const ClosureModel& model, const Points& x,
                  ClosureResult& result) {
  result.tension_n.resize(valve.chordae.size());
  result.branch_points_mm.resize(valve.chordae.size());
  for (std::size_t c = 0; c < valve.chordae.size(); ++c) {
    const auto segments = valve.chordae[c].segments.size();
    result.tension_n[c].assign(segments, 0.0);
    result.branch_points_mm[c].setZero(static_cast<Eigen::Index>(segments), 3);
  }
  for (const Cable& cable : model.cables) {
    const auto c = static_cast<std::size_t>(cable.chorda),
               s = static_cast<std::size_t>(cable.segment);
    result.tension_n[c][s] = tension_n(cable, x);
    result.branch_points_mm[c].row(cable.segment) = end_position(cable, x);
  }
}

}  // namespace

ClosureResult close_valve(const Valve& valve, const ClosureOptions& options) {
  const ClosureModel model = make_closure_model(valve);
  ClosureResult result;
  int steps = 0;
  for (int attempt = 0; attempt <= kReruns; ++attempt) {
    result = run(model, options, attempt);
    steps += result.steps;
    result.crossing_pairs = 0;
    if (result.status == ClosureStatus::Diverged) continue;
    result.crossing_pairs = static_cast<int>(crossing_pairs(model.faces, result.closed_mm).size());
    if (result.crossing_pairs == 0) break;
  }
  result.steps = steps;
  result.crossing = result.crossing_pairs > 0;
  read_chordae(valve, model, result.closed_mm, result);
  result.closed_mm.conservativeResize(model.vertices, 3);
  return result;
}

const char* to_string(Method method) {
  switch (method) {
    case Method::Thesis:
      return "thesis";
  }
  return "";
}

const char* to_string(ClosureStatus status) {
  switch (status) {
    case ClosureStatus::Converged:
      return "converged";
    case ClosureStatus::StepLimit:
      return "step_limit";
    case ClosureStatus::Diverged:
      return "diverged";
  }
  return "";
}

}  // namespace coapt
