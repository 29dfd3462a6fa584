#pragma once

#include <iosfwd>
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace coapt {

/// Of coapt.opening/1.
void print_opening(std::ostream& out, const nlohmann::ordered_json& opening);
/// "4.5 cm2, mean gradient 1.0 mmHg at 155 ml/s", or what speaks against that.
std::string opening_in_short(const nlohmann::ordered_json& opening);

}  // namespace coapt
