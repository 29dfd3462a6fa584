#include "core/closure/relaxation.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/closure/moving_valve.h"

namespace coapt {
namespace {

// Annulus and tips are in place after as many steps as their longest way needs, but not fewer.
constexpr int kTravelSteps = 60;
constexpr double kLongestTravel_mm = 0.15;  // in one step
constexpr int kWindow_steps = 15;           // between two looks at how fast the moves shrink
constexpr double kSlowestShrink = 0.97;     // of moves from window to window, assumed at most
constexpr int kLook_steps = 90;             // between two looks for crossings: whole windows
// A relaxation goes back so often, with guards on such a share of the faces: more of them catch folds half
// way, and it is better to start again with contact of all edges.
constexpr int kMostGuards = 8;
constexpr int kGuardedShare = 8;  // of 1 / that many
constexpr int kMostReturns = 2;   // to one moment, before the one before it is taken
constexpr std::size_t kMoments = kMostGuards / kMostReturns + 1;  // that it may go back to
constexpr int kSampleInterval_steps = 5;

double longest_way_mm(const ClosureModel& model, const Points& start_mm) {
  double longest = 0.0;
  for (Eigen::Index i = 0; i < start_mm.rows(); ++i)
    if (model.fixed[static_cast<std::size_t>(i)])
      longest = std::max(longest, (model.target_mm.row(i) - start_mm.row(i)).norm());
  return longest;
}

/// The faces whose edges have contact.
class Guards {
 public:
  Guards(const ClosureModel& model, const std::vector<int>& faces)
      : model_(model), guarded_(static_cast<std::size_t>(model.faces.rows()), false) {
    for (const int f : faces) guarded_[static_cast<std::size_t>(f)] = true;
  }
  /// Adds the faces and all around them; where they are guarded already, all around the guarded ones.
  void add(const std::vector<std::pair<int, int>>& crossings) {
    std::vector<bool> chosen(guarded_.size(), false);
    bool known = true;
    for (const auto& [f, g] : crossings) {
      for (const int face : {f, g}) {
        chosen[static_cast<std::size_t>(face)] = true;
        known = known && guarded_[static_cast<std::size_t>(face)];
      }
    }
    if (known) chosen = guarded_;
    std::vector<bool> touched(static_cast<std::size_t>(model_.vertices), false);
    for (Eigen::Index f = 0; f < model_.faces.rows(); ++f)
      if (chosen[static_cast<std::size_t>(f)])
        for (int k = 0; k < 3; ++k) touched[static_cast<std::size_t>(model_.faces(f, k))] = true;
    for (Eigen::Index f = 0; f < model_.faces.rows(); ++f)
      for (int k = 0; k < 3; ++k)
        if (touched[static_cast<std::size_t>(model_.faces(f, k))])
          guarded_[static_cast<std::size_t>(f)] = true;
  }
  bool too_many() const {
    return std::count(guarded_.begin(), guarded_.end(), true) * kGuardedShare >
           static_cast<std::ptrdiff_t>(guarded_.size());
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
  Points before;  // at the end of the last window
  double last_way_mm = 0.0;
};

template <class R>
struct Moment {
  typename MovingValve<R>::Moment valve;
  Progress progress;
  int returns = 0;
};

}  // namespace

template <class R>
ClosureRun relax(const ClosureModel& model, const RelaxationSettings& settings,
                 const ClosureRun* start) {
  const Points& start_mm = start ? start->x_mm : model.rest_mm;
  MovingValve<R> valve(model, settings, start_mm);
  Guards guards(model, start ? start->guarded_faces : std::vector<int>{});
  if (start && !start->guarded_faces.empty() && !settings.contact.edges)
    valve.guard(edges_of(model.faces, guards.faces()));
  const double longest_way = longest_way_mm(model, start_mm);
  const int travel =
      std::max(start ? 1 : kTravelSteps, static_cast<int>(longest_way / kLongestTravel_mm));
  const double fixed_move = longest_way / travel;
  ClosureRun run;
  Progress now{0, start_mm, 0.0};
  if (settings.motion) run.motion_mm = start ? start->motion_mm : std::vector<Points>{};
  if (settings.motion && run.motion_mm.empty()) run.motion_mm.push_back(start_mm);
  const std::size_t came_from = run.motion_mm.size();
  std::vector<Moment<R>> moments{{valve.moment(), now, 0}};
  const bool guarded = settings.guards && !settings.contact.edges;
  int times_back = 0;
  bool gave_up = false;
  // Looks for crossings; whether the relaxation went back because of them or gave up.
  const auto went_back = [&] {
    if (!guarded) return false;
    const auto crossings = valve.crossings();
    if (crossings.empty()) {
      moments.push_back({valve.moment(), now, 0});
      if (moments.size() > kMoments) moments.erase(moments.begin());
      return false;
    }
    guards.add(crossings);
    while (!moments.empty() && moments.back().returns == kMostReturns) moments.pop_back();
    gave_up = ++times_back > kMostGuards || moments.empty() || guards.too_many();
    if (gave_up) return true;
    valve.guard(edges_of(model.faces, guards.faces()));
    ++moments.back().returns;
    valve.return_to(moments.back().valve);
    now = moments.back().progress;
    if (settings.motion)
      run.motion_mm.resize(came_from + static_cast<std::size_t>(now.step / kWindow_steps));
    run.residual = std::numeric_limits<double>::infinity();  // until the next step
    return true;
  };
  bool settled = false;  // in the last look; the step after it is taken with a fresh list
  while (run.steps < settings.max_steps && !gave_up) {
    ++run.steps, ++now.step;
    const bool travelling = now.step <= travel;
    if (travelling) valve.place_fixed(static_cast<double>(now.step) / travel);
    if (settled) valve.list();
    run.residual = valve.residual(valve.step(travelling ? fixed_move : 0.0));
    if (settled && run.residual <= settings.residual_tolerance) {
      settled = false;
      if (went_back()) continue;
      run.status = ClosureStatus::Converged;
      break;
    }
    settled = false;
    if (now.step % kWindow_steps != 0) continue;
    const Points x = valve.positions();
    if (!std::isfinite(run.residual) || lost(x)) {
      run.status = ClosureStatus::Diverged;
      break;
    }
    if (settings.motion) run.motion_mm.push_back(x);
    const double way =
        std::sqrt((x - now.before).topRows(model.vertices).squaredNorm() / model.vertices);
    const double shrink =
        now.last_way_mm > 0.0 ? std::min(kSlowestShrink, way / now.last_way_mm) : kSlowestShrink;
    const double left = way * shrink / (1.0 - shrink);
    now.last_way_mm = way;
    now.before = x;
    if (now.step % kLook_steps == 0 && went_back()) continue;
    settled = now.step >= travel + kWindow_steps && run.residual <= settings.residual_tolerance &&
              left <= settings.way_tolerance_mm;
  }
  run.x_mm = valve.positions();
  if (settings.motion) run.motion_mm.push_back(run.x_mm);
  run.guarded_faces = guards.faces();
  if (lost(run.x_mm) || std::isnan(run.residual)) run.status = ClosureStatus::Diverged;
  if (run.status != ClosureStatus::Diverged)
    run.crossing_pairs = static_cast<int>(valve.crossings().size());
  if (run.status != ClosureStatus::Converged) return run;
  run.samples_mm.push_back(run.x_mm.topRows(model.vertices));
  for (int s = 1; s < settings.samples; ++s) {
    for (int k = 0; k < kSampleInterval_steps; ++k, ++run.steps) valve.step(0.0);
    run.samples_mm.push_back(valve.positions().topRows(model.vertices));
  }
  return run;
}
template ClosureRun relax<float>(const ClosureModel&, const RelaxationSettings&, const ClosureRun*);
template ClosureRun relax<double>(const ClosureModel&, const RelaxationSettings&,
                                  const ClosureRun*);

}  // namespace coapt
