#include "clients/cli/plan_valves.h"

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <set>

#include "clients/cli/farm_option.h"
#include "clients/cli/print_ranked.h"
#include "clients/cli/read_argument.h"
#include "clients/cli/result_exit_code.h"
#include "core/valve/printable.h"
#include "farm/work/plan_work.h"
#include "io/command_line/exit_code.h"
#include "io/command_line/files.h"
#include "io/command_line/interrupt.h"
#include "io/command_line/progress_bar.h"
#include "io/json/weights_json.h"
#include "io/picture/report_material.h"
#include "io/picture/study_csv.h"
#include "io/picture/text.h"

namespace coapt {
namespace {

namespace fs = std::filesystem;

/// A valve of the command line.
struct GivenValve {
  std::string argument;
  std::string name;  ///< of its files
  Valve valve;
};

/// The file's name without its ending, or the preset's; if that is taken, with a number.
std::string file_name_of(const std::string& argument, std::set<std::string>& taken) {
  std::string stem = fs::path(argument).stem().string();
  if (argument == "-" || stem.empty()) stem = "valve";
  std::string name = stem;
  for (int number = 2; !taken.insert(name).second; ++number)
    name = stem + '-' + std::to_string(number);
  return name;
}

Expected<std::vector<GivenValve>> read_given(const std::vector<std::string>& arguments) {
  std::vector<GivenValve> given;
  std::set<std::string> taken;
  Errors errors;
  for (const std::string& argument : arguments) {
    Expected<Valve> valve = read_valve_argument(argument);
    if (valve) {
      given.push_back({argument, file_name_of(argument, taken), *std::move(valve)});
    } else {
      for (Error error : valve.errors()) {
        error.message = (error.path.empty() ? "" : error.path + ": ") + error.message;
        error.path = argument;
        errors.push_back(std::move(error));
      }
    }
  }
  if (!errors.empty()) return errors;
  return given;
}

/// What this way of planning does not offer. Returns an exit code.
int refuse_options(const Command& command, const PlanArguments& arguments) {
  Errors errors;
  const auto refuse = [&errors](const std::string& message) {
    errors.push_back({ErrorCode::Unsupported, "", message});
  };
  const bool several = arguments.valves.size() > 1;
  if (command.has("--store"))
    refuse("--store is available only for the search of one valve on this machine; leave it out");
  if (arguments.options.seconds > 0.0)
    refuse("--seconds would make the result depend on the machines, so it is not available for " +
           std::string(several ? "several valves" : "a farm") + "; use --evaluations");
  if (several && arguments.json)
    refuse(
        "--json is available for one valve only; the plans of several valves are written to "
        "DIR/NAME.json");
  if (several && arguments.report.empty())
    refuse("several valves require a directory for their plans: -o DIR");
  return errors.empty() ? exit_code::kOk : report_errors("plan", errors);
}

Expected<std::vector<PlanAnswer>> ask_for(const Asker& asker, const std::vector<Valve>& valves,
                                          const SearchOptions& options, const AskContext& context) {
  const Expected<WorkRequest> request = plan_request(valves, options);
  if (!request) return request.errors();
  const Expected<std::string> bytes = asker(*request, context);
  if (!bytes) return bytes.errors();
  Expected<std::vector<PlanAnswer>> answers = plan_answers(*bytes);
  if (answers && answers->size() != valves.size())
    return Error{ErrorCode::InputOutput, "",
                 "the farm returned a different number of results than there are valves"};
  return answers;
}

/// Errors of asking: those below "/search" are of the options.
int report_asked(const PlanArguments& arguments, const Errors& errors) {
  int status = exit_code::kFailure;
  for (Error error : errors) {
    const std::string search = "/search";
    if (error.path.starts_with(search)) error.path.erase(0, search.size());
    if (error.code == ErrorCode::InputOutput)
      report_errors("plan", {error});
    else
      status = report_search_errors(arguments, {error});
  }
  return status;
}

std::vector<std::string> summary_row(const std::string& name, const Json& plans) {
  const auto number = [](const Json& value) {
    return value.is_number() ? fixed(value.get<double>(), 2) : "";
  };
  std::vector<std::string> row = {name, number(plans["before"]["leak_mm2"])};
  if (plans["plans"].empty()) return {name, row[1], "", "", "", "", plans["stop"]};
  const Json& best = plans["plans"].front();
  std::string words;
  for (const Json& line : best["description"])
    words += (words.empty() ? "" : "; ") + line.get<std::string>();
  row.insert(row.end(),
             {number(best["leak_mm2"]["mean"]), number(best["leak_mm2"]["sd"]),
              best["closes_robustly"].get<bool>() ? "true" : "false", words, plans["stop"]});
  return row;
}

/// Writes the files of one valve. Returns an exit code; kOk is not yet a robust plan.
int write_plans(const std::string& directory, const GivenValve& given, const PlanAnswer& answer,
                const Json& plans) {
  const std::string path = (fs::path(directory) / given.name).string();
  if (const int failed = write_output(path + ".json", plans.dump(2) + "\n")) return failed;
  const Expected<std::string> report = report_page(answer.material, 0, given.valve);
  if (!report) return report_errors(given.argument, report.errors());
  return write_output(path + ".html", *report);
}

/// An answer as coapt.plans/2, as this command line would have made it.
Json plans_of(const PlanAnswer& answer, PlanArguments arguments, const std::string& valve) {
  Json plans = Json::parse(answer.plans);
  arguments.valve = valve;
  plans["reproduce"]["command"] = command_line(arguments);
  return plans;
}

int show_one(const PlanArguments& arguments, const GivenValve& given, const PlanAnswer& answer) {
  const int status = show_plans(arguments, plans_of(answer, arguments, given.argument));
  if (arguments.report.empty()) return status;
  const Expected<std::string> report = report_page(answer.material, 0, given.valve);
  if (!report) return report_errors(given.argument, report.errors());
  const int failed = write_output(arguments.report, *report);
  return failed != exit_code::kOk ? failed : status;
}

/// Makes what the output needs, and looks at what would fail later. Returns an exit code.
int prepare(const PlanArguments& arguments, const std::vector<GivenValve>& given) {
  const bool several = given.size() > 1;
  if (several) {
    if (const Errors errors = make_directory(arguments.report); !errors.empty()) {
      report_errors("plan", errors);
      return exit_code::kFailure;
    }
  } else if (const int failed = check_output(arguments.report)) {
    return failed;
  }
  for (const GivenValve& one : given)
    if (const Errors errors = check_search(one.valve, arguments.options); !errors.empty()) {
      if (several) std::cerr << "coapt: plan: problems of " << printable(one.argument) << ":\n";
      return report_search_errors(arguments, errors);
    }
  return exit_code::kOk;
}

/// Of valves [first, first + count) of `given`.
Expected<std::vector<PlanAnswer>> answers_of(const PlanArguments& arguments, const Asker& asker,
                                             const std::vector<GivenValve>& given,
                                             std::size_t first, std::size_t count,
                                             const std::atomic<bool>& interrupted) {
  std::vector<Valve> valves;
  for (std::size_t i = first; i < first + count; ++i) valves.push_back(given[i].valve);
  const ProgressBar bar;
  const auto show = [&](const AskProgress& now) {
    bar.show(static_cast<int>(first) + static_cast<int>(now.done), static_cast<int>(given.size()),
             "valves");
  };
  show({});
  return ask_for(asker, valves, arguments.options, {"coapt plan", show, &interrupted});
}

/// The files of several valves.
class PlanFolder {
 public:
  explicit PlanFolder(const PlanArguments& arguments) : arguments_(arguments) {}

  /// Returns an exit code; kOk whatever the plans are.
  int add(const GivenValve& given, const PlanAnswer& answer) {
    Json plans = plans_of(answer, arguments_, given.argument);
    if (arguments_.preference) add_preferred_over_next(plans, *arguments_.preference);
    if (const int failed = write_plans(arguments_.report, given, answer, plans)) return failed;
    summary_.push_back(summary_row(given.name, plans));
    const std::string& words = summary_.back()[5];
    std::cout << printable(given.name + ": " + (words.empty() ? "no plan" : words)) << '\n';
    worst_ = std::max(worst_, exit_code_of_plans(plans));
    return exit_code::kOk;
  }

  /// Writes the summary. Returns the worst exit code of all plans, or that it cannot be written.
  int finish() const {
    const std::string table = (fs::path(arguments_.report) / "summary.csv").string();
    if (const int failed = write_output(table, table_csv(summary_))) return failed;
    std::cout << "Written to " << printable(table) << ", each valve's plans beside it\n";
    return worst_;
  }

 private:
  const PlanArguments& arguments_;
  std::vector<std::vector<std::string>> summary_ = {{"valve", "leak_before_mm2", "leak_mean_mm2",
                                                     "leak_sd_mm2", "closes_robustly", "plan",
                                                     "stop"}};
  int worst_ = exit_code::kOk;
};

}  // namespace

int show_plans(const PlanArguments& arguments, Json result) {
  if (arguments.preference) add_preferred_over_next(result, *arguments.preference);
  if (arguments.json) {
    std::cout << json_text(result, 2) << '\n';
  } else {
    print_ranked(std::cout, result);
  }
  return exit_code_of_plans(result);
}

int plan_by_request(const Command& command, PlanArguments arguments) {
  const std::atomic<bool>& interrupted = catch_interrupts();
  const auto given = read_given(arguments.valves);
  if (!given) return report_errors("plan", given.errors());
  if (const int failed = complete_options(command, arguments)) return failed;
  if (const int failed = refuse_options(command, arguments)) return failed;
  if (const int failed = prepare(arguments, *given)) return failed;

  const Asker asker = asker_of(arguments.farm, arguments.options.threads);
  // A farm takes all at once; here each is written when it is found.
  const std::size_t at_once = arguments.farm.empty() ? 1 : given->size();
  PlanFolder folder(arguments);
  for (std::size_t first = 0; first < given->size(); first += at_once) {
    const auto answers = answers_of(arguments, asker, *given, first, at_once, interrupted);
    if (!answers) {
      const int failed = report_asked(arguments, answers.errors());
      return interrupted ? exit_code::kInterrupted : failed;
    }
    if (given->size() == 1) return show_one(arguments, given->front(), answers->front());
    for (std::size_t i = 0; i < at_once; ++i)
      if (const int failed = folder.add((*given)[first + i], (*answers)[i])) return failed;
  }
  return folder.finish();
}

}  // namespace coapt
