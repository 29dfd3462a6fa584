#include "lab/rivals/sobol.h"

#include <bit>
#include <cassert>
#include <utility>

namespace coapt::rivals {
namespace {

/// A row of Joe and Kuo's table.
struct Polynomial {
  int degree;                          ///< s
  std::uint32_t coefficients;          ///< a: the inner ones as bits, that of x^(s-1) highest
  std::array<std::uint32_t, 5> first;  ///< m_1 to m_s
};

/// Of dimensions 2 to 12; dimension 1 is van der Corput's sequence.
constexpr std::array<Polynomial, SobolSequence::kMostDimensions - 1> kPolynomials{{
    {1, 0, {1}},
    {2, 1, {1, 3}},
    {3, 1, {1, 3, 1}},
    {3, 2, {1, 1, 1}},
    {4, 1, {1, 1, 3, 3}},
    {4, 4, {1, 3, 5, 13}},
    {5, 2, {1, 1, 5, 5, 17}},
    {5, 4, {1, 1, 5, 5, 5}},
    {5, 7, {1, 1, 7, 11, 19}},
    {5, 11, {1, 1, 5, 1, 1}},
    {5, 13, {1, 1, 1, 3, 11}},
}};

}  // namespace

SobolSequence::SobolSequence(int dimensions, std::vector<std::uint32_t> shift)
    : directions_(static_cast<std::size_t>(dimensions)), point_(std::move(shift)) {
  assert(1 <= dimensions && dimensions <= kMostDimensions);
  assert(point_.empty() || point_.size() == directions_.size());
  point_.resize(directions_.size(), 0);
  for (std::size_t i = 0; i < kBits; ++i) directions_[0][i] = std::uint32_t{1} << (kBits - 1 - i);
  for (std::size_t d = 1; d < directions_.size(); ++d) {
    const Polynomial& polynomial = kPolynomials[d - 1];
    const auto degree = static_cast<std::size_t>(polynomial.degree);
    auto& v = directions_[d];
    for (std::size_t i = 0; i < degree; ++i) v[i] = polynomial.first[i] << (kBits - 1 - i);
    for (std::size_t i = degree; i < kBits; ++i) {  // Joe and Kuo (2008), equation 3
      v[i] = v[i - degree] ^ (v[i - degree] >> degree);
      for (std::size_t k = 1; k < degree; ++k)
        if ((polynomial.coefficients >> (degree - 1 - k)) & 1U) v[i] ^= v[i - k];
    }
  }
}

std::vector<double> SobolSequence::next() {
  std::vector<double> shares;
  for (const std::uint32_t bits : point_) shares.push_back(bits * 0x1p-32);
  const auto changed = static_cast<std::size_t>(std::countr_one(drawn_++));
  for (std::size_t d = 0; d < point_.size(); ++d) point_[d] ^= directions_[d][changed];
  return shares;
}

}  // namespace coapt::rivals
