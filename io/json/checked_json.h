// nlohmann's JSON. A member that a const object lacks throws std::out_of_range, where the library leaves undefined what happens.
#pragma once

#include <stdexcept>

#if defined(__cpp_exceptions)
#define JSON_ASSERT(holds) ((holds) ? void() : throw std::out_of_range("JSON without " #holds))
#endif
#include <nlohmann/json.hpp>
