// Numbers, points and faces as text: what the writers of text formats share. The locale changes nothing.
#pragma once

#include <optional>
#include <string>

#include "core/valve/types.h"

namespace coapt {

/// Digits of formats that end points are compared in: as %.9g.
inline constexpr int kExchangeDigits = 9;

/// @param digits as of %.*g; none: as few as read back to the same bits
void append_number(std::string& text, double number, std::optional<int> digits);

/// A line "BEFOREx y z" for each.
void append_points(std::string& text, const Points& points, const char* before,
                   std::optional<int> digits);

/// A line "BEFOREa b c" for each. @param first the number of the first vertex
void append_faces(std::string& text, const Faces& faces, const char* before, int first);

}  // namespace coapt
