// Text of strangers, made safe to show.
#pragma once

#include <string>
#include <string_view>

namespace coapt {

/// One line of valid UTF-8: control characters (also those that override the direction of what follows) and broken sequences are
/// replaced. Nothing of it moves a terminal; Cairo draws nothing more after a broken sequence.
std::string printable(std::string_view text);

}  // namespace coapt
