// Populations as JSON: coapt.population/1.
#pragma once

#include <string_view>

#include "io/json/json.h"
#include "search/population/population.h"

namespace coapt {

/// {"schema", "version", "notice", "seed", "prior": coapt.population_prior/1, "anatomy_factors": [names], "lesion_factors":
/// [names], "members": [{"index", "aetiology", "anatomy": [...], "lesions": [...], "leak_healthy_mm2", "leak_mm2", "draws": {...}}, ...]}.
/// Numbers are kept to the bit.
Json to_json(const Population& population);
Json to_json(const PopulationMember& member);
Expected<PopulationMember> member_from_json(const Json& json);
Expected<Population> read_population(std::string_view text);
Expected<Population> population_from_json(const Json& json);

}  // namespace coapt
