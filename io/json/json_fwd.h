// The one type of JSON, for headers that only name it.
#pragma once

#include <nlohmann/json_fwd.hpp>

namespace coapt {

using Json = nlohmann::ordered_json;  ///< members stay in the order in which they were added

}  // namespace coapt
