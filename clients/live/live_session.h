// A hand on a valve: the device's loop, once a period, and the valve's own thread.
//
// One look of the valve (LiveValve::advance of 30 steps, then a search for crossings) takes 0.4 to 0.8 ms of a core, and more where
// leaflets would have crossed, so that it does not fit every period of 1 ms. The valve advances in a thread of its own, and the
// device's loop couples the hand to where the held spot was last: a spring between the two, bounded (hook.h), then the passivity
// controller (core/live/passivity.h), since the spot is late by up to a look.
#pragma once

#include <atomic>
#include <functional>
#include <string>
#include <vector>

#include "clients/live/haptic_device.h"
#include "clients/live/real_time.h"
#include "core/live/live_valve.h"

namespace coapt {

struct SessionOptions {
  double seconds = 0.0;  ///< 0: until the device is over
  double rate_hz = 1000.0;
  double scale = 1.0;  ///< mm of the valve for a mm of the stylus
  bool record = false;
};

enum class SessionEnd { Device, Time, Interrupt, Lost };

/// One period, as it was.
struct SessionRow {
  double time_ms = 0.0, late_us = 0.0;
  Vec3 stylus_mm = Vec3::Zero(), force_n = Vec3::Zero(), spot_mm = Vec3::Zero();
  bool holds = false;
  double energy_mj = 0.0;
};

struct SessionResult {
  SessionEnd end = SessionEnd::Device;
  std::string lost;  ///< why, if it was
  RealTime real_time;
  double seconds = 0.0;
  long periods = 0, missed = 0;
  std::vector<double> late_us;  ///< of each period
  long steps = 0;               ///< of the valve, and the time that they took
  double valve_seconds = 0.0;
  std::vector<double> look_us;
  int grasps = 0, returns = 0;
  double largest_force_n = 0.0;
  double energy_mj = 0.0;         ///< that the hand put in, over all grasps
  double lowest_energy_mj = 0.0;  ///< of a grasp, at any time
  std::vector<SessionRow> rows;
};

SessionResult run_session(LiveValve& live, const HapticDevice& device,
                          const SessionOptions& options, const std::atomic<bool>& interrupted);

}  // namespace coapt
