#include "core/closure/relaxation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "core/closure/moving_valve.h"

namespace coapt {
namespace {

// Annulus and tips are in place after as many steps as their longest path needs, but not fewer.
constexpr int kTravelSteps = 60;
constexpr double kLongestTravel_mm = 0.15;  // in one step
constexpr int kWindow_steps = 15;           // between two looks at how fast the moves shrink
constexpr double kSlowestShrink = 0.97;     // of moves from window to window, assumed at most
constexpr int kLook_steps = 90;             // between two looks for crossings: whole windows
// A relaxation goes back so often, with guards on such a share of the faces: more of them catch
// folds half way, and it is better to start again with contact of all edges.
constexpr int kMostGuards = 8;
constexpr int kGuardedShare = 8;  // of 1 / that many
constexpr int kMostReturns = 2;   // to one moment, before the one before it is taken
constexpr std::size_t kMoments = kMostGuards / kMostReturns + 1;  // that it may go back to
constexpr int kSampleInterval_steps = 5;
// Free edges that nothing holds flutter: pressure follows them, so that they circle. More damping from a share of the steps on ends
// that: with it a flail P2 takes 2,300 to 2,800 steps in place of 15,900.
constexpr int kLateShare = 4;  // of 1 / that many
constexpr double kLateDamping = 2.0;

// Leaflets creep if a window's move goes the way of the last one, nearly as far; then there is less damping, and more again
// when they turn. With it predicted closures of human-functional-mr take 384 steps in place of 591 (docs/experiments.md).
constexpr double kSameWay = 0.9, kTurned = 0.3;  // cosine of the angle between two moves
constexpr double kCreep = 0.8;                   // of the last window's move
constexpr double kEasing = 0.6;                  // of the damping

double longest_travel_mm(const ClosureModel& model, const Points& start_mm) {
  double longest = 0.0;
  for (Index i = 0; i < start_mm.rows(); ++i)
    if (model.fixed[i])
      longest = std::max(longest, (model.target_mm.row(i) - start_mm.row(i)).norm());
  return longest;
}

/// The faces whose edges have contact.
class Guards {
 public:
  Guards(const ClosureModel& model, const std::vector<int>& faces)
      : model_(model), guarded_(model.faces.rows(), false) {
    for (const int f : faces) guarded_[f] = true;
  }
  /// Adds the faces and all around them; where they are guarded already, all around the guarded
  /// ones.
  void add(const std::vector<std::pair<int, int>>& crossings) {
    std::vector<bool> chosen(guarded_.size(), false);
    bool known = true;
    for (const auto& [f, g] : crossings) {
      for (const int face : {f, g}) {
        chosen[face] = true;
        known = known && guarded_[face];
      }
    }
    if (known) chosen = guarded_;
    std::vector<bool> touched(model_.vertices, false);
    for (Index f = 0; f < model_.faces.rows(); ++f)
      if (chosen[f])
        for (int k = 0; k < 3; ++k) touched[model_.faces(f, k)] = true;
    for (Index f = 0; f < model_.faces.rows(); ++f)
      for (int k = 0; k < 3; ++k)
        if (touched[model_.faces(f, k)]) guarded_[f] = true;
  }
  bool too_many() const {
    return std::count(guarded_.begin(), guarded_.end(), true) * kGuardedShare >
           std::ssize(guarded_);
  }
  std::vector<int> faces() const {
    std::vector<int> result;
    for (std::size_t f = 0; f < guarded_.size(); ++f)
      if (guarded_[f]) result.push_back(static_cast<int>(f));
    return result;
  }

 private:
  const ClosureModel& model_;
  std::vector<bool> guarded_;
};

/// How far a relaxation is.
struct Progress {
  int step = 0;
  Points before_mm;           // at the end of the last window
  double last_move_mm = 0.0;  // rms, in that window
  Points last_way_mm;         // of the leaflets, in that window; none where damping is not eased
};

/// What a relaxation can go back to.
template <class R>
struct Moment {
  typename MovingValve<R>::Moment valve;
  Progress progress;
  int returns = 0;
};

template <class R>
struct Relaxation {
  const ClosureModel& model;
  const RelaxationSettings& settings;
  MovingValve<R> valve;
  Guards guards;
  int travel_steps = 0;        // until annulus and tips are in place
  double fixed_move_mm = 0.0;  // of theirs, in one of these steps
  Progress now{};
  std::vector<Moment<R>> moments{};  // without crossings, oldest first
  Index motion_before = 0;           // states recorded before the first step
  int returns = 0;
  double damping = settings.damping;
  bool gave_up = false;
  bool settled = false;  // at the end of the last window; the next step is taken with a fresh list
  bool uncrossed = false;  // looked, and nothing has moved since
  ClosureRun run{};
};

template <class R>
Relaxation<R> start_relaxation(const ClosureModel& model, const RelaxationSettings& settings,
                               const ClosureRun* start) {
  const Points& start_mm = start ? start->x_mm : model.rest_mm;
  Relaxation<R> r{model, settings, MovingValve<R>(model, settings, start_mm),
                  Guards(model, start ? start->guarded_faces : std::vector<int>{})};
  if (start && !start->guarded_faces.empty() && !settings.contact.edges)
    r.valve.guard(edges_of(model.faces, r.guards.faces()));
  const double travel_mm = longest_travel_mm(model, start_mm);
  r.travel_steps =
      std::max(start ? 1 : kTravelSteps, static_cast<int>(travel_mm / kLongestTravel_mm));
  r.fixed_move_mm = travel_mm / r.travel_steps;
  r.now.before_mm = start_mm;
  std::vector<Points>& motion_mm = r.run.motion_mm;
  if (settings.motion && start) motion_mm = start->motion_mm;
  if (settings.motion && motion_mm.empty()) motion_mm.push_back(start_mm);
  r.motion_before = std::ssize(motion_mm);
  r.moments.push_back({r.valve.moment(), r.now});
  return r;
}

template <class R>
void take_step(Relaxation<R>& r, bool fresh_list) {
  ++r.run.steps, ++r.now.step;
  r.uncrossed = false;
  const bool travelling = r.now.step <= r.travel_steps;
  if (travelling) r.valve.place_fixed(static_cast<double>(r.now.step) / r.travel_steps);
  if (fresh_list) r.valve.list();
  r.valve.step(travelling ? r.fixed_move_mm : 0.0);
}

/// Back to the last moment that was not returned to too often, with guards on the faces that cross;
/// or gives up.
template <class R>
void go_back(Relaxation<R>& r, const std::vector<std::pair<int, int>>& crossings) {
  r.guards.add(crossings);
  while (!r.moments.empty() && r.moments.back().returns == kMostReturns) r.moments.pop_back();
  r.gave_up = ++r.returns > kMostGuards || r.moments.empty() || r.guards.too_many();
  if (r.gave_up) return;
  r.valve.guard(edges_of(r.model.faces, r.guards.faces()));
  Moment<R>& moment = r.moments.back();
  ++moment.returns;
  r.valve.return_to(moment.valve);
  r.now = moment.progress;
  if (r.settings.motion) r.run.motion_mm.resize(r.motion_before + r.now.step / kWindow_steps);
  r.run.residual = std::numeric_limits<double>::infinity();  // until the next step
}

/// False where there are crossings, and the relaxation has gone back.
template <class R>
bool is_uncrossed(Relaxation<R>& r) {
  if (!r.settings.guards || r.settings.contact.edges) return true;
  if (const auto crossings = r.valve.crossings(); !crossings.empty()) {
    go_back(r, crossings);
    return false;
  }
  r.uncrossed = true;
  r.moments.push_back({r.valve.moment(), r.now});
  if (r.moments.size() > kMoments) r.moments.erase(r.moments.begin());
  return true;
}

/// Rms displacement of the leaflets that remains until rest, from how fast the moves of the windows
/// shrink.
double remaining_mm(const Points& x_mm, int vertices, Progress& now) {
  const double move = std::sqrt((x_mm - now.before_mm).topRows(vertices).squaredNorm() / vertices);
  const double shrink =
      now.last_move_mm > 0.0 ? std::min(kSlowestShrink, move / now.last_move_mm) : kSlowestShrink;
  now.last_move_mm = move;
  now.before_mm = x_mm;
  return move * shrink / (1.0 - shrink);
}

template <class R>
void ease_damping(Relaxation<R>& r, const Points& x_mm) {
  const Points way_mm = (x_mm - r.now.before_mm).topRows(r.model.vertices);
  const double length = way_mm.norm(), last_length = r.now.last_way_mm.norm();
  if (length > 0.0 && last_length > 0.0) {
    const double cosine = way_mm.cwiseProduct(r.now.last_way_mm).sum() / (length * last_length);
    if (cosine > kSameWay && length > kCreep * last_length)
      r.damping = std::max(r.settings.least_damping, kEasing * r.damping);
    else if (cosine < kTurned)
      r.damping = std::min(r.settings.damping, r.damping / kEasing);
    r.valve.damp(r.damping);
  }
  r.now.last_way_mm = way_mm;
}

template <class R>
void end_window(Relaxation<R>& r) {
  if (r.settings.allowance && !r.settings.allowance->spend(kWindow_steps)) {
    r.gave_up = true;
    return;
  }
  const Points x = r.valve.positions();
  if (!std::isfinite(r.run.residual) || has_diverged(x)) {
    r.run.status = ClosureStatus::Diverged;
    return;
  }
  if (r.settings.motion) r.run.motion_mm.push_back(x);
  const bool is_late = r.run.steps >= r.settings.max_steps / kLateShare;
  if (r.settings.least_damping < r.settings.damping && !is_late) ease_damping(r, x);
  const double remaining = remaining_mm(x, r.model.vertices, r.now);
  if (r.now.step % kLook_steps == 0 && !is_uncrossed(r)) return;
  r.settled = r.now.step >= r.travel_steps + kWindow_steps &&
              r.run.residual <= r.settings.residual_tolerance &&
              remaining <= r.settings.way_tolerance_mm;
}

template <class R>
ClosureRun finish(Relaxation<R>& r) {
  ClosureRun run = std::move(r.run);
  run.x_mm = r.valve.positions();
  if (r.settings.motion) run.motion_mm.push_back(run.x_mm);
  run.guarded_faces = r.guards.faces();
  if (r.settings.contact.edges) {  // who starts from here needs them all
    run.guarded_faces.resize(static_cast<std::size_t>(r.model.faces.rows()));
    std::iota(run.guarded_faces.begin(), run.guarded_faces.end(), 0);
  }
  if (has_diverged(run.x_mm) || std::isnan(run.residual)) run.status = ClosureStatus::Diverged;
  if (run.status != ClosureStatus::Diverged && !r.uncrossed)
    run.crossing_pairs = static_cast<int>(r.valve.crossings().size());
  if (run.status != ClosureStatus::Converged) return run;
  run.samples_mm.push_back(run.x_mm.topRows(r.model.vertices));
  for (int s = 1; s < r.settings.samples; ++s) {
    for (int k = 0; k < kSampleInterval_steps; ++k, ++run.steps) r.valve.step(0.0);
    run.samples_mm.push_back(r.valve.positions().topRows(r.model.vertices));
  }
  return run;
}

}  // namespace

template <class R>
ClosureRun relax(const ClosureModel& model, const RelaxationSettings& settings,
                 const ClosureRun* start) {
  Relaxation<R> r = start_relaxation<R>(model, settings, start);
  while (r.run.status == ClosureStatus::StepLimit && r.run.steps < settings.max_steps &&
         !r.gave_up) {
    const bool was_settled = std::exchange(r.settled, false);
    take_step(r, was_settled);
    if (r.run.steps == settings.max_steps / kLateShare)
      r.valve.damp(kLateDamping * settings.damping);
    const bool window_ends = r.now.step % kWindow_steps == 0;
    if (was_settled || window_ends || r.run.steps == settings.max_steps)
      r.run.residual = r.valve.residual();
    if (was_settled && r.run.residual <= settings.residual_tolerance) {
      if (is_uncrossed(r)) r.run.status = ClosureStatus::Converged;
    } else if (window_ends) {
      end_window(r);
    }
  }
  return finish(r);
}
template ClosureRun relax<float>(const ClosureModel&, const RelaxationSettings&, const ClosureRun*);
template ClosureRun relax<double>(const ClosureModel&, const RelaxationSettings&,
                                  const ClosureRun*);

}  // namespace coapt
