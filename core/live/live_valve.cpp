#include "core/live/live_valve.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "core/closure/moving_valve.h"
#include "core/closure/prepared_valve.h"
#include "core/closure/run.h"

namespace coapt {
namespace {

// Of annulus and tips, as in relaxation.cpp: another way to the same place may lead to another end.
constexpr double kLongestTravel_mm = 0.15;  // in one step
constexpr int kTravelSteps = 60;            // at least
constexpr double kLongestMove_mm = 0.15;    // of a node
constexpr double kShortestMove_mm = 0.02;   // where leaflets would cross
constexpr double kLonger = 1.2;             // than the moves before the last uncrossed look
// Leaflets that cross on the way may come apart by themselves. A closure looks every 90 steps, and what it does not see must not
// lead the live valve elsewhere.
constexpr int kLooksToReturn = 3;
constexpr int kMostReturns = 3;  // before hooks give way
constexpr double kStill_mm = 1e-4;
constexpr int kStill_steps = 100;
constexpr int kBeat_steps =
    3000;  // whole looks, until a valve that is let go closes again, at most
// Nothing but bending holds an unloaded leaflet in its shape: by itself it takes over 20,000 steps to come back, and may stay
// folded. These bring it there in 1,000, too weak to press it through another one.
constexpr double kDrawn_n_per_mm = 0.005, kDrawn_n = 0.01;  // on each node
constexpr double kDrawnStill_mm =
    1e-3;  // drawn into contact, nodes tremble by a few 1e-4 mm for good

/// Which node a segment of a chorda ends in, where that is a branch point.
std::map<std::pair<int, int>, int> branch_nodes(const ClosureModel& model) {
  std::map<std::pair<int, int>, int> nodes;
  for (const Cable& cable : model.cables)
    if (cable.chorda >= 0 && cable.end.size() == 1 && cable.end.front().node >= model.vertices)
      nodes[{cable.chorda, cable.segment}] = cable.end.front().node;
  return nodes;
}

/// Where the nodes of `to` start so that what both have stays where it is at `x_mm`. `heads`: of both, the last nodes.
Points carried_over(const ClosureModel& from, const Points& x_mm, const ClosureModel& to,
                    Index heads) {
  Points start = to.target_mm;
  start.topRows(to.vertices) = x_mm.topRows(to.vertices);
  start.bottomRows(heads) = x_mm.bottomRows(heads);
  const auto before = branch_nodes(from);
  for (const auto& [segment, node] : branch_nodes(to))
    if (const auto found = before.find(segment); found != before.end())
      start.row(node) = x_mm.row(found->second);
  for (std::size_t c = 0; c + 1 < to.cables.size(); ++c)
    if (to.cables[c].chorda < 0 && to.cables[c].start == to.cables[c + 1].start)
      start.row(to.cables[c].start) =
          0.5 *
          (end_position(to.cables[c], start) + end_position(to.cables[c + 1], start)).transpose();
  return start;
}

bool same_mesh(const ClosureModel& a, const ClosureModel& b) {
  return a.vertices == b.vertices && a.faces.rows() == b.faces.rows() && a.faces == b.faces;
}

bool same_ends(const Cable& a, const Cable& b) {
  const auto same_node = [](const NodeShare& s, const NodeShare& t) { return s.node == t.node; };
  return a.chorda == b.chorda && a.segment == b.segment && a.start == b.start &&
         std::equal(a.end.begin(), a.end.end(), b.end.begin(), b.end.end(), same_node);
}

bool same_cables(const ClosureModel& a, const ClosureModel& b) {
  return std::equal(a.cables.begin(), a.cables.end(), b.cables.begin(), b.cables.end(), same_ends);
}

}  // namespace

struct LiveValve::State {
  Valve valve;
  HookLimits limits;
  double pressure_mmhg;
  std::optional<PreparedValve> prepared{};
  ClosureModel model{};
  RelaxationSettings settings{};
  std::optional<MovingValve<float>> moving{};
  std::array<std::optional<Hook>, kHooks> hooks{};
  MovingValve<float>::Moment uncrossed{};
  Points shown_mm{};  // |N| x 3, of that moment
  std::array<Vec3, kHooks> hook_mm{};
  double travel_mm = 0.0;  // of annulus and tips in one step
  double longest_move_mm = 0.0;
  bool guarded = false;   // edges have contact
  int beat_steps = 0;     // left, at most, until the beat that has begun closes
  bool beat_due = false;  // once it is at rest: its valve was changed
  int looks = 0;
  int returns_here = 0, returns = 0, still_steps = 0;

  State(const Valve& v, double pressure, const HookLimits& hook_limits)
      : valve(v), limits(hook_limits), pressure_mmhg(pressure) {
    model = prepared.emplace(v, ClosureOptions{}).model(v);
    begin(model.rest_mm);
  }

  void begin(const Points& start_mm) {
    settings.contact = prepared->contact();
    settings.layout = &prepared->layout();
    settings.longest_move_mm = most_move_mm();
    moving.emplace(model, settings, start_mm);
    guarded = false;
    looks = 0;
    load();
    keep();
  }

  /// What acts on the valve from now on. A beat goes back to where closures start from: no pressure, annulus and tips where they
  /// are in the unstressed valve, every node drawn to its place there.
  void load() {
    if (beat_steps > 0)
      model.target_mm = model.rest_mm;
    else
      set_targets(valve, model);
    model.pressure_mpa = beat_steps > 0 ? 0.0 : kMpaPerKpa * pressure_mmhg / kMmhgPerKpa;
    moving->load(model.pressure_mpa);
    travel_mm = std::min(kLongestTravel_mm, moving->way_to_targets_mm() / kTravelSteps);
    still_steps = 0;
  }

  void start_beat() {
    beat_due = false;
    beat_steps = kBeat_steps;
    if (guarded) moving->guard({});
    guarded = false;
    load();
  }

  /// Closes from the unstressed shape to the last bit, as a cold closure does. Where folds that have caught in each other held
  /// some nodes back, they leap there.
  void end_beat() {
    beat_due = false;
    beat_steps = 0;
    begin(model.rest_mm);
  }

  void keep() {
    uncrossed = moving->moment();
    shown_mm = moving->positions();
    for (std::size_t h = 0; h < kHooks; ++h)
      if (hooks[h]) hook_mm[h] = hooks[h]->hook_mm;
    returns_here = 0;
  }

  /// To the last state without crossings.
  void go_back() {
    moving->return_to(uncrossed);
    if (!guarded) moving->guard(model.edges);
    guarded = true;
    settings.longest_move_mm = std::max(kShortestMove_mm, 0.5 * settings.longest_move_mm);
    ++returns;
    const bool give_way = ++returns_here > kMostReturns;
    if (give_way) returns_here = 0;
    for (std::size_t h = 0; h < kHooks; ++h) {
      if (!hooks[h]) continue;
      hooks[h]->hook_mm = give_way ? mean_position(hooks[h]->shares, shown_mm) : hook_mm[h];
      if (give_way) hooks[h]->hand_mm = hooks[h]->hook_mm;
    }
  }

  void step() {
    for (std::optional<Hook>& hook : hooks) {
      if (!hook) continue;
      approach_hand(*hook, limits);
      const Vec3 force = pull_n(*hook, moving->position(hook->shares), limits);
      moving->pull(hook->shares, force, hook->constant_n ? 0.0 : limits.stiffness_n_per_mm);
    }
    if (beat_steps > 0) moving->draw(model.rest_mm, kDrawn_n_per_mm, kDrawn_n);
    moving->step(moving->approach_targets(travel_mm));
    longest_move_mm = moving->longest_move_mm();
    still_steps =
        longest_move_mm < (beat_steps > 0 ? kDrawnStill_mm : kStill_mm) ? still_steps + 1 : 0;
  }

  void look() {
    ++looks;
    if (beat_steps > 0) {
      beat_steps -= kLook_steps;
      if (beat_steps <= 0 || still_steps >= kStill_steps) return end_beat();
    }
    if (moving->crossings().empty() && !has_diverged(moving->positions())) {
      settings.longest_move_mm = std::min(most_move_mm(), kLonger * settings.longest_move_mm);
      keep();
    } else if (looks % kLooksToReturn == 0) {
      go_back();
    }
    if (beat_due && still_steps >= kStill_steps && may_beat()) start_beat();
  }

  bool is_in_hand() const {
    return std::any_of(hooks.begin(), hooks.end(),
                       [](const auto& held) { return held.has_value(); });
  }

  /// As a closure; in a hand, no slower than the hand.
  double most_move_mm() const {
    return is_in_hand() ? kLongestMove_mm : prepared->longest_move_mm();
  }

  bool may_beat() const { return pressure_mmhg > 0.0 && !is_in_hand(); }

  void hold(int at, std::vector<NodeShare> shares) {
    const Vec3 spot = mean_position(shares, shown_mm);
    hooks[at] = Hook{std::move(shares), spot, spot};
    hook_mm[at] = spot;
    if (beat_steps > 0) {
      beat_steps = 0;
      load();
    }
    still_steps = 0;
  }
};

LiveValve::LiveValve(const Valve& valve, double pressure_mmhg, const HookLimits& limits)
    : state_(std::make_unique<State>(valve, pressure_mmhg, limits)) {}

LiveValve::~LiveValve() = default;

void LiveValve::change(const Valve& valve) {
  State& s = *state_;
  const bool same_heads = valve.heads.size() == s.valve.heads.size();
  s.valve = valve;
  if (s.prepared->serves(valve, {})) {
    s.beat_due = true;
    s.load();
    return;
  }
  ClosureModel model = make_closure_model(valve);
  const bool same = same_mesh(s.model, model);
  const Points start_mm =
      same ? carried_over(s.model, s.shown_mm, model, same_heads ? std::ssize(valve.heads) : 0)
           : model.rest_mm;
  const auto holds_chorda = [&](const Hook& hook) {
    return std::any_of(hook.shares.begin(), hook.shares.end(),
                       [&](const NodeShare& share) { return share.node >= s.model.vertices; });
  };
  for (std::optional<Hook>& hook : s.hooks)
    if (hook && (!same || (holds_chorda(*hook) && !same_cables(s.model, model)))) hook.reset();
  s.beat_due = same;
  s.moving.reset();
  s.prepared.emplace(valve, ClosureOptions{});
  s.model = std::move(model);
  s.begin(start_mm);
}

void LiveValve::set_pressure(double pressure_mmhg) {
  state_->pressure_mmhg = pressure_mmhg;
  state_->load();
}

double LiveValve::pressure_mmhg() const { return state_->pressure_mmhg; }

void LiveValve::grab(int hook, int vertex) {
  const Valve& valve = state_->valve;
  for (Index f = 0; f < valve.faces.rows(); ++f)
    for (int k = 0; k < 3; ++k)
      if (valve.faces(f, k) == vertex) {
        Insertion at{static_cast<int>(f), {0.0, 0.0, 0.0}};
        at.weights[static_cast<std::size_t>(k)] = 1.0;
        state_->hold(hook, insertion_zone(valve, at, kHookRadius_mm));
        return;
      }
}

void LiveValve::grab_cable(int hook, int cable, double share) {
  const Cable& held = state_->model.cables[static_cast<std::size_t>(cable)];
  std::vector<NodeShare> shares = {{held.start, 1.0 - share}};
  for (const NodeShare& end : held.end) shares.push_back({end.node, share * end.weight});
  state_->hold(hook, std::move(shares));
}

void LiveValve::move_to(int hook, const Vec3& hand_mm) {
  state_->hooks[hook]->hand_mm = hand_mm;
  state_->still_steps = 0;
}

void LiveValve::pull_with(int hook, const Vec3& force_n) {
  state_->hooks[hook]->constant_n = force_n;
  state_->still_steps = 0;
}

void LiveValve::release(int hook) {
  State& s = *state_;
  if (!s.hooks[hook]) return;
  s.hooks[hook].reset();
  s.still_steps = 0;
  if (s.may_beat()) s.start_beat();
}

const std::optional<Hook>& LiveValve::hook(int hook) const { return state_->hooks[hook]; }

void LiveValve::advance(int steps) {
  State& s = *state_;
  for (int done = 0; done < steps; done += kLook_steps) {
    for (int k = 0; k < kLook_steps; ++k) s.step();
    s.look();
  }
}

const Points& LiveValve::vertices_mm() const { return state_->shown_mm; }
int LiveValve::vertices() const { return state_->model.vertices; }

std::vector<LiveCable> LiveValve::cables() const {
  std::vector<LiveCable> cables;
  for (const Cable& cable : state_->model.cables) {
    LiveCable& live = cables.emplace_back(LiveCable{cable.chorda, cable.segment});
    live.start_mm = state_->shown_mm.row(cable.start);
    live.end_mm = end_position(cable, state_->shown_mm);
    live.tension_n = tension_n(cable, state_->shown_mm);
    live.strain = live.tension_n / (cable.stiffness_n_per_mm * cable.rest_mm);
  }
  return cables;
}

Vec3 LiveValve::force_n(int hook) const {
  const std::optional<Hook>& held = state_->hooks[hook];
  return held ? pull_n(*held, spot_mm(hook), state_->limits) : Vec3(Vec3::Zero());
}

Vec3 LiveValve::spot_mm(int hook) const {
  return mean_position(state_->hooks[hook]->shares, state_->shown_mm);
}

double LiveValve::longest_move_mm() const { return state_->longest_move_mm; }
bool LiveValve::at_rest() const {
  return state_->beat_steps == 0 && state_->still_steps >= kStill_steps &&
         !(state_->beat_due && state_->may_beat());
}
bool LiveValve::beats() const { return state_->beat_steps > 0; }
int LiveValve::returns() const { return state_->returns; }

}  // namespace coapt
