// What Haply's Inverse Service (3.1 and later) says and is told: JSON over a WebSocket, ws://localhost:10001 by default.
//
// It sends its state as soon as somebody connects, and again after each command:
//   {"inverse3": [{"device_id": "...", "state": {"cursor_position": {"x", "y", "z"}, ...}}],
//    "wireless_verse_grip": [{"device_id": "...", "state": {"buttons": {"a", "b", "c"}, ...}}]}
// with places in metres; a grip on a cable comes as "verse_grip" with one "button". A command is
//   {"inverse3": [{"device_id": "...", "commands": {"set_cursor_force": {"values": {"x", "y", "z"}}}}]}
// with the force in newtons; without commands no states come.
// Sources: Isaac Lab (isaac-sim/IsaacLab, isaaclab/devices/haply/se3_haply.py, BSD-3-Clause), Haply's own samples of that
// loop, crate haply (docs.rs/haply).
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/valve/types.h"

namespace coapt {

struct HaplyState {
  std::string device_id;
  Vec3 position_mm = Vec3::Zero();
  bool button = false;  ///< any of the grip's
};

/// Of the first Inverse3; none if the message has none, or is not such a message, or the place is beyond kFarthest_mm.
std::optional<HaplyState> read_haply_state(std::string_view message);

std::string haply_force_message(const std::string& device_id, const Vec3& force_n);

}  // namespace coapt
