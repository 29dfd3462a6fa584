// Which two plans to ask about next: those whose answer is expected to say most of the weights.
#pragma once

#include <optional>

#include "search/preference/posterior_draws.h"

namespace coapt {

/// One question in so many repeats an earlier one with its plans on the other sides: how consistent a rater is.
inline constexpr int kRepeatEvery = 10;

struct Question {
  PlanPair pair;
  bool repeats = false;
  double information_bits = 0.0;
};

/// A function of its arguments alone. A pair is asked once, but for repeats, and plans without a difference are not; of equal
/// information the first pair. Which plan comes first is drawn by the number of answers. None when all have been asked.
/// Takes a few microseconds for each pair of plans of one case.
std::optional<Question> next_question(const std::vector<PlanCase>& cases,
                                      const std::vector<GivenAnswer>& given,
                                      const PosteriorDraws& draws);

}  // namespace coapt
