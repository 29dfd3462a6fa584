// What an opening answers, as JSON.
#pragma once

#include "core/opened/opened_valve.h"
#include "io/json/json.h"

namespace coapt {

/// coapt.opening/2. Keys that scripts rely on: status, crossing, opening_area_mm2, projected_area_mm2, gradient_mmhg; null where the
/// valve did not come to rest.
Json opening_to_json(const OpenedValve& opened, double seconds);

/// The same without schema, version, notice and name: below "opening" of a closure.
Json opening_figures_json(const OpenedValve& opened, double seconds);

}  // namespace coapt
