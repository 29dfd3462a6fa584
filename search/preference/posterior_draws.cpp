#include "search/preference/posterior_draws.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>

#include "search/random_share.h"

namespace coapt {
namespace {

constexpr std::uint64_t kSeed = 1;

double bits(double share) { return share > 0.0 ? -share * std::log2(share) : 0.0; }

double entropy_bits(const AnswerShares& shares) {
  return bits(shares.first) + bits(shares.second) + bits(shares.unable);
}

/// Calls `use` with the shares of the answers of each draw.
template <class Use>
void for_each_draw(const CostTerms& difference, const PosteriorDraws& draws, Use use) {
  const Eigen::Array<double, kDraws, 1> advantages =
      -(draws.weights.transpose() * difference.amounts.matrix()).array();
  for (int i = 0; i < kDraws; ++i) use(answer_shares(advantages[i], draws.tie[i]));
}

}  // namespace

PosteriorDraws draw(const PreferencePosterior& posterior) {
  const UnknownsMatrix root = Eigen::LLT<UnknownsMatrix>(posterior.covariance).matrixL();
  std::mt19937_64 engine(kSeed);
  PosteriorDraws draws;
  for (int i = 0; i < kDraws; i += 2) {
    Unknowns normal;
    for (double& value : normal) value = normal_share(engine);
    const Unknowns away = root * normal;
    for (int side = 0; side < 2; ++side) {
      const Unknowns at = posterior.mean + (side == 0 ? away : -away);
      const double per_noise = std::exp(-at[kNoise]);
      draws.weights.col(i + side).head<kLearnedTerms>() =
          per_noise * at.head<kLearnedTerms>().array().exp();
      draws.weights(kLearnedTerms, i + side) = per_noise * CostWeights{}.untrusted;
      draws.tie[i + side] = std::exp(at[kTie]);
    }
  }
  return draws;
}

double information_bits(const CostTerms& difference, const PosteriorDraws& draws) {
  AnswerShares mean;
  double entropy = 0.0;
  for_each_draw(difference, draws, [&](const AnswerShares& meant) {
    const AnswerShares shares = with_slips(meant);
    mean.first += shares.first / kDraws;
    mean.second += shares.second / kDraws;
    mean.unable += shares.unable / kDraws;
    entropy += entropy_bits(shares) / kDraws;
  });
  return std::max(0.0, entropy_bits(mean) - entropy);
}

double preferred(const CostTerms& difference, const PosteriorDraws& draws) {
  double sum = 0.0;
  for_each_draw(difference, draws,
                [&](const AnswerShares& shares) { sum += shares.first + 0.5 * shares.unable; });
  return sum / kDraws;
}

std::vector<double> best_shares(const PlanCase& plans, const PosteriorDraws& draws) {
  std::vector<double> shares(plans.plans.size(), 0.0);
  if (shares.empty()) return shares;
  for (int i = 0; i < kDraws; ++i) {
    std::size_t best = 0;
    double least = 0.0;
    for (std::size_t plan = 0; plan < shares.size(); ++plan) {
      const double price = draws.weights.col(i).dot(plans.plans[plan].terms.amounts.matrix());
      if (plan > 0 && price >= least) continue;
      best = plan;
      least = price;
    }
    shares[best] += 1.0 / kDraws;
  }
  return shares;
}

}  // namespace coapt
