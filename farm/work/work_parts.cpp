#include "farm/work/work_parts.h"

#include "io/json/valve_json.h"

namespace coapt {

Valve read_valve_part(const JsonPlace& place, const WorkRequest& request) {
  const int most = static_cast<int>(request.parts.size()) - 1;
  const int part = read_integer(place);
  if (part == kNoInteger) return {};
  if (part < 1 || part > most) {
    add_problem(
        place, ErrorCode::BadReference,
        "is " + std::to_string(part) + ", must be a part from 1 to " + std::to_string(most));
    return {};
  }
  Expected<Valve> valve = read_valve(request.parts[static_cast<std::size_t>(part)]);
  if (valve) return *std::move(valve);
  for (const Error& error : valve.errors())
    add_problem(place, error.code, "valve: " + error.path + ": " + error.message);
  return {};
}

void pack(std::string& bytes, std::uint64_t value) {
  for (int byte = 0; byte < 8; ++byte) bytes += static_cast<char>(value >> (8 * byte) & 0xff);
}

std::uint64_t unpacked(std::string_view bytes, std::size_t at) {
  std::uint64_t value = 0;
  for (std::size_t byte = 0; byte < 8; ++byte)
    value |= std::uint64_t{static_cast<unsigned char>(bytes[at + byte])} << (8 * byte);
  return value;
}

}  // namespace coapt
