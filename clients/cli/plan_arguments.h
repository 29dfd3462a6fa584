// What the command line of coapt plan asks for.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "clients/cli/server_option.h"
#include "io/command_line/command_line.h"
#include "search/plans/plan_search.h"
#include "search/preference/posterior.h"

namespace coapt {

struct PlanArguments {
  std::vector<std::string> valves;
  std::string valve;  ///< the first of them
  std::string report, search, weights, fixed, store, farm;
  std::optional<PreferencePosterior> preference;  ///< of --weights, after complete_options()
  SearchOptions options;
  std::vector<std::string> forbidden, rings;  ///< rings: files of coapt.ring/1
  ServerOption server;
  bool json = false, no_evidence = false;
  std::string rank = "rule", ring_shapes = "catalogue";
};

/// A command line that gives the same plans again, unless the search was cancelled or out of time; threads, store and
/// server change nothing but the time it takes.
std::string command_line(const PlanArguments& arguments);

/// Puts weights and the search object of --search, with what the command line says in its place, into the options. Returns an exit
/// code.
int complete_options(const Command& command, PlanArguments& arguments);

/// Prints errors that point into the options, each with the option or the file that it comes from; returns kBadInput.
int report_search_errors(const PlanArguments& arguments, const Errors& errors);

}  // namespace coapt
