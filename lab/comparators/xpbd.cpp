// Small-step XPBD (Macklin, Mueller and Chentanez 2016; Macklin et al. 2019): in each substep positions
// are predicted from velocity and pressure, and then every spring, cable and contact pulls its nodes
// once, in turn, by the implicit solution of its own law at compliance 1 / (stiffness h^2). One sweep,
// multipliers start at zero. Springs are bilinear (the branch that is consistent with the corrected
// length), chordae and contacts unilateral; a contact's quadratic law has a closed solution too.
//
// Only the end counts, so masses are chosen, not given: half the sum of stiffness that a node has now
// (chordae count as taut). An explicit method could take steps up to h = 1.4 with them, the first substep
// is kReach. One sweep in turn does not see the same positions everywhere: the state at which substeps
// repeat themselves is off balance by about (h omega)^2, a residual of 0.06 at h = 0.3, 0.02 at 0.15.
// Hence, not in the papers: when nothing moves any more and the residual does not fall, substeps get
// shorter. With fixed ones it is rarely at rest by the residual that the other methods are judged by.

#include "lab/comparators/xpbd.h"

#include <algorithm>
#include <cmath>

#include "core/closure/crossing.h"
#include "core/closure/residual.h"
#include "lab/comparators/spring_law.h"

namespace coapt::comparators {
namespace {

constexpr int kTravelSteps = 200;
constexpr int kResidualEvery_steps = 20;
constexpr double kReach = 0.5;
// Without a fall of the residual to kFall, before substeps get shorter.
constexpr int kPatience_steps = 100;
constexpr double kFall = 0.8, kShorter = 0.7, kLeastSubstep = 0.1;
constexpr double kStill_mm = 0.02;  // rms, moved in that time: more and it is still under way

class Xpbd {
 public:
  Xpbd(const ClosureModel& model, const XpbdSettings& settings)
      : model_(model),
        settings_(settings),
        contact_(settings.contact),
        x_(model.rest_mm),
        before_(model.rest_mm) {
    set_substep(settings.substep);
    weigh();
  }

  /// A velocity is a move over the substep.
  void shorten() {
    before_ = x_ - kShorter * (x_ - before_);
    set_substep(std::max(kLeastSubstep, kShorter * substep_));
  }

  void step(double travelled) {
    Points pressure = Points::Zero(x_.rows(), 3);
    add_pressure_forces(model_, x_, pressure);
    Points next = x_;
    for (Eigen::Index i = 0; i < x_.rows(); ++i) {
      if (model_.fixed[at(i)]) {
        next.row(i) =
            model_.rest_mm.row(i) + travelled * (model_.target_mm.row(i) - model_.rest_mm.row(i));
        continue;
      }
      Vec3 move =
          keep_ * (x_.row(i) - before_.row(i)) + step2_ * inverse_mass_[at(i)] * pressure.row(i);
      const double way = move.norm();
      if (way > settings_.longest_move_mm) move *= settings_.longest_move_mm / way;
      next.row(i) += move;
    }
    before_ = std::move(x_);
    x_ = std::move(next);
    touches_ = contact_.touches(model_, x_);
    weigh();
    for (const Spring& s : model_.springs) solve(s);
    for (const Cable& c : model_.cables) solve(c);
    for (const Touch& t : touches_) solve(t);
  }

  const Points& positions() const { return x_; }

  double residual_now() {
    Points force = Points::Zero(x_.rows(), 3);
    add_elastic_forces(model_, x_, force);
    add_pressure_forces(model_, x_, force);
    contact_.add_forces(model_, x_, force);
    return residual(model_, x_, force);
  }

 private:
  void set_substep(double substep) {
    substep_ = substep;
    step2_ = kReach * kReach * substep * substep;
    keep_ = std::pow(settings_.keep, substep);
  }

  static std::size_t at(Eigen::Index i) { return static_cast<std::size_t>(i); }

  /// Masses: half the sum of stiffness at each node, of tissue as it is now and taut cables.
  void weigh() {
    std::vector<double> sum(model_.fixed.size(), 0.0);
    for (const Spring& s : model_.springs) {
      const double length = (x_.row(s.b) - x_.row(s.a)).norm();
      const bool stiff = length > (0.98 + s.transition) * s.rest_mm;
      for (const int i : {s.a, s.b})
        sum[at(i)] += stiff ? s.post_n_per_mm : std::max(s.pre_n_per_mm, 0.05 * s.post_n_per_mm);
    }
    for (const Touch& t : touches_)
      for (std::size_t k = 0; k < 4; ++k)
        sum[at(t.nodes[k])] += 2.0 * std::abs(t.weights[k]) * t.force_n_per_mm2 * t.gap_mm;
    for (const Cable& c : model_.cables) {
      sum[at(c.start)] += c.stiffness_n_per_mm;
      for (const NodeShare& s : c.end) sum[at(s.node)] += s.weight * c.stiffness_n_per_mm;
    }
    inverse_mass_.assign(sum.size(), 0.0);
    for (std::size_t i = 0; i < sum.size(); ++i)
      if (!model_.fixed[i]) inverse_mass_[i] = 1.0 / sum[i];
  }

  /// The force that the corrected length has, times h^2, of a law that is linear around `length`.
  double multiplier(const Pull& pull, double w) const {
    return step2_ * pull.tension_n / (1.0 + step2_ * pull.stiffness_n_per_mm * w);
  }

  void solve(const Spring& s) {
    const Vec3 d = (x_.row(s.b) - x_.row(s.a)).transpose();
    const double length = d.norm(), w = inverse_mass_[at(s.a)] + inverse_mass_[at(s.b)];
    if (w == 0.0 || length == 0.0) return;
    Pull pull = pull_of(s, length);
    double lambda = multiplier(pull, w);
    const double knee = (1.0 + s.transition) * s.rest_mm;
    const bool beyond = length > knee;
    if (beyond != (length - w * lambda > knee)) {
      // The corrected length lies on the other branch: its line, extended to here.
      const double at_knee_n = s.pre_n_per_mm * s.transition * s.rest_mm;
      const double other = beyond ? s.pre_n_per_mm : s.post_n_per_mm;
      pull = {at_knee_n + other * (length - knee), other};
      lambda = multiplier(pull, w);
    }
    const Vec3 push = (lambda / length) * d;
    x_.row(s.a) += inverse_mass_[at(s.a)] * push;
    x_.row(s.b) -= inverse_mass_[at(s.b)] * push;
  }

  void solve(const Cable& c) {
    const Vec3 d = end_position(c, x_) - Vec3(x_.row(c.start));
    const double length = d.norm();
    const Pull pull = pull_of(c, length);
    if (pull.tension_n <= 0.0) return;
    double w = inverse_mass_[at(c.start)];
    for (const NodeShare& s : c.end) w += s.weight * s.weight * inverse_mass_[at(s.node)];
    if (w == 0.0) return;
    const Vec3 push = (multiplier(pull, w) / length) * d;
    x_.row(c.start) += inverse_mass_[at(c.start)] * push;
    for (const NodeShare& s : c.end) x_.row(s.node) -= s.weight * inverse_mass_[at(s.node)] * push;
  }

  /// lambda = h^2 k (gap - w lambda)^2, the smaller root.
  void solve(const Touch& t) {
    Vec3 between = Vec3::Zero();
    double w = 0.0;
    for (std::size_t k = 0; k < 4; ++k) {
      between += t.weights[k] * x_.row(t.nodes[k]);
      w += t.weights[k] * t.weights[k] * inverse_mass_[at(t.nodes[k])];
    }
    const double gap = t.thickness_mm - between.norm();
    if (w == 0.0 || gap <= 0.0) return;
    const double k = step2_ * t.force_n_per_mm2, b = 1.0 + 2.0 * k * gap * w;
    const double lambda =
        2.0 * k * gap * gap / (b + std::sqrt(b * b - 4.0 * k * k * gap * gap * w * w));
    const Vec3 push = lambda * between.normalized();
    for (std::size_t n = 0; n < 4; ++n)
      x_.row(t.nodes[n]) += t.weights[n] * inverse_mass_[at(t.nodes[n])] * push;
  }

  const ClosureModel& model_;
  const XpbdSettings& settings_;
  Contact contact_;
  double substep_ = 1.0, step2_ = 0.0, keep_ = 0.0;  // h, h^2 with the reach, velocity left
  std::vector<double> inverse_mass_;                 // |N|, 0: fixed
  Points x_, before_;
  std::vector<Touch> touches_;
};

}  // namespace

ClosureRun run_xpbd(const ClosureModel& model, const XpbdSettings& settings) {
  Xpbd state(model, settings);
  ClosureRun run;
  double stalled_at = 0.0;      // residual when the patience began
  Points then = model.rest_mm;  // where it began
  int since = kTravelSteps;
  while (run.steps < settings.max_steps) {
    ++run.steps;
    state.step(std::min(1.0, static_cast<double>(run.steps) / kTravelSteps));
    if (run.steps % kResidualEvery_steps != 0) continue;
    if (has_diverged(state.positions())) {
      run.status = ClosureStatus::Diverged;
      break;
    }
    run.residual = state.residual_now();
    if (run.steps >= kTravelSteps && run.residual <= settings.residual_tolerance) {
      run.status = ClosureStatus::Converged;
      break;
    }
    if (run.steps < since + kPatience_steps) continue;
    const double moved = (state.positions() - then).norm() / std::sqrt(model.vertices);
    if (stalled_at > 0.0 && run.residual > kFall * stalled_at && moved < kStill_mm) state.shorten();
    stalled_at = run.residual;
    then = state.positions();
    since = run.steps;
  }
  run.x_mm = state.positions();
  if (run.status != ClosureStatus::Diverged)
    run.crossing_pairs = static_cast<int>(crossing_pairs(model.faces, run.x_mm).size());
  if (run.status == ClosureStatus::Converged)
    run.samples_mm.push_back(run.x_mm.topRows(model.vertices));
  return run;
}

}  // namespace coapt::comparators
