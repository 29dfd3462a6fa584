#pragma once

#include <string_view>

namespace coapt {

/// The OpenAPI 3.1 document of the service: server/openapi.json with the schemas of io/schema in it, compiled in.
std::string_view openapi_text();

}  // namespace coapt
