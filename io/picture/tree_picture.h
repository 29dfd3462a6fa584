// A decision tree over repairs as a figure: a line a branch, indented below its question, each leaf with its repair.
#pragma once

#include <string>

#include "search/population/population_tree.h"

namespace coapt {

std::string tree_svg(const PopulationTree& tree);

}  // namespace coapt
