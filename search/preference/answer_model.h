// How likely each answer is, given by how much one plan is better: Bradley and Terry (1952, Biometrika 39:324) with ties
// as by Davidson (1970, JASA 65:317). With the advantage a of the first plan, its utility less that of the second in units
// of the noise, first : second : unable = exp(a/2) : exp(-a/2) : tie. Between first and second alone that is
// logistic(a). The logarithms of all three are concave in (a, log tie), which the rule of Rao and Kupper (1967) offers
// as well; Davidson's has the shorter derivatives.
#pragma once

#include "search/preference/comparison.h"

namespace coapt {

/// They add up to 1.
struct AnswerShares {
  double first = 0.0, second = 0.0, unable = 0.0;
};

/// @param tie above 0; tie / (2 + tie) of the answers on equal plans are "cannot tell".
AnswerShares answer_shares(double advantage, double tie);

/// Natural logarithm of an answer's share, and its derivatives by advantage (a) and log tie (t).
struct LogShare {
  double value = 0.0;
  double by_a = 0.0, by_t = 0.0;
  double by_aa = 0.0, by_at = 0.0, by_tt = 0.0;
};
LogShare log_share(Answer answer, double advantage, double tie);

}  // namespace coapt
