// Haply Inverse3 over its service's WebSocket; Boost.Beast stands behind this header alone.
#pragma once

#include <string>

#include "clients/live/haptic_device.h"

namespace coapt {

inline constexpr const char* kHaplyService = "ws://localhost:10001";

/// Waits up to 5 s for the service and the first state of a device. Where the cursor is then stands for `start_mm` in the valve's
/// frame; axes are as the device has them: x to the right, z up, which is to the atrium. Errors: OutOfRange for an address that
/// is none, InputOutput where nobody answers.
Expected<HapticDevice> connect_haply(const std::string& address, const Vec3& start_mm);

}  // namespace coapt
