// Sobol's low-discrepancy sequence (Sobol 1967) with the direction numbers of Joe and Kuo (2008,
// "Constructing Sobol sequences with better two-dimensional projections", SIAM J. Sci. Comput. 30,
// 2635-2654; their file new-joe-kuo-6.21201), in the Gray code order of Antonov and Saleev (1979).
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace coapt::rivals {

class SobolSequence {
 public:
  static constexpr int kMostDimensions = 12;

  /// @pre 1 <= dimensions <= kMostDimensions. @param shift a digital shift: XORed to the binary
  /// digits of every point, one for each dimension. It keeps the sequence's evenness, and every
  /// point is uniformly distributed if it is. Zeroes if empty.
  explicit SobolSequence(int dimensions, std::vector<std::uint32_t> shift = {});

  /// In [0, 1), each a multiple of 2^-32. The first point is the shift. @pre fewer than 2^32 before.
  std::vector<double> next();

 private:
  static constexpr int kBits = 32;
  std::vector<std::array<std::uint32_t, kBits>> directions_;
  std::vector<std::uint32_t> point_;
  std::uint32_t drawn_ = 0;
};

}  // namespace coapt::rivals
