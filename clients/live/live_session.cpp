#include "clients/live/live_session.h"

#include <algorithm>
#include <chrono>
#include <thread>
#include <utility>

#include "clients/live/mailbox.h"
#include "core/live/nearest_hold.h"
#include "core/live/passivity.h"

namespace coapt {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::microseconds kNap(500);  // of the valve's thread where nothing moves
constexpr double kLongestKept_s = 600.0;        // of periods in the figures: memory is taken before

/// What the device's loop wants of the valve. A grasp has a number, from 1.
struct Wish {
  int grasp = 0;
  bool holds = false;
  Vec3 hand_mm = Vec3::Zero();
};

/// What the valve says.
struct Held {
  int grasp = 0;
  Vec3 shift_mm = Vec3::Zero();  ///< from the hand to the spot when it was taken hold of
  Vec3 spot_mm = Vec3::Zero();
};

struct Exchange {
  Mailbox<Wish> wishes;
  Mailbox<Held> held;
  std::atomic<bool> over = false;
};

/// The valve's thread, until the exchange is over.
void advance_valve(LiveValve& live, Exchange& exchange, SessionResult& result) {
  Held held;
  bool holds = false;
  while (!exchange.over) {
    const Wish wish = exchange.wishes.latest();
    if (holds && (!wish.holds || wish.grasp != held.grasp)) {
      live.release(0);
      holds = false;
    }
    if (wish.holds && wish.grasp != held.grasp) {
      const Hold hold = nearest_hold(live, wish.hand_mm);
      grab(live, 0, hold);
      holds = true;
      held.grasp = wish.grasp;
      held.shift_mm = live.spot_mm(0) - wish.hand_mm;
    }
    if (holds) live.move_to(0, wish.hand_mm + held.shift_mm);
    if (!holds && live.at_rest()) {
      std::this_thread::sleep_for(kNap);
      continue;
    }
    const auto start = Clock::now();
    live.advance(kLook_steps);
    const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
    result.steps += kLook_steps;
    result.valve_seconds += seconds;
    if (result.look_us.size() < result.look_us.capacity()) result.look_us.push_back(1e6 * seconds);
    if (holds) {
      held.spot_mm = live.spot_mm(0);
      exchange.held.put(held);
    }
  }
  if (holds) live.release(0);
}

/// The hand between two looks of the valve.
class Hand {
 public:
  Hand(const SessionOptions& options, SessionResult& result)
      : options_(options), result_(result), period_ms_(1e3 / options.rate_hz) {}

  /// The force to show for a fresh state, N. The next one is expected after as long as this one took to come, and no sooner than
  /// in a period.
  Vec3 feel(const StylusState& stylus, double time_ms, Exchange& exchange) {
    const double interval_ms = std::max(period_ms_, time_ms - felt_ms_);
    felt_ms_ = time_ms;
    if (stylus.grabs && !wish_.holds) {
      ++wish_.grasp;
      account_ = {};
    } else if (!stylus.grabs && wish_.holds) {
      let_go(stylus);
    }
    wish_.holds = stylus.grabs;
    wish_.hand_mm = options_.scale * stylus.position_mm;
    exchange.wishes.put(wish_);
    held_ = exchange.held.latest();
    if (!holds()) return Vec3::Zero();
    Hook hook;
    hook.hook_mm = wish_.hand_mm + held_.shift_mm;
    const Vec3 wanted = -pull_n(hook, held_.spot_mm, HookLimits{});
    const Vec3 shown = passive_force_n(account_, stylus.position_mm, wanted, interval_ms);
    result_.largest_force_n = std::max(result_.largest_force_n, shown.norm());
    return shown;
  }

  /// Closes the account of a grasp.
  void let_go(const StylusState& stylus) {
    observe(account_, stylus.position_mm);
    result_.energy_mj += account_.energy_mj;
    result_.lowest_energy_mj = std::min(result_.lowest_energy_mj, account_.lowest_mj);
    ++result_.grasps;
    wish_.holds = false;
  }

  bool holds() const { return wish_.holds && held_.grasp == wish_.grasp; }
  bool grabs() const { return wish_.holds; }
  SessionRow row(const StylusState& stylus, const Vec3& force_n) const {
    return {0.0,
            0.0,
            stylus.position_mm,
            force_n,
            holds() ? held_.spot_mm : Vec3(Vec3::Zero()),
            holds(),
            account_.energy_mj};
  }

 private:
  const SessionOptions& options_;
  SessionResult& result_;
  double period_ms_;
  double felt_ms_ = 0.0;  // the last fresh state
  Wish wish_;
  Held held_;
  PassivityAccount account_;
};

/// The device's loop, which leaves no force behind. How it ended is in `result`.
void run_device(const HapticDevice& device, const SessionOptions& options, Exchange& exchange,
                const std::atomic<bool>& interrupted, SessionResult& result) {
  Hand hand(options, result);
  StylusState stylus;
  Vec3 force_n = Vec3::Zero();
  Metronome metronome(options.rate_hz);
  for (;; ++result.periods) {
    const double late_us = metronome.wait();
    const double time_ms = metronome.time_ms();
    if (interrupted) {
      result.end = SessionEnd::Interrupt;
      break;
    }
    if (options.seconds > 0.0 && time_ms >= 1e3 * options.seconds) {
      result.end = SessionEnd::Time;
      break;
    }
    const Expected<StylusState> read = device.read(time_ms);
    if (!read) {
      result.end = SessionEnd::Lost;
      result.lost = read.errors().front().message;
      break;
    }
    stylus = *read;
    if (stylus.over) break;
    if (stylus.fresh) {
      force_n = hand.feel(stylus, time_ms, exchange);
      device.show(force_n);
    }
    if (result.late_us.size() < result.late_us.capacity()) result.late_us.push_back(late_us);
    if (options.record && result.rows.size() < result.rows.capacity()) {
      SessionRow& row = result.rows.emplace_back(hand.row(stylus, force_n));
      row.time_ms = time_ms, row.late_us = late_us;
    }
  }
  device.show(Vec3::Zero());
  if (hand.grabs()) hand.let_go(stylus);
  result.seconds = 1e-3 * metronome.time_ms();
  result.missed = metronome.missed();
}

}  // namespace

SessionResult run_session(LiveValve& live, const HapticDevice& device,
                          const SessionOptions& options, const std::atomic<bool>& interrupted) {
  SessionResult result;
  const double kept_s =
      options.seconds > 0.0 ? std::min(options.seconds, kLongestKept_s) : kLongestKept_s;
  const auto kept = static_cast<std::size_t>(kept_s * options.rate_hz) + 1;
  result.late_us.reserve(kept);
  result.look_us.reserve(kept);
  if (options.record) result.rows.reserve(kept);
  const int returns_before = live.returns();
  Exchange exchange;
  std::thread valve([&] { advance_valve(live, exchange, result); });
  std::thread loop([&] {
    result.real_time = ask_for_real_time();
    run_device(device, options, exchange, interrupted, result);
    exchange.over = true;
  });
  loop.join();
  valve.join();
  result.returns = live.returns() - returns_before;
  return result;
}

}  // namespace coapt
