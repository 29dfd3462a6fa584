#include <iostream>
#include <memory>
#include <string>

#include "clients/cli/ask.h"
#include "clients/cli/commands.h"
#include "clients/cli/farm_option.h"
#include "clients/cli/plan_arguments.h"
#include "clients/cli/plan_store_option.h"
#include "clients/cli/plan_valves.h"
#include "clients/cli/read_argument.h"
#include "clients/cli/search_option.h"
#include "clients/cli/search_progress.h"
#include "clients/cli/service_job.h"
#include "io/command_line/command_line.h"
#include "io/command_line/exit_code.h"
#include "io/command_line/files.h"
#include "io/command_line/interrupt.h"
#include "io/json/plan_json.h"
#include "io/json/search_options_json.h"
#include "io/json/subject.h"
#include "io/picture/report.h"

namespace coapt {
namespace {

/// Errors below "/search" are those of the options, all others of the request.
int report_refused_search(const PlanArguments& arguments, const Errors& errors) {
  Errors of_options, others;
  for (Error error : errors) {
    const bool is_option = error.path.starts_with("/search/");
    if (is_option) error.path.erase(0, std::string("/search").size());
    (is_option ? of_options : others).push_back(error);
  }
  report_search_errors(arguments, of_options);
  return report_refusal("plan", others, {{"/valve", arguments.valve}});
}

int run_by(const Service& service, const Command& command, PlanArguments arguments) {
  const std::atomic<bool>& interrupted = catch_interrupts();
  const Expected<Json> valve = valve_to_send(arguments.valve);
  if (!valve) return report_errors(arguments.valve, valve.errors());
  if (const int failed = complete_options(command, arguments)) return failed;
  if (const int failed = check_output(arguments.report)) return failed;
  const Json request = {{"valve", *valve}, {"search", to_json(arguments.options)}};
  const Expected<ServiceJob> job = run_job(service, "/v1/plans", request, interrupted);
  if (!job) return report_refused_search(arguments, job.errors());
  Expected<Json> result = get_json(service, job->path + "/result");
  if (!result) {
    const int failed = report_refusal("plan", result.errors(), {});
    return job->state == "CANCELLED" ? exit_code::kInterrupted : failed;
  }
  (*result)["reproduce"]["command"] = command_line(arguments);
  const int status = show_plans(arguments, *result);
  if (arguments.report.empty()) return status;
  const Expected<std::string> report = get(service, job->path + "/report");
  if (!report) return report_refusal("plan", report.errors(), {});
  const int failed = write_output(arguments.report, *report);
  return failed != exit_code::kOk ? failed : status;
}

int run(const Command& command, PlanArguments arguments) {
  const std::atomic<bool>& interrupted = catch_interrupts();
  AskedRequest asked = asked_repair(arguments.valve, {}, std::nullopt);
  if (asked.failed) return asked.failed;
  if (const int failed = complete_options(command, arguments)) return failed;
  if (const int failed = check_output(arguments.report)) return failed;
  asked.request["search"] = to_json(arguments.options);
  asked.here.interrupted = &interrupted;
  int unusable = exit_code::kOk;
  std::string report;
  asked.here.scored = [&](const Valve& valve, const SearchOptions& options,
                          const SearchResult& result) {
    if (!arguments.report.empty())
      report = plan_report_html(
          result, {options, subject_of(valve, options.closure), command_line(arguments)});
  };
  const auto search = [&] {
    const ProgressBar bar;
    asked.here.searches = [&](const Valve& valve, const SearchOptions& options,
                              SearchContext& context) -> Errors {
      context.progress = [&](const SearchProgress& progress) { show(bar, progress); };
      const auto store = use_store(arguments.store, valve, options.closure, context);
      if (!store) unusable = report_store_errors("plan", store.errors());
      return store ? Errors() : store.errors();
    };
    return ask_document(std::nullopt, "plan", asked.request, asked.here);
  };
  Expected<Json> result = search();
  if (unusable != exit_code::kOk) return unusable;
  if (!result) return report_refused_search(arguments, result.errors());
  (*result)["reproduce"]["command"] = command_line(arguments);
  const int status = show_plans(arguments, *result);
  const int failed =
      arguments.report.empty() ? exit_code::kOk : write_output(arguments.report, report);
  return failed != exit_code::kOk ? failed : status;
}

}  // namespace

void add_plan(Command parent, int& status) {
  const auto arguments = std::make_shared<PlanArguments>();
  SearchOptions& options = arguments->options;
  Command command = parent.add_command("plan", "Search for repair plans and rank them");
  command
      .add_option("valve", arguments->valves,
                  std::string(kValveHelp) + "; several valves are planned one after another")
      .required();
  for (const char* name : {"evaluations", "front_share", "seed", "seconds", "plans", "threads",
                           "region_points", "fine_levels", "model_draws", "no_improvement"})
    add_search_option(command, name, options);
  command
      .add_option(
          "--target", options.target_mm2,
          "Stop the search once the leak of a plan (mean + sd) is at or below this value, mm2")
      .check(number_from(0.0, 1e6));
  command.add_option("--fix", arguments->fixed,
                     "Plan file with steps that every plan must include");
  command
      .add_option("--forbid", arguments->forbidden,
                  "Technique that no plan may include: annuloplasty, "
                  "papillary_approximation:saddle_peak, ... (repeatable)")
      .one_at_a_time();
  command
      .add_option("--ring", arguments->rings,
                  "Also offer a designed ring (coapt.ring/1) in all sizes (repeatable)")
      .show_argument("FILE")
      .one_at_a_time();
  command
      .add_option("--rings", arguments->ring_shapes,
                  "Rings to offer: catalogue (as manufacturers sell them) or own (also in the "
                  "annulus's own shape)")
      .one_of(std::vector<std::string>{"catalogue", "own"})
      .show_default();
  command.add_option("--search", arguments->search,
                     "Read search options, including cost weights, from a JSON file "
                     "(io/schema/search.schema.json)");
  command.add_option(
      "--weights", arguments->weights,
      "Replace the default cost weights by those learned with coapt prefer (coapt.weights/1)");
  add_store_option(command, arguments->store);
  command.add_flag(
      "--no-evidence", arguments->no_evidence,
      "Skip the analysis of single sutures, of further remodelling and, for the first plan, of "
      "the error of each step");
  command
      .add_option("--rank", arguments->rank,
                  "Order of acceptable plans: rule (equivalence classes, simplest plan first) or "
                  "price (cost of each plan)")
      .one_of(std::vector<std::string>{"rule", "price"})
      .show_default();
  command.add_flag("--json", arguments->json, "Print JSON");
  command
      .add_option("-o,--report", arguments->report,
                  "Write a report with pictures (HTML); for several valves, a directory of reports "
                  "and plans")
      .check({refuse_standard_output, "FILE"});
  add_farm_option(command, arguments->farm, "Run each search as a whole");
  add_server_option(command, arguments->server);
  command.footer(
      "Closure budget: 1 for the unrepaired valve; up to --evaluations for the search and "
      "--front-share\ntimes as many for trade-offs (from 82 on); in the ranking, up to 65, plus 24 "
      "for progression, for\neach of 12 finalists (one more for each of --plans above 5), up to 8 "
      "simpler versions of them and, if\nthe first plan is not acceptable without an avoidable "
      "warning, 8 more; the other nodes of the region\n(--region-points) for the best plan. Each "
      "of --plans takes 88 to 284 more for errors of single\nsutures, independent errors of "
      "execution and further remodelling. The best five or more and the\nunrepaired valve are "
      "closed on a finer mesh (--fine-levels) and in the same variants of tissue and\nchordae "
      "(--model-draws), before the best --plans are reported. Both enter the probability that a\n"
      "plan is acceptable.\n\nAn interrupted "
      "search resumes when run again with the same --store and ends with the same "
      "ranking.\n\nCtrl-C stops the search and prints the best plans so far (exit code 130) once "
      "the closures in\nprogress have ended. A second Ctrl-C ends coapt at once (130 in the shell) "
      "and prints nothing.\n\nThe exit code is 4 unless the best plan is acceptable: the leak is "
      "below 5 mm2 with a probability\nof 0.95, accounting for errors of execution, tissue and "
      "mesh, and also on the finer mesh; no rule\nof practice rejects the plan; and the valve "
      "opens far enough. If no plan is acceptable, plans are\nlisted from the least to the most "
      "unfavourable.\n\n"
      "Examples:\n"
      "  coapt plan human-functional-mr --seed 1 -o report.html\n"
      "  coapt plan valve.json --fix ring30.json --forbid papillary_approximation:saddle_peak\n"
      "  coapt plan valve.json --plans 10 --store valve.sqlite --json > plans.json\n"
      "  coapt plan patients/*.json --farm postgresql://farm.example/coapt -o plans\n"
      "  coapt plan valve.json --server http://127.0.0.1:8080 -o report.html");
  command.on_run([arguments, command, &status] {
    const auto service = service_of(command, arguments->server, {"--store", "--farm"});
    if (!service) {
      status = report_errors("plan", service.errors());
      return;
    }
    const bool several = arguments->valves.size() > 1;
    arguments->valve = arguments->valves.front();
    if (*service && several)
      status = report_errors(
          "plan", {{ErrorCode::Unsupported, "", "--server accepts one valve at a time"}});
    else if (*service)
      status = run_by(**service, command, *arguments);
    else
      status = several || !arguments->farm.empty() ? plan_by_request(command, *arguments)
                                                   : run(command, *arguments);
  });
}

}  // namespace coapt
