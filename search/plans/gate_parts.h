// What gates of operations and of closures share.
#pragma once

namespace coapt {

inline constexpr double kGateRounding = 1e-6;  ///< a figure this near to a limit is on it
inline constexpr const char* kPractice = "surgical practice";

}  // namespace coapt
