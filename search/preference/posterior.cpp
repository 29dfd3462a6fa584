#include "search/preference/posterior.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace coapt {
namespace {

constexpr int kMostRounds = 200;
constexpr double kLeastStep = 1e-10;  // of a logarithm
constexpr double kMostDamping = 1e12;

/// Advantage by term; what is not learned last.
Eigen::Array<double, kTerms, 1> advantages(const CostTerms& difference, const Unknowns& at) {
  Eigen::Array<double, kTerms, 1> weights;
  weights.head<kLearnedTerms>() = at.head<kLearnedTerms>().array().exp();
  weights[kLearnedTerms] = CostWeights{}.untrusted;
  return -weights * difference.amounts * std::exp(-at[kNoise]);
}

void add_comparison(const Comparison& of, const Unknowns& at, LogPosterior& sum) {
  const Eigen::Array<double, kTerms, 1> by_term = advantages(of.difference, at);
  const double whole = by_term.sum();
  const LogShare share = log_share(of.answer, whole, std::exp(at[kTie]));

  Unknowns slope = Unknowns::Zero();  // of the advantage
  slope.head<kLearnedTerms>() = by_term.head<kLearnedTerms>();
  slope[kNoise] = -whole;
  UnknownsMatrix curvature = UnknownsMatrix::Zero();
  curvature.diagonal() = slope;
  curvature(kNoise, kNoise) = whole;
  curvature.col(kNoise).head<kLearnedTerms>() = -slope.head<kLearnedTerms>();
  curvature.row(kNoise).head<kLearnedTerms>() = -slope.head<kLearnedTerms>();

  sum.value += share.value;
  sum.gradient += share.by_a * slope;
  sum.gradient[kTie] += share.by_t;
  sum.hessian += share.by_aa * slope * slope.transpose() + share.by_a * curvature;
  sum.hessian.col(kTie) += share.by_at * slope;
  sum.hessian.row(kTie) += share.by_at * slope.transpose();
  sum.hessian(kTie, kTie) += share.by_tt;
}

}  // namespace

std::string unknown_name(int unknown) {
  if (unknown == kNoise) return "noise_mm2";
  if (unknown == kTie) return "tie";
  return cost_term_rows()[static_cast<std::size_t>(unknown)].name;
}

Unknowns prior_mean(const PreferencePrior& prior) {
  Unknowns mean;
  for (int term = 0; term < kLearnedTerms; ++term)
    mean[term] = std::log(prior.weights.*cost_term_rows()[static_cast<std::size_t>(term)].weight);
  mean[kNoise] = std::log(prior.noise_mm2);
  mean[kTie] = std::log(prior.tie);
  return mean;
}

Unknowns prior_sd(const PreferencePrior& prior) {
  Unknowns sd = Unknowns::Constant(prior.log_weight_sd);
  sd[kNoise] = prior.log_noise_sd;
  sd[kTie] = prior.log_tie_sd;
  return sd;
}

std::vector<Comparison> comparisons(const std::vector<GivenAnswer>& given,
                                    const std::vector<PlanCase>& cases) {
  std::vector<Comparison> all;
  for (const GivenAnswer& of : given) all.push_back({difference(of.pair, cases), of.answer});
  return all;
}

double advantage(const CostTerms& difference, const Unknowns& unknowns) {
  return advantages(difference, unknowns).sum();
}

LogPosterior log_posterior(const std::vector<Comparison>& answers, const PreferencePrior& prior,
                           const Unknowns& at) {
  const Unknowns precision = prior_sd(prior).array().square().inverse();
  const Unknowns from_prior = at - prior_mean(prior);
  LogPosterior sum;
  sum.value = -0.5 * from_prior.dot(precision.cwiseProduct(from_prior));
  sum.gradient = -precision.cwiseProduct(from_prior);
  sum.hessian.diagonal() = -precision;
  for (const Comparison& answer : answers) add_comparison(answer, at, sum);
  return sum;
}

PreferencePosterior learn_preferences(const std::vector<Comparison>& answers,
                                      const PreferencePrior& prior) {
  Unknowns at = prior_mean(prior);
  LogPosterior here = log_posterior(answers, prior, at);
  double damping = 0.0, step_size = 1.0;
  for (int round = 0; round < kMostRounds && step_size > kLeastStep && damping < kMostDamping;
       ++round) {
    const Eigen::LLT<UnknownsMatrix> downhill(damping * UnknownsMatrix::Identity() - here.hessian);
    if (downhill.info() == Eigen::Success) {
      const Unknowns step = downhill.solve(here.gradient);
      const LogPosterior there = log_posterior(answers, prior, at + step);
      if (there.value >= here.value) {
        at += step;
        here = there;
        step_size = step.cwiseAbs().maxCoeff();
        damping = damping > 1e-3 ? 0.1 * damping : 0.0;
        continue;
      }
    }
    damping = std::max(10.0 * damping, 1e-2);
  }
  // Slips make it no concave function: where it has no curvature downwards, the prior's stands, which is wider.
  const Eigen::LLT<UnknownsMatrix> curvature(-here.hessian);
  if (curvature.info() != Eigen::Success)
    return {at, prior_sd(prior).array().square().matrix().asDiagonal()};
  return {at, curvature.solve(UnknownsMatrix::Identity())};
}

CostWeights learned_weights(const PreferencePosterior& posterior, CostWeights others) {
  for (int term = 0; term < kLearnedTerms; ++term)
    others.*cost_term_rows()[static_cast<std::size_t>(term)].weight =
        std::exp(posterior.mean[term]);
  return others;
}

Unknowns log_sd(const PreferencePosterior& posterior) {
  return posterior.covariance.diagonal().cwiseSqrt();
}

std::vector<bool> informed(const PreferencePosterior& posterior, const PreferencePrior& prior) {
  const Unknowns share = log_sd(posterior).cwiseQuotient(prior_sd(prior));
  std::vector<bool> all;
  for (int term = 0; term < kLearnedTerms; ++term) all.push_back(share[term] < kInformedShare);
  return all;
}

}  // namespace coapt
