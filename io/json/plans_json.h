// What a search answers, as JSON, and what its report says in the same words.
#pragma once

#include <string>
#include <vector>

#include "io/json/json.h"
#include "search/plans/plan_search.h"

namespace coapt {

/// How a search was asked for: what gives the same answer again.
struct SearchRequest {
  SearchOptions options;
  std::string valve_hash;  ///< subject_of() the valve and options.closure
  std::string command;     ///< for a shell; empty if there was none
};

/// coapt.plans/2: before, plans[], how the search went. What is not known (mean and sd of a plan that was
/// closed only once, a margin without neighbours, measures of a valve that flew apart) is null.
Json to_json(const SearchResult& result);

/// The same with "weights" and "reproduce": {"valve_hash", "version", "seed", "command", "search"}, the last
/// as search_options_from_json() reads it.
Json to_json(const SearchResult& result, const SearchRequest& request);

Json to_json(const StartCheck& starts);

}  // namespace coapt
