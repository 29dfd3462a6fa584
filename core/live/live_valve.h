// A valve that moves under the hand: method fast's relaxation, kept going while pressure, annulus, tips, chordae and hooks change.
//
// The way is not that of real time (relaxation.h): a beat has no duration here, and what is told is where forces balance. Every
// state that is shown was tested for crossings. Where leaflets would cross, the valve goes back to the last state that was
// uncrossed and goes on in shorter moves and with contact of edges; if that does not help, hooks give way to where the tissue is.
//
// A valve has more than one closed state, and a hook or a change may leave it in another one than it closes to. So a valve under
// pressure that is let go, or has come to rest after a change, beats once: it goes back to its unstressed shape and closes from
// there, step by step as close_valve does.
#pragma once

#include <array>
#include <memory>
#include <optional>

#include "core/closure/closure_options.h"
#include "core/live/hook.h"
#include "core/valve/pressure_unit.h"
#include "core/valve/problem_list.h"
#include "core/valve/valve.h"

namespace coapt {

inline constexpr int kHooks = 2;

/// Of the ventricle over the atrium; the valve's own (Valve::pressure_kpa) is that of systole, and may be larger.
inline constexpr Range kLivePressures_mmhg{-10.0, 250.0};
/// Valve::pressure_kpa of a valve that can be live under it.
inline constexpr Range kLiveSystoles_kpa{0.0, kLivePressures_mmhg.max / kMmhgPerKpa};

/// Of advance(), from one look for crossings to the next.
inline constexpr int kLook_steps = 30;

/// One cable of a chorda or tie as it is drawn.
struct LiveCable {
  int chorda = 0, segment = 0;  ///< chorda -1: of tie `segment`
  Vec3 start_mm = Vec3::Zero(), end_mm = Vec3::Zero();
  double tension_n = 0.0;
  double strain = 0.0;  ///< over its rest length; 0 where slack
};

class LiveValve {
 public:
  /// Begins with the unstressed shape, annulus and tips on their way to their places under pressure. @pre validate(valve) is empty.
  explicit LiveValve(const Valve& valve, double pressure_mmhg = 0.0, const HookLimits& limits = {});
  ~LiveValve();
  LiveValve(const LiveValve&) = delete;
  LiveValve& operator=(const LiveValve&) = delete;

  /// Goes on with this valve from where the leaflets are, and beats once it has come to rest; hooks stay, but those on chordae or
  /// ties only where these are the same. Where the mesh is another one, from its unstressed shape, and hooks are let go. @pre validate(valve) is empty.
  void change(const Valve& valve);

  /// @pre in kLivePressures_mmhg.
  void set_pressure(double pressure_mmhg);
  double pressure_mmhg() const;

  /// A hook that holds the leaflet around a vertex, or a chorda or tie a share of its way along cable `cable` (as in cables()).
  /// The hand is where the spot is. @pre hook in [0, kHooks), vertex and cable are ones.
  void grab(int hook, int vertex);
  void grab_cable(int hook, int cable, double share);
  /// The hand, mm. @pre the hook holds something, the place is finite.
  void move_to(int hook, const Vec3& hand_mm);
  /// A constant pull in place of the hand's, N. @pre likewise.
  void pull_with(int hook, const Vec3& force_n);
  /// Of the last hook under pressure: the valve beats.
  void release(int hook);
  const std::optional<Hook>& hook(int hook) const;

  /// So many steps, at least; then a look for crossings.
  void advance(int steps);

  /// Of the last state that was uncrossed, |N| x 3, mm: the leaflets' vertices, then branch points and knots.
  const Points& vertices_mm() const;
  int vertices() const;  ///< |V|
  std::vector<LiveCable> cables() const;
  /// On the tissue, N; zero if it holds nothing.
  Vec3 force_n(int hook) const;
  /// The spot that it holds, mm. @pre it holds something.
  Vec3 spot_mm(int hook) const;

  /// Longest move of a node in the last step, mm.
  double longest_move_mm() const;
  /// Whether nothing moves that one could see: moves below 1e-4 mm a step for 100 steps, and no beat is going on or due.
  bool at_rest() const;
  /// Whether the valve is on its way to its unstressed shape.
  bool beats() const;
  /// How often the valve went back because leaflets would have crossed.
  int returns() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace coapt
