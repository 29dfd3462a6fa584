// A posterior as a fixed number of draws, the same for whatever is compared. They are taken in place of the normal
// distribution of an advantage, because that is no straight function of logarithms: weights that are all larger
// together leave every order as it is, which a tangent does not know.
#pragma once

#include "search/preference/posterior.h"

namespace coapt {

inline constexpr int kDraws = 256;  ///< in pairs on both sides of the mean

struct PosteriorDraws {
  /// Of the learned weights, over the noise: 1 / mm2, a column a draw.
  Eigen::Matrix<double, kTerms, kDraws> weights;
  Eigen::Array<double, kDraws, 1> tie;
};

/// A function of the posterior alone: the engine's seed is fixed.
PosteriorDraws draw(const PreferencePosterior& posterior);

/// Mutual information of the answer with the unknowns (Lindley 1956; Houlsby 2011, arXiv 1112.5745) and tie, in bits: from 0
/// to log2(3).
double information_bits(const CostTerms& difference, const PosteriorDraws& draws);

/// That an expert prefers the first of two plans, slips aside; "cannot tell" counts a half. Averaged over the posterior.
double preferred(const CostTerms& difference, const PosteriorDraws& draws);

/// For each plan of a case how likely it is the best, in the order of the plans: its share of the draws.
std::vector<double> best_shares(const PlanCase& plans, const PosteriorDraws& draws);

}  // namespace coapt
