#pragma once

#include <string>

#include "search/population/population.h"

namespace coapt {

/// What population make left in the directory `path`, or the file that it names.
Expected<Population> read_population_directory(const std::string& path);

}  // namespace coapt
