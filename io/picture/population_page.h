// A population as tables and as a page: what was drawn beside where it comes from.
#pragma once

#include <string>

#include "search/population/population.h"

namespace coapt {

/// A row per member: index, aetiology, leaks, draws, then anatomy and lesions by name.
std::string members_csv(const Population& population);

/// Distributions of the members beside the prior's, with sources; correlations; rejected draws by reason.
std::string population_page(const Population& population);

/// How many numbers of a prior have a source, in words.
std::string assumed_words(const PopulationPrior& prior);

}  // namespace coapt
