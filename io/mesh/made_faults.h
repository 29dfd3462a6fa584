// What is wrong with a valve that an import made, in the words of who gave the files.
#pragma once

#include "io/mesh/import_valve.h"

namespace coapt {

/// Errors of validate(), whose pointers are into a valve that nobody has seen: of a face or vertex at "/leaflets/I", with what the
/// leaflet is `called`, the segment and the place in the files' own coordinates. Those that say the same are one, with their count.
Errors made_faults(const Errors& errors, const Valve& valve,
                   const std::array<std::string, 2>& called, LengthUnit unit);

}  // namespace coapt
