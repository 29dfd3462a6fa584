#pragma once

#include <string_view>

namespace coapt {

/// Of the schema that this program works with; raised when what is stored or called changes.
int farm_schema_version();

/// SQL that makes it, or leaves it as it is: farm/database/schema, compiled in.
std::string_view farm_schema();

}  // namespace coapt
