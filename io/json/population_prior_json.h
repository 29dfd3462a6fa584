// Priors of populations as JSON: coapt.population_prior/1.
#pragma once

#include <string_view>

#include "io/json/json.h"
#include "search/population/population.h"

namespace coapt {

/// {"schema", "name", "anatomy": {NAME: {"mean", "sd", "min", "max", "source", "assumed"}, ...}, "correlations": [{"first",
/// "second", "r", "source", "assumed"}, ...], "aetiologies": [{"name", "share", "source", "assumed", "lesions": {...}}, ...]}.
/// Errors: those of check_prior(), too.
Expected<PopulationPrior> read_prior(std::string_view text);
Expected<PopulationPrior> prior_from_json(const Json& json);
Json to_json(const PopulationPrior& prior);

/// examples/populations/adult.json, as it was compiled in.
std::string_view adult_prior_text();
PopulationPrior adult_prior();

}  // namespace coapt
