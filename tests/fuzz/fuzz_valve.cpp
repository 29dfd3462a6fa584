// Any bytes: either problems, or a valve that validates and reads back as it was written.

#include <cstdint>
#include <cstdlib>

#include "core/valve/validate.h"
#include "io/json/valve_json.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto valve = coapt::read_valve({reinterpret_cast<const char*>(data), size});
  if (!valve) {
    if (valve.errors().empty()) std::abort();
    return 0;
  }
  if (!coapt::validate(*valve).empty()) std::abort();
  const std::string text = coapt::write_valve(*valve);
  const auto again = coapt::read_valve(text);
  if (!again || coapt::write_valve(*again) != text) std::abort();
  return 0;
}
