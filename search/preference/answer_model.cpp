#include "search/preference/answer_model.h"

#include <cmath>

namespace coapt {

// Everything is divided by exp(|advantage| / 2), so that nothing overflows.
AnswerShares answer_shares(double advantage, double tie) {
  const double better = 1.0, worse = std::exp(-std::abs(advantage));
  const double unable = tie * std::exp(-0.5 * std::abs(advantage));
  const double sum = better + worse + unable;
  const bool first_better = advantage > 0.0;
  return {(first_better ? better : worse) / sum, (first_better ? worse : better) / sum,
          unable / sum};
}

AnswerShares with_slips(const AnswerShares& shares) {
  const auto mixed = [](double share) { return (1.0 - kSlips) * share + kSlips / 3.0; };
  return {mixed(shares.first), mixed(shares.second), mixed(shares.unable)};
}

LogShare log_share(Preference answer, double advantage, double tie) {
  const AnswerShares shares = answer_shares(advantage, tie);
  const double share = answer == Preference::First    ? shares.first
                       : answer == Preference::Second ? shares.second
                                                      : shares.unable;
  const double sign = answer == Preference::First ? 1.0 : answer == Preference::Second ? -1.0 : 0.0;
  const double lead = shares.first - shares.second;
  // Of the logarithm without slips.
  const double a = 0.5 * (sign - lead);
  const double t = (answer == Preference::Unable ? 1.0 : 0.0) - shares.unable;
  const double aa = -0.25 * (shares.first + shares.second - lead * lead);
  const double at = 0.5 * shares.unable * lead;
  const double tt = -shares.unable * (1.0 - shares.unable);
  // How likely such an answer is meant, and so counts.
  const double mixed = (1.0 - kSlips) * share + kSlips / 3.0;
  const double meant = (1.0 - kSlips) * share / mixed, slip = 1.0 - meant;
  return {std::log(mixed),
          meant * a,
          meant * t,
          meant * (aa + slip * a * a),
          meant * (at + slip * a * t),
          meant * (tt + slip * t * t)};
}

}  // namespace coapt
