// Populations and their priors as JSON: coapt.population/1, coapt.population_prior/1.
#pragma once

#include <nlohmann/json.hpp>
#include <string_view>

#include "search/population/population.h"

namespace coapt {

/// {"schema", "name", "anatomy": {NAME: {"mean", "sd", "min", "max", "source", "assumed"}, ...}, "correlations": [{"first",
/// "second", "r", "source", "assumed"}, ...], "aetiologies": [{"name", "share", "source", "assumed", "lesions": {...}}, ...]}.
/// Errors: those of check_prior(), too.
Expected<PopulationPrior> read_prior(std::string_view text);
Expected<PopulationPrior> prior_from_json(const nlohmann::json& json);
nlohmann::ordered_json to_json(const PopulationPrior& prior);

/// examples/populations/adult.json, as it was compiled in.
std::string_view adult_prior_text();
PopulationPrior adult_prior();

/// {"schema", "version", "notice", "seed", "prior": coapt.population_prior/1, "anatomy_factors": [names], "lesion_factors":
/// [names], "members": [{"index", "aetiology", "anatomy": [...], "lesions": [...], "leak_healthy_mm2", "leak_mm2", "draws": {...}}, ...]}.
/// Numbers are kept to the bit.
nlohmann::ordered_json to_json(const Population& population);
nlohmann::ordered_json to_json(const PopulationMember& member);
Expected<PopulationMember> member_from_json(const nlohmann::json& json);
Expected<Population> read_population(std::string_view text);
Expected<Population> population_from_json(const nlohmann::json& json);

}  // namespace coapt
