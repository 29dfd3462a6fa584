// Text of strangers, made safe to show.
#pragma once

#include <string>
#include <string_view>

namespace coapt {

/// One line of valid UTF-8: control characters (also those that override the direction of what follows) and broken sequences are
/// replaced. Nothing of it moves a terminal; Cairo draws nothing more after a broken sequence.
std::string printable(std::string_view text);

/// The same of each line; lines end where they did.
std::string printable_lines(std::string_view text);

}  // namespace coapt
