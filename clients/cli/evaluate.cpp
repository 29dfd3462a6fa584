#include <iostream>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "clients/cli/ask.h"
#include "clients/cli/commands.h"
#include "clients/cli/plan_store_option.h"
#include "clients/cli/print_ranked.h"
#include "clients/cli/read_argument.h"
#include "clients/cli/result_exit_code.h"
#include "clients/cli/ring_option.h"
#include "clients/cli/search_option.h"
#include "clients/cli/search_progress.h"
#include "clients/cli/server_option.h"
#include "io/command_line/exit_code.h"
#include "io/command_line/files.h"
#include "io/command_line/interrupt.h"
#include "io/json/plan_json.h"
#include "io/json/plans_json.h"
#include "io/json/subject.h"
#include "io/picture/report.h"

namespace coapt {
namespace {

struct EvaluateArguments {
  std::string valve, report, store;
  std::vector<std::string> plans, rings;
  SearchOptions options;
  ServerOption server;
  bool json = false, no_evidence = false, draws_given = false;
};

/// Reads every plan, and each ring as one; returns an exit code.
/// @param valve what rings are sized for; may be null
int read_plans(const EvaluateArguments& arguments, const Valve* valve,
               std::vector<NamedPlan>& plans) {
  int status = exit_code::kOk;
  for (const std::string& file : arguments.plans) {
    const Expected<std::vector<NamedPlan>> found = read_plans_argument(file);
    if (!found) {
      status = report_errors(file, found.errors());
      continue;
    }
    for (const auto& [name, plan] : *found)
      plans.push_back({name.empty() ? file : file + ": " + name, plan});
  }
  for (const std::string& ring : arguments.rings) {
    const Expected<RepairStep> step = read_ring_step(ring, valve);
    if (step)
      plans.push_back({ring, {{*step}}});
    else
      status = report_errors("evaluate", step.errors());
  }
  if (status == exit_code::kOk && plans.empty())
    return report_errors("evaluate", {{ErrorCode::MissingField, "", "plan or --ring is required"}});
  return status;
}

/// Prints coapt.plans/2; returns an exit code.
int show(const EvaluateArguments& arguments, Json result) {
  for (Json& plan : result["plans"]) plan["file"] = plan["name"];
  if (arguments.json) {
    std::cout << json_text(result, 2) << '\n';
  } else {
    print_ranked(std::cout, result);
  }
  return exit_code_of_plans(result);
}

/// The service's answer, which has the plans in the order asked, as a ranking of named plans.
Json ranking_of(const Json& answer, const std::vector<NamedPlan>& plans) {
  std::map<int, Json> by_rank;
  for (const Json& plan : answer["plans"]) {
    const int rank = plan["rank"];
    const std::string& name = plans.at(plan["index"]).name;
    if (const auto twice = by_rank.find(rank); twice != by_rank.end()) {
      twice->second["name"] = twice->second["name"].get<std::string>() + ", " + name;
      continue;
    }
    Json named = {{"rank", rank}, {"name", name}};
    named.update(plan);
    named.erase("index");
    by_rank[rank] = std::move(named);
  }
  Json result = to_json(SearchResult{});
  for (const auto& [name, value] : answer.items()) result[name] = value;
  result["plans"] = Json::array();
  for (auto& [rank, plan] : by_rank) result["plans"].push_back(std::move(plan));
  return result;
}

/// As many as were asked for; where something was observed of the valve and none were, as many as it takes to be weighed by it.
int draws_of(const EvaluateArguments& arguments, bool observed) {
  return !arguments.draws_given && observed ? kConditionedDraws : arguments.options.model_draws;
}

/// The request of the plans; or an exit code.
AskedRequest asked_plans(const EvaluateArguments& arguments, const std::optional<Service>& service,
                         std::vector<NamedPlan>& plans) {
  AskedRequest asked = asked_repair(arguments.valve, {}, service);
  if (asked.failed) return asked;
  Expected<Valve> known =
      Errors{{}};  // what rings are sized for, and whether something was observed
  if (!service)
    known = asked.here.valve_named(arguments.valve);
  else if (!arguments.rings.empty())
    known = read_valve_argument(arguments.valve);
  if (const int failed = read_plans(arguments, known ? &*known : nullptr, plans))
    return {.failed = failed};
  const Json& valve = asked.request["valve"];
  const bool observed = service ? valve.contains("observed") : !known->observed.empty();
  asked.request["plans"] = Json::array();
  asked.request["region_points"] = arguments.options.region_points;
  asked.request["evidence"] = !arguments.no_evidence;
  asked.request["model_draws"] = draws_of(arguments, observed);
  for (const NamedPlan& plan : plans) asked.request["plans"].push_back(to_json(plan.plan));
  for (std::size_t i = 0; i < plans.size(); ++i)
    asked.sources["/plans/" + std::to_string(i)] = plans[i].name;
  return asked;
}

std::string command_line(const EvaluateArguments& arguments) {
  std::string line = "coapt evaluate " + shell_quoted(arguments.valve);
  for (const std::string& plan : arguments.plans) line += ' ' + shell_quoted(plan);
  for (const std::string& ring : arguments.rings) line += " --ring " + shell_quoted(ring);
  line += " --region-points " + std::to_string(arguments.options.region_points);
  return arguments.no_evidence ? line + " --no-evidence" : line;
}

int run(const EvaluateArguments& arguments, const std::optional<Service>& service) {
  const std::atomic<bool>& interrupted = catch_interrupts();
  if (const int failed = check_output(arguments.report)) return failed;
  std::vector<NamedPlan> plans;
  AskedRequest asked = asked_plans(arguments, service, plans);
  if (asked.failed) return asked.failed;
  std::shared_ptr<PlanStore> store;
  std::string report;
  int unusable = exit_code::kOk;
  const auto evaluate = [&] {
    const ProgressBar bar;
    asked.here.limits.threads = arguments.options.threads;
    asked.here.searches = [&](const Valve& valve, const SearchOptions& options,
                              SearchContext& context) -> Errors {
      context.cancelled = &interrupted;
      context.progress = [&](const SearchProgress& progress) { show(bar, progress); };
      const auto opened = use_store(arguments.store, valve, options.closure, context);
      if (!opened) {
        unusable = report_store_errors("evaluate", opened.errors());
        return opened.errors();
      }
      store = *opened;
      return {};
    };
    asked.here.scored = [&](const Valve& valve, const SearchOptions& options,
                            const SearchResult& result) {
      if (arguments.report.empty()) return;
      report = plan_report_html(
          result, {options, subject_of(valve, options.closure), command_line(arguments)});
    };
    return ask_document(service, "evaluate", asked.request, asked.here);
  };
  const Expected<Json> answer = evaluate();
  if (unusable) return unusable;
  if (!answer) return report_refusal("evaluate", answer.errors(), asked.sources);
  const int status = show(arguments, ranking_of(*answer, plans));
  if (arguments.report.empty()) return status;
  if (service) {
    const Expected<OperationAnswer> made = ask(service, "report", asked.request, asked.here);
    if (!made) return report_refusal("evaluate", made.errors(), asked.sources);
    report = std::get<AnswerFile>(*made).bytes;
  }
  const int failed = write_output(arguments.report, report);
  return failed != exit_code::kOk ? failed : status;
}

}  // namespace

void add_evaluate(Command parent, int& status) {
  const auto arguments = std::make_shared<EvaluateArguments>();
  Command command = parent.add_command("evaluate", "Score and rank plans of your own");
  command.add_option("valve", arguments->valve, kValveHelp).required();
  command.add_option("plan", arguments->plans,
                     "Repair plans: coapt.plan/1 files, the output of coapt plan --json, or plans "
                     "saved on the page");
  command
      .add_option("--ring", arguments->rings,
                  "Score a designed ring (coapt.ring/1) as a plan, in the size of its sizing rule "
                  "or in SIZE mm (repeatable)")
      .show_argument("FILE[:SIZE]")
      .one_at_a_time();
  command.add_option("-o,--report", arguments->report, "Write a report with pictures (HTML)")
      .check({refuse_standard_output, "FILE"});
  arguments->options.model_draws = 0;  // as the service scores
  for (const char* name : {"threads", "region_points", "model_draws"})
    add_search_option(command, name, arguments->options);
  add_store_option(command, arguments->store);
  command.add_flag(
      "--no-evidence", arguments->no_evidence,
      "Skip the analysis of single sutures, of further remodelling and, for the first plan, of "
      "the error of each step");
  command.add_flag("--json", arguments->json,
                   "Print JSON as coapt plan does, with the \"file\" of each plan");
  add_server_option(command, arguments->server);
  command.footer(
      "If something was observed of the valve (coapt observe), --model-draws is 64 by default. A "
      "service\naccepts up to 500 closures by default, counting --region-points for each plan, the "
      "analysis of\nsutures and remodelling, and the variants.\n\n"
      "Examples:\n"
      "  coapt evaluate human-functional-mr examples/plans/ring.json examples/plans/mixed.json -o "
      "report.html\n"
      "  coapt plan valve.json --json > ranked.json; coapt evaluate valve.json ranked.json\n"
      "  coapt evaluate valve.json ring.json --region-points 65 --server http://127.0.0.1:8080");
  on_run_by(command, "evaluate", arguments->server, {"--store", "--threads"}, status,
            [arguments, command](const auto& service) {
              arguments->draws_given = command.has("--model-draws");
              return run(*arguments, service);
            });
}

}  // namespace coapt
