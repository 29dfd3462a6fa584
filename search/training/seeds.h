// Which seeds cases and learners may have.
#pragma once

#include <cstdint>

namespace coapt {

/// Every whole number up to here is exact in JSON and in a page's numbers (IEEE double).
inline constexpr std::uint64_t kLargestSeed = (std::uint64_t{1} << 53) - 1;

/// Seeds counted from here on stay below kLargestSeed, however many cases a study has.
inline constexpr std::uint64_t kLargestFirstCase = std::uint64_t{1} << 52;

}  // namespace coapt
