// One row for each option of a search that is a number or a switch. What a search checks, what JSON
// reads and writes, and the help of the command line come from these rows;
// io/schema/search.schema.json is tested against them. Defaults are those of the structs.
#pragma once

#include <cstdint>
#include <span>
#include <variant>

#include "core/valve/problem_list.h"
#include "search/plans/search_options.h"

namespace coapt {

template <class Options>
struct OptionRow {
  /// Of the member, and in JSON.
  const char* name;
  std::variant<int Options::*, std::uint64_t Options::*, double Options::*, bool Options::*> member;
  /// Of an int or a double; a switch and an unsigned number take all that there are.
  Range range;
  /// With its leading blank (" mm") or empty.
  const char* unit;
  /// What it means, in a sentence or two.
  const char* help;
};

std::span<const OptionRow<SearchOptions>> search_option_rows();
std::span<const OptionRow<SearchRules>> search_rule_rows();
std::span<const OptionRow<CostWeights>> cost_weight_rows();

/// Numbers out of their range, at `path`/name. What else rules say is check_rules()'s to see.
void check_option_ranges(ProblemList& problems, const SearchOptions& options);
void check_option_ranges(ProblemList& problems, const SearchRules& rules);

}  // namespace coapt
