#pragma once

namespace coapt {

inline constexpr double kMmhgPerKpa = 1.0 / 0.133322;

}  // namespace coapt
