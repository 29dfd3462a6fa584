#pragma once

#include <string>

#include "search/population/population.h"

namespace coapt {

/// What population make left in a directory.
Expected<Population> read_population_directory(const std::string& directory);

}  // namespace coapt
