// A stylus that follows a file, in place of a hand.
#pragma once

#include <string_view>
#include <vector>

#include "clients/live/haptic_device.h"

namespace coapt {

struct StylusSample {
  double time_ms = 0.0;
  Vec3 position_mm = Vec3::Zero();
  bool grabs = false;
};

/// CSV with columns t_ms, x, y, z (mm, the valve's frame) and button (0 or 1), in the order of time.
Expected<std::vector<StylusSample>> read_stylus_script(std::string_view csv);

/// Straight from sample to sample; the button is that of the sample before. Over after the last one. @pre there is a sample.
StylusState stylus_at(const std::vector<StylusSample>& script, double time_ms);

HapticDevice scripted_stylus(std::vector<StylusSample> script);

}  // namespace coapt
