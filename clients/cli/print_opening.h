#pragma once

#include <iosfwd>
#include <string>

#include "io/json/json_fwd.h"

namespace coapt {

/// Of coapt.opening/2.
void print_opening(std::ostream& out, const Json& opening);
/// "4.5 cm2, mean gradient 1.0 mmHg at 155 ml/s", or what speaks against that.
std::string opening_in_short(const Json& opening);

}  // namespace coapt
