// Results in words, for people; scripts ask for --json.
#pragma once

#include <iosfwd>
#include <string>

#include "core/closure/closure.h"
#include "core/metrics/measure.h"
#include "core/metrics/oblique.h"
#include "search/plans/plan_search.h"

namespace coapt {

void print_closure(std::ostream& out, const std::string& name, const ClosureResult& closure);
void print_measure(std::ostream& out, const ValveMeasure& measure);
void print_oblique(std::ostream& out, const ObliqueOrifice& widest);

/// The state before, then one row per plan with its steps and warnings below, then how the search went; "-"
/// where the region is not known. At most 100 columns.
void print_ranked(std::ostream& out, const SearchResult& result);

}  // namespace coapt
