// Any bytes: either problems, or a plan that reads back as it was written.

#include <cstdint>
#include <cstdlib>

#include "io/json/plan_json.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto plan = coapt::read_plan({reinterpret_cast<const char*>(data), size});
  if (!plan) {
    if (plan.errors().empty()) std::abort();
    return 0;
  }
  const std::string text = coapt::to_json(*plan).dump();
  const auto again = coapt::read_plan(text);
  if (!again || coapt::to_json(*again).dump() != text) std::abort();
  return 0;
}
