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

LogShare log_share(Answer answer, double advantage, double tie) {
  const double size = std::abs(advantage);
  const double log_sum = 0.5 * size + std::log1p(std::exp(-size) + tie * std::exp(-0.5 * size));
  const AnswerShares shares = answer_shares(advantage, tie);
  const double sign = answer == Answer::First ? 1.0 : answer == Answer::Second ? -1.0 : 0.0;
  const double unable = answer == Answer::Unable ? 1.0 : 0.0;
  const double lead = shares.first - shares.second;
  return {0.5 * sign * advantage + unable * std::log(tie) - log_sum,
          0.5 * (sign - lead),
          unable - shares.unable,
          -0.25 * (shares.first + shares.second - lead * lead),
          0.5 * shares.unable * lead,
          -shares.unable * (1.0 - shares.unable)};
}

}  // namespace coapt
