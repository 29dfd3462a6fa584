// What answers say of the weights of the cost. The utility of a plan is -price(terms, weights) in mm2 and its answers
// follow answer_model.h. Unknown are the logarithms of the weights, which keeps them positive, of the noise and of the tie.
//
// Each has a normal prior about today's value; the most probable values come by Newton's method, damped as by Levenberg
// (1944), and the posterior is taken to be normal about them, with the curvature there (Laplace; Bishop 2006, 4.4).
//
// The price of untrusted closures is no wish and is not learned; sd_share is within the amounts and stays. Weights and noise
// times one factor give the same answers: how large all weights are together is the prior's alone to say.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "search/preference/answer_model.h"

namespace coapt {

inline constexpr int kLearnedTerms = kTerms - 1;  ///< all but the last, CostTerm::Untrusted
static_assert(static_cast<int>(CostTerm::Untrusted) == kLearnedTerms);
inline constexpr int kNoise = kLearnedTerms, kTie = kLearnedTerms + 1;  ///< indices of the others
inline constexpr int kUnknowns = kLearnedTerms + 2;

using Unknowns = Eigen::Matrix<double, kUnknowns, 1>;
using UnknownsMatrix = Eigen::Matrix<double, kUnknowns, kUnknowns>;

/// Of an unknown: the term's, "noise_mm2" or "tie".
std::string unknown_name(int unknown);

/// Medians and standard deviations of natural logarithms.
struct PreferencePrior {
  CostWeights weights;  ///< each learned one above 0
  /// Two thirds of experts within a factor of 2 of today's price, nine of ten within 3.1: enough to turn the order of
  /// most plans, and a mm2 of leak above 1 still costs more than a step. Assumed: no expert has been measured.
  double log_weight_sd = 0.6931471805599453;
  /// An expert with this noise prefers a plan that is better by 1 mm2, the price of a step, in four of five answers.
  double noise_mm2 = 0.7;
  double log_noise_sd = 0.6931471805599453;
  double tie = 0.5;  ///< a fifth of the answers on equal plans
  double log_tie_sd = 0.6931471805599453;
};

Unknowns prior_mean(const PreferencePrior& prior);
Unknowns prior_sd(const PreferencePrior& prior);

/// What was answered, as the model sees it.
struct Comparison {
  CostTerms difference;  ///< first less second
  Preference answer = Preference::Unable;
};
std::vector<Comparison> comparisons(const std::vector<GivenAnswer>& given,
                                    const std::vector<PlanCase>& cases);

/// Advantage of the first plan in units of the noise.
double advantage(const CostTerms& difference, const Unknowns& unknowns);

/// Logarithm of the posterior density but for a constant, and its derivatives.
struct LogPosterior {
  double value = 0.0;
  Unknowns gradient = Unknowns::Zero();
  UnknownsMatrix hessian = UnknownsMatrix::Zero();
};
LogPosterior log_posterior(const std::vector<Comparison>& answers, const PreferencePrior& prior,
                           const Unknowns& at);

/// Normal, of the logarithms.
struct PreferencePosterior {
  Unknowns mean = Unknowns::Zero();  ///< the most probable values
  UnknownsMatrix covariance = UnknownsMatrix::Identity();
};

PreferencePosterior learn_preferences(const std::vector<Comparison>& answers,
                                      const PreferencePrior& prior = {});

/// `others` with the learned weights in place.
CostWeights learned_weights(const PreferencePosterior& posterior, CostWeights others = {});

Unknowns log_sd(const PreferencePosterior& posterior);

/// Below this share of the prior's standard deviation answers have said something of a weight.
inline constexpr double kInformedShare = 0.8;
/// By term, kLearnedTerms of them.
std::vector<bool> informed(const PreferencePosterior& posterior, const PreferencePrior& prior = {});

}  // namespace coapt
