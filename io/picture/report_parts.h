// Sections of the plan report, each as HTML and in a file of its own.
#pragma once

#include <string>

#include "io/picture/report.h"

namespace coapt {

/// What a surgeon reads in two minutes, on one sheet. @pre there are plans.
std::string first_page(const PlanReport& report);

/// Table of all ranked plans with their warnings, and what a better closure costs.
std::string ranked_section(const PlanReport& report);

/// For each plan told its figure, its gates and the closed valve; the one in front unfolded.
std::string evidence_section(const PlanReport& report);

/// Which measurement would say most of the leak that the first plan leaves; empty where it is not known.
std::string information_section(const SearchResult& result);

/// Best cost against closures, which few closures spoke for many, what was left out.
std::string search_section(const SearchResult& result);

/// What the simulation leaves out and how far its figures go; folded on screen.
std::string limits_section();

/// Version, seed, command, options, the plan as a file; folded on screen.
std::string reproduction_section(const PlanReport& report);

}  // namespace coapt
