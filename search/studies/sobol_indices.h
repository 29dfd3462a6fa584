// Which factor decides: Sobol indices (2001) of a quantity over a box of factors, from a polynomial
// of at most second degree in Legendre polynomials, fitted by least squares (Sudret 2008). It needs
// a few samples per term, where the direct estimators need thousands. Of three sets of terms
// (linear; with squares; with products of two factors, too) the one counts that best predicts
// samples left out.
#pragma once

#include <vector>

namespace coapt {

struct SobolIndices {
  std::vector<double> first;   ///< share of the variance by each factor alone
  std::vector<double> total;   ///< with all its interactions
  std::vector<double> effect;  ///< change of the quantity from the factor's low end to its high end
  /// Of the variance, leaving each sample out in turn (Q2); below 0.5 the indices say little.
  double predicted_share = 0.0;
};

/// @param shares one sample each: its factors in [0, 1]; @param values as many, finite. NaN where
/// values are constant or samples are not more than the terms of the smallest set.
SobolIndices sobol_indices(const std::vector<std::vector<double>>& shares,
                           const std::vector<double>& values);

}  // namespace coapt
