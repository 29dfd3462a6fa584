// The name that somebody may have meant.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace coapt {

/// `; did you mean "X"?` for the known name that is the fewest edits from `given` (letters inserted, left out, changed
/// or swapped with their neighbour; the first of equals): one for each three letters at most. Else empty.
std::string did_you_mean(std::string_view given, std::span<const std::string> known);

}  // namespace coapt
