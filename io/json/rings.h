#pragma once

#include <string_view>

#include "core/repair/plan.h"

namespace coapt {

/// The text of io/data/rings.json, compiled in.
std::string_view rings_text();

/// The catalogue of a file of schema coapt.rings/1.
Expected<std::vector<RingShape>> read_rings(std::string_view text);

}  // namespace coapt
