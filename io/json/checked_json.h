// nlohmann's JSON. A member that a const object lacks throws std::out_of_range, where the library leaves undefined what happens.
#pragma once

#include <stdexcept>
#include <string>

#if defined(__cpp_exceptions)
namespace coapt {
[[noreturn]] inline void json_without(const char* what) {
  throw std::out_of_range(std::string("JSON without ") + what);
}
}  // namespace coapt
#define JSON_ASSERT(holds) ((holds) ? void() : ::coapt::json_without(#holds))
#endif
#include <nlohmann/json.hpp>
