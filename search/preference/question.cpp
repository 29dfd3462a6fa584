#include "search/preference/question.h"

#include <map>
#include <random>
#include <utility>

#include "search/random_share.h"

namespace coapt {
namespace {

/// How often each pair has been asked, by its order.
std::map<PlanPair, int> times_asked(const std::vector<GivenAnswer>& given) {
  std::map<PlanPair, int> times;
  for (const GivenAnswer& answer : given) ++times[in_order(answer).pair];
  return times;
}

/// The oldest pair that was asked once, sides swapped.
std::optional<PlanPair> to_repeat(const std::vector<GivenAnswer>& given,
                                  const std::map<PlanPair, int>& times) {
  for (const GivenAnswer& answer : given)
    if (times.at(in_order(answer).pair) == 1)
      return PlanPair{answer.pair.of_case, answer.pair.second, answer.pair.first};
  return {};
}

}  // namespace

std::optional<Question> next_question(const std::vector<PlanCase>& cases,
                                      const std::vector<GivenAnswer>& given,
                                      const PosteriorDraws& draws) {
  const std::map<PlanPair, int> times = times_asked(given);
  if ((given.size() + 1) % kRepeatEvery == 0)
    if (const std::optional<PlanPair> pair = to_repeat(given, times))
      return Question{*pair, true, information_bits(difference(*pair, cases), draws)};

  std::optional<Question> best;
  for (int of_case = 0; of_case < std::ssize(cases); ++of_case) {
    const auto plans = static_cast<int>(cases[static_cast<std::size_t>(of_case)].plans.size());
    for (int first = 0; first < plans; ++first)
      for (int second = first + 1; second < plans; ++second) {
        const PlanPair pair{of_case, first, second};
        const CostTerms apart = difference(pair, cases);
        if (times.contains(pair) || (apart.amounts == 0.0).all()) continue;
        const double bits = information_bits(apart, draws);
        if (!best || bits > best->information_bits) best = Question{pair, false, bits};
      }
  }
  if (!best) return best;
  std::mt19937_64 engine(given.size());
  if (random_share(engine) < 0.5) std::swap(best->pair.first, best->pair.second);
  return best;
}

}  // namespace coapt
