// Which factor decides: Sobol indices (2001) of a quantity over a box of factors, from a polynomial of
// second degree in products of Legendre polynomials, fitted by least squares (Sudret 2008). It needs
// a few samples per term, (n + 1)(n + 2) / 2 of them, where the direct estimators need thousands.
#pragma once

#include <cstdint>
#include <vector>

namespace coapt {

struct SobolIndices {
  std::vector<double> first;  ///< share of the variance by each factor alone
  std::vector<double> total;  ///< with all its interactions
  double predicted_share =
      0.0;  ///< of the variance, leaving each sample out in turn (Q2); below 0.5 say nothing
};

/// @param shares one sample each: its factors in [0, 1]; @param values as many, finite. NaN where values
/// are constant or samples are fewer than terms.
SobolIndices sobol_indices(const std::vector<std::vector<double>>& shares,
                           const std::vector<double>& values);

/// A Latin hypercube (McKay 1979): `count` samples of `factors` shares in [0, 1].
std::vector<std::vector<double>> latin_hypercube(int count, int factors, std::uint64_t seed);

}  // namespace coapt
