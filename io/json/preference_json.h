// What a rater's answers so far say, as JSON.
#pragma once

#include <vector>

#include "io/json/json.h"
#include "search/preference/posterior_draws.h"

namespace coapt {

/// Of all answers.
PreferencePosterior posterior_of(const std::vector<PlanCase>& cases,
                                 const std::vector<GivenAnswer>& answers);

/// coapt.weights/1 (weights_json.h). @pre all cases have the sd_share of the first.
Json learned_to_json(const std::vector<PlanCase>& cases, const std::vector<GivenAnswer>& answers,
                     const PreferencePosterior& posterior);

/// [{"case", "rank", "probability"}]: of each case the plan that is most likely the best one; none of a case without plans.
Json first_places_to_json(const std::vector<PlanCase>& cases, const PosteriorDraws& draws);

}  // namespace coapt
