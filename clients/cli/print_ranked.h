#pragma once

#include <iosfwd>

#include "io/json/json_fwd.h"

namespace coapt {

/// Of coapt.plans/2: the state before, then one row per plan with its steps and warnings below, then how the search
/// went; "-" where the region is not known. At most 100 columns.
void print_ranked(std::ostream& out, const Json& result);

}  // namespace coapt
