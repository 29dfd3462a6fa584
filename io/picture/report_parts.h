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

/// Index of the plan in front. @pre there are plans.
std::size_t plan_in_front(const PlanReport& report);

/// Whether the evidence has a part for that plan.
bool is_told(const PlanReport& report, const RankedPlan& plan);

/// In base64: drawn, or what stands for it.
std::string picture_of(const PlanReport& report, const ReportPicture& picture);

/// What a surgeon reads in two minutes, on one sheet. @pre there are plans.
std::string first_page(const PlanReport& report);

/// Table of all ranked plans with their warnings, and what a better closure costs.
std::string ranked_section(const PlanReport& report);

/// For each plan told its figure, its gates and the closed valve; the one in front unfolded.
std::string evidence_section(const PlanReport& report);

/// Best cost against closures, which few closures spoke for many, what was left out.
std::string search_section(const SearchResult& result);

/// What the simulation leaves out and how far its figures go; folded on screen.
std::string limits_section();

/// Version, seed, command, options, the plan as a file; folded on screen.
std::string reproduction_section(const PlanReport& report);

}  // namespace coapt
