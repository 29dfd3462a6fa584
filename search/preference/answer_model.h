// How likely each answer is, given by how much one plan is better: Bradley and Terry (1952, Biometrika 39:324) with ties
// as by Davidson (1970, JASA 65:317). With the advantage a of the first plan, its utility less that of the second in units
// of the noise, first : second : unable = exp(a/2) : exp(-a/2) : tie. Between first and second alone that is
// logistic(a). The rule of Rao and Kupper (1967) would do as well; Davidson's has the shorter derivatives.
//
// Some answers are slips (a key next to the right one, a case misread) and say nothing: without them one slip about
// plans that are far apart outweighs all other answers (Wichmann and Hill 2001, Percept Psychophys 63:1293).
#pragma once

#include "search/preference/comparison.h"

namespace coapt {

/// They add up to 1.
struct AnswerShares {
  double first = 0.0, second = 0.0, unable = 0.0;
};

/// @param tie above 0; tie / (2 + tie) of the answers on equal plans are "cannot tell".
AnswerShares answer_shares(double advantage, double tie);

/// Of slips, in which each answer is as likely: assumed, those of trained observers lie between 0 and 0.06.
inline constexpr double kSlips = 0.05;
AnswerShares with_slips(const AnswerShares& shares);

/// Natural logarithm of an answer's share with slips, and its derivatives by advantage (a) and log tie (t).
struct LogShare {
  double value = 0.0;
  double by_a = 0.0, by_t = 0.0;
  double by_aa = 0.0, by_at = 0.0, by_tt = 0.0;
};
LogShare log_share(Preference answer, double advantage, double tie);

}  // namespace coapt
