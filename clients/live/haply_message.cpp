#include "clients/live/haply_message.h"

#include "clients/live/haptic_device.h"
#include "io/json/json.h"

namespace coapt {
namespace {

constexpr double kMmPerM = 1000.0;

/// The state of the first device of a list; null where there is none.
Json first_state(const Json& message, const char* list) {
  const auto devices = message.find(list);
  if (devices == message.end() || !devices->is_array() || devices->empty()) return {};
  const Json& device = devices->front();
  return device.is_object() ? device.value("state", Json()) : Json();
}

std::optional<Vec3> point_of(const Json& state) {
  if (!state.is_object() || !state.contains("cursor_position")) return std::nullopt;
  const Json& at = state["cursor_position"];
  Vec3 point;
  for (int k = 0; k < 3; ++k) {
    const auto number = at.find(std::string(1, "xyz"[k]));
    if (number == at.end() || !number->is_number()) return std::nullopt;
    point[k] = kMmPerM * number->get<double>();
  }
  return (point.array().abs() <= kFarthest_mm).all() ? std::optional<Vec3>(point) : std::nullopt;
}

bool is_pressed(const Json& grip) {
  if (!grip.is_object()) return false;
  if (grip.contains("button")) return grip["button"] == true;
  if (!grip.contains("buttons")) return false;
  for (const Json& button : grip["buttons"])
    if (button == true) return true;
  return false;
}

}  // namespace

std::optional<HaplyState> read_haply_state(std::string_view message) {
  const Json state = Json::parse(message, nullptr, false);
  if (!state.is_object()) return std::nullopt;
  const std::optional<Vec3> point = point_of(first_state(state, "inverse3"));
  if (!point) return std::nullopt;
  const Json& id = state["inverse3"].front().value("device_id", Json());
  if (!id.is_string()) return std::nullopt;
  return HaplyState{id.get<std::string>(), *point,
                    is_pressed(first_state(state, "wireless_verse_grip")) ||
                        is_pressed(first_state(state, "verse_grip"))};
}

std::string haply_force_message(const std::string& device_id, const Vec3& force_n) {
  const Json values = {{"x", force_n.x()}, {"y", force_n.y()}, {"z", force_n.z()}};
  const Json command = {{"commands", {{"set_cursor_force", {{"values", values}}}}},
                        {"device_id", device_id}};
  return Json{{"inverse3", Json::array({command})}}.dump();
}

}  // namespace coapt
