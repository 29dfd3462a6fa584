#include <algorithm>
#include <iostream>
#include <memory>
#include <optional>
#include <string>

#include "clients/cli/ask.h"
#include "clients/cli/commands.h"
#include "clients/cli/observed_options.h"
#include "clients/cli/read_argument.h"
#include "core/valve/number_text.h"
#include "core/valve/printable.h"
#include "io/command_line/exit_code.h"
#include "io/command_line/files.h"
#include "io/json/valve_json.h"

namespace coapt {
namespace {

struct ObserveArguments {
  std::string valve, output;
  ObservedOptions observed;
  ServerOption server;
  bool forget = false;
};

Errors check(const ObserveArguments& arguments) {
  if (!arguments.forget && !any_observed(arguments.observed))
    return {{ErrorCode::MissingField, "",
             "an observation is required: " + observed_option_names() + "; or --forget"}};
  return check_observed(arguments.observed);
}

int run(const ObserveArguments& arguments, const std::optional<Service>& service) {
  if (const Errors errors = check(arguments); !errors.empty())
    return report_errors("observe", errors);
  AskedRequest asked = asked_repair(arguments.valve, {}, service);
  if (asked.failed) return asked.failed;
  if (arguments.forget) asked.request["forget"] = true;
  if (const Json observed = observed_json(arguments.observed); !observed.empty())
    asked.request["observed"] = observed;
  if (const auto seen = effective_leak(arguments.observed)) {
    Json& one = asked.request["effective_leak"];
    one = {{"value", seen->value_mm2},
           {"sd", seen->sd_mm2},
           {"discharge", seen->discharge},
           {"discharge_sd", seen->discharge_sd}};
    if (!seen->source.empty()) one["source"] = seen->source;
  }
  const Expected<OperationAnswer> answer = ask(service, "observe", asked.request, asked.here);
  if (!answer) return report_refusal("observe", answer.errors(), asked.sources);
  const std::string& document = std::get<AnswerFile>(*answer).bytes;
  const Expected<Valve> valve = read_valve(document);
  if (!valve) return report_errors("observe", valve.errors());
  if (const int failed = write_output(arguments.output, document)) return failed;
  if (arguments.output == "-") return exit_code::kOk;
  for (const Observation& seen : valve->observed)
    std::cout << "  " << row_of(seen.figure).name << ": " << significant(seen.value, 4) << ", sd "
              << significant(seen.sd, 3) << ' ' << row_of(seen.figure).unit
              << (seen.source.empty() ? "" : ", " + printable(seen.source)) << '\n';
  return exit_code::kOk;
}

}  // namespace

void add_observe(Command parent, int& status) {
  const auto arguments = std::make_shared<ObserveArguments>();
  Command command = parent.add_command(
      "observe", "Store what images show of a valve's leak, to weight later results");
  command.add_option("valve", arguments->valve, kValveHelp).required();
  add_observed_options(command, arguments->observed, "--source");
  command.add_flag("--forget", arguments->forget, "Remove earlier observations");
  command
      .add_option("-o,--output", arguments->output,
                  "File for the valve with its observations, - for standard output")
      .required()
      .show_argument("FILE");
  add_server_option(command, arguments->server);
  command.footer(
      "Variants of tissue and chordae that disagree with the observations receive less weight in "
      "plan,\nevaluate, close --draws, study model and study information. A new value replaces the "
      "earlier one.\nObservations refer to the unrepaired valve; a repair or a remodelling removes "
      "them.\n\n"
      "Examples:\n"
      "  coapt observe valve.json --leak 30 --leak-sd 8 --source \"3D planimetry\" -o seen.json\n"
      "  coapt observe valve.json --effective-leak 24 --effective-leak-sd 5 -o seen.json\n"
      "  coapt observe seen.json --widest-gap 3 --widest-gap-sd 0.5 -o seen.json");
  on_run_by(command, "observe", arguments->server, {}, status,
            [arguments](const auto& service) { return run(*arguments, service); });
}

}  // namespace coapt
