#include "clients/cli/plan_arguments.h"

#include <sstream>
#include <type_traits>

#include "clients/cli/read_argument.h"
#include "clients/cli/ring_option.h"
#include "clients/cli/search_option.h"
#include "io/command_line/exit_code.h"
#include "io/command_line/files.h"
#include "io/json/parse_json.h"
#include "io/json/search_options_json.h"
#include "io/json/weights_json.h"

namespace coapt {

std::string command_line(const PlanArguments& arguments) {
  const SearchOptions& options = arguments.options;
  std::ostringstream line;
  line.precision(17);
  line << "coapt plan " << shell_quoted(arguments.valve);
  if (!arguments.search.empty()) line << " --search " << shell_quoted(arguments.search);
  if (!arguments.weights.empty()) line << " --weights " << shell_quoted(arguments.weights);
  line << " --evaluations " << options.evaluations << " --seed " << options.seed << " --plans "
       << options.plans << " --region-points " << options.region_points;
  if (!arguments.fixed.empty()) line << " --fix " << shell_quoted(arguments.fixed);
  for (const std::string& word : arguments.forbidden) line << " --forbid " << word;
  for (const std::string& ring : arguments.rings) line << " --ring " << shell_quoted(ring);
  if (options.front_share != SearchOptions{}.front_share)
    line << " --front-share " << options.front_share;
  if (options.no_improvement > 0) line << " --no-improvement " << options.no_improvement;
  if (options.target_mm2 >= 0.0) line << " --target " << options.target_mm2;
  if (options.fine_levels != SearchOptions{}.fine_levels)
    line << " --fine-levels " << options.fine_levels;
  if (options.model_draws != SearchOptions{}.model_draws)
    line << " --model-draws " << options.model_draws;
  if (!options.evidence) line << " --no-evidence";
  if (options.rank_by_price) line << " --rank price";
  if (options.rules.own_ring) line << " --rings own";
  return line.str();
}

int complete_options(const Command& command, PlanArguments& arguments) {
  SearchOptions& given = arguments.options;
  if (!arguments.search.empty()) {
    const Expected<std::string> text = read_input(arguments.search);
    if (!text) return report_errors(arguments.search, text.errors());
    const Expected<Json> json = parse_json(*text);
    if (!json) return report_errors(arguments.search, json.errors());
    Expected<SearchOptions> read = search_options_from_json(*json);
    if (!read) return report_errors(arguments.search, read.errors());
    if (!arguments.weights.empty() && json->contains("weights"))
      return report_errors(arguments.search, {{ErrorCode::UnknownField, "/weights",
                                               "is not allowed together with --weights"}});
    const auto keep = [&]<class Value>(const std::string& flag, Value SearchOptions::*member) {
      if (!std::is_same_v<Value, bool> && command.has(flag)) (*read).*member = given.*member;
    };
    for (const OptionRow<SearchOptions>& row : search_option_rows())
      std::visit([&](auto member) { keep(flag_of(row), member); }, row.member);
    given = *read;
  }
  if (!arguments.weights.empty()) {
    const Expected<std::string> text = read_input(arguments.weights);
    if (!text) return report_errors(arguments.weights, text.errors());
    const Expected<LearnedWeights> learned = read_learned_weights(*text);
    if (!learned) return report_errors(arguments.weights, learned.errors());
    given.weights = learned->weights;
    arguments.preference = learned->posterior;
  }
  if (arguments.no_evidence) given.evidence = false;
  if (arguments.rank == "price") given.rank_by_price = true;
  if (arguments.ring_shapes == "own") given.rules.own_ring = true;
  for (const std::string& word : arguments.forbidden) given.rules.forbidden.push_back(word);
  for (const std::string& file : arguments.rings) {
    const Expected<RingDesign> ring = read_ring_argument(file);
    if (!ring) return report_errors("plan", ring.errors());
    given.rules.shapes.push_back(ring->shape);
  }
  if (!arguments.fixed.empty()) {
    const Expected<RepairPlan> fixed = read_plan_argument(arguments.fixed);
    if (!fixed) return report_errors(arguments.fixed, fixed.errors());
    given.rules.fixed = *fixed;
  }
  return exit_code::kOk;
}

int report_search_errors(const PlanArguments& arguments, const Errors& errors) {
  const std::string fixed = "/rules/fixed", forbidden = "/rules/forbidden";
  for (Error error : errors) {
    if (!arguments.fixed.empty() && error.path.starts_with(fixed)) {
      error.path.replace(0, fixed.size(), "--fix");
    } else if (!arguments.forbidden.empty() && error.path.starts_with(forbidden)) {
      error.path.replace(0, forbidden.size(), "--forbid");
    } else if (!arguments.search.empty()) {
      report_errors(arguments.search, {error});
      continue;
    } else if (error.path == "/rules") {
      error.path.clear();
    } else {
      report_option_errors("plan", {error}, {{"/target_mm2", "--target"}});
      continue;
    }
    report_errors("plan", {error});
  }
  return exit_code::kBadInput;
}

}  // namespace coapt
