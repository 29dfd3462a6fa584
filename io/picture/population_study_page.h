// What a study of a population found, as a page.
#pragma once

#include <string>
#include <vector>

#include "search/population/population_study.h"

namespace coapt {

/// What decided, in sentences: for the terminal and the head of the page.
std::vector<std::string> study_sentences(const PopulationStudy& study);

std::string population_study_page(const PopulationStudy& study, const std::string& lead);

}  // namespace coapt
