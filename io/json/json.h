// The one type of JSON. Two objects are equal if their members come in the same order, too, and a member is found by looking at
// those before it: an object of thousands is for writing, or is read by iterating.
#pragma once

#include <string>

#include "io/json/checked_json.h"
#include "io/json/json_fwd.h"

// What most sources would instantiate again is instantiated once, in json.cpp.
extern template class nlohmann::basic_json<nlohmann::ordered_map>;
extern template class nlohmann::detail::serializer<coapt::Json>;
extern template class std::vector<coapt::Json>;

namespace coapt {

/// As text that moves no terminal: what printable() takes out is escaped, and parsed it is the same again. Bytes that are not UTF-8 are
/// replaced. @param indent -1: in one line
std::string json_text(const Json& json, int indent = -1);

}  // namespace coapt
