#include "io/json/preference_json.h"

#include <algorithm>

#include "io/json/weights_json.h"
#include "search/preference/raters.h"

namespace coapt {

PreferencePosterior posterior_of(const std::vector<PlanCase>& cases,
                                 const std::vector<GivenAnswer>& answers) {
  return learn_preferences(comparisons(answers, cases));
}

Json learned_to_json(const std::vector<PlanCase>& cases, const std::vector<GivenAnswer>& answers,
                     const PreferencePosterior& posterior) {
  CostWeights others;
  others.sd_share = cases.front().sd_share;
  AnswerCounts counts;
  counts.answers = static_cast<int>(answers.size());
  counts.unable =
      static_cast<int>(std::count_if(answers.begin(), answers.end(), [](const auto& one) {
        return one.answer == Preference::Unable;
      }));
  counts.consistency = consistency(answers);
  return to_json(LearnedWeights{posterior, learned_weights(posterior, others)}, counts);
}

Json first_places_to_json(const std::vector<PlanCase>& cases, const PosteriorDraws& draws) {
  Json json = Json::array();
  for (const PlanCase& of : cases) {
    const std::vector<double> shares = best_shares(of, draws);
    const auto most = std::max_element(shares.begin(), shares.end());
    if (most == shares.end()) continue;
    json.push_back(
        {{"case", of.name}, {"rank", most - shares.begin() + 1}, {"probability", *most}});
  }
  return json;
}

}  // namespace coapt
