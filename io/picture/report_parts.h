// Sections of the plan report, each as HTML.
#pragma once

#include <string>

#include "io/picture/report.h"

namespace coapt {

/// The steps in words; "no repair" if there are none.
std::vector<std::string> steps_of(const RankedPlan& plan);

/// "0.4 ± 0.5", "n/a".
std::string mean_and_sd(const OrificeStatistics& leak);

/// "0.75", "> 1.00" where nothing leaks as far as the region goes.
std::string suture_margin(const LeakMargin& margin);
std::string angle_margin(const LeakMargin& margin);

/// Table of all ranked plans with their warnings, and what a better closure costs.
std::string ranked_section(const SearchResult& result);

/// For each plan its figure, its gates and the closed valve; the first unfolded.
std::string evidence_section(const PlanReport& report);

/// Best cost against closures, which few closures spoke for many, what was left out.
std::string search_section(const SearchResult& result);

}  // namespace coapt
