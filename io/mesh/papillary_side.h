#pragma once

#include <optional>
#include <string_view>

#include "core/valve/valve.h"

namespace coapt {

/// Which papillary muscle a field of a table or a label means: "AL", "PM-2", "antero-lateral tip", "ALPM" and "PMPM", "APM" and "PPM",
/// "PM anterolateral", "lateral", "medial", "anterior", "posterior"; in any case. None: neither, both, or a commissure.
std::optional<Side> papillary_side(std::string_view text);

}  // namespace coapt
