#include <algorithm>
#include <array>
#include <iostream>
#include <memory>
#include <optional>
#include <string>

#include "clients/cli/commands.h"
#include "clients/cli/read_argument.h"
#include "core/valve/number_text.h"
#include "io/command_line/exit_code.h"
#include "io/command_line/files.h"
#include "io/json/valve_json.h"

namespace coapt {
namespace {

/// How a figure is called on the command line.
struct FigureOption {
  const char *value, *sd, *help;
};

/// In the order of ObservedFigure.
constexpr std::array<FigureOption, kObservedFigures> kFigures = {
    {{"--leak", "--leak-sd",
      "Area of the regurgitant opening, mm2: anatomic (planimetry, 3D vena contracta); an "
      "effective one over its "
      "discharge coefficient"},
     {"--tenting-area", "--tenting-area-sd",
      "Area between annular line and leaflets in the mid-valve section, mm2"},
     {"--widest-gap", "--widest-gap-sd",
      "Diameter of the largest ball that passes between the leaflets, mm"}}};

struct ObserveArguments {
  std::string valve, output, source;
  std::array<std::optional<double>, kObservedFigures> values, sds;
  bool forget = false;
};

Errors check(const ObserveArguments& arguments) {
  Errors errors;
  bool any = arguments.forget;
  for (std::size_t i = 0; i < kFigures.size(); ++i) {
    any = any || arguments.values[i] || arguments.sds[i];
    if (arguments.values[i].has_value() == arguments.sds[i].has_value()) continue;
    const bool has_value = arguments.values[i].has_value();
    errors.push_back({ErrorCode::MissingField, "",
                      std::string(has_value ? kFigures[i].sd : kFigures[i].value) +
                          " is required with " + (has_value ? kFigures[i].value : kFigures[i].sd)});
  }
  if (!any)
    errors.push_back({ErrorCode::MissingField, "",
                      "what was observed is required: --leak and --leak-sd, --tenting-area and "
                      "--tenting-area-sd, or --widest-gap and --widest-gap-sd; or --forget"});
  return errors;
}

int run(const ObserveArguments& arguments) {
  if (const Errors errors = check(arguments); !errors.empty())
    return report_errors("observe", errors);
  Expected<Valve> valve = read_valve_argument(arguments.valve);
  if (!valve) return report_errors(arguments.valve, valve.errors());
  if (arguments.forget) valve->observed.clear();
  for (int i = 0; i < kObservedFigures; ++i) {
    const auto at = static_cast<std::size_t>(i);
    if (!arguments.values[at]) continue;
    const auto figure = static_cast<ObservedFigure>(i);
    std::erase_if(valve->observed, [&](const Observation& seen) { return seen.figure == figure; });
    valve->observed.push_back(
        {figure, *arguments.values[at], *arguments.sds[at], arguments.source});
  }
  if (const int failed = write_output(arguments.output, write_valve(*valve))) return failed;
  if (arguments.output == "-") return exit_code::kOk;
  for (const Observation& seen : valve->observed)
    std::cout << "  " << row_of(seen.figure).name << ": " << shown(seen.value) << ", sd "
              << shown(seen.sd) << ' ' << row_of(seen.figure).unit
              << (seen.source.empty() ? "" : ", " + seen.source) << '\n';
  return exit_code::kOk;
}

}  // namespace

void add_observe(Command parent, int& status) {
  const auto arguments = std::make_shared<ObserveArguments>();
  Command command = parent.add_command(
      "observe", "Store what images show of a valve's leak, by which later answers are weighed");
  command.add_option("valve", arguments->valve, kValveHelp).required();
  for (std::size_t i = 0; i < kFigures.size(); ++i) {
    const ObservedRow& row = kObservedRows[i];
    command.add_option(kFigures[i].value, arguments->values[i], kFigures[i].help)
        .check(number_from(row.least, row.most));
    command
        .add_option(kFigures[i].sd, arguments->sds[i],
                    std::string("How well it is known: one standard deviation, ") + row.unit)
        .check(number_from(row.least_sd, row.most_sd));
  }
  command.add_option("--source", arguments->source, "Who or what saw it, in words");
  command.add_flag("--forget", arguments->forget, "Forget what was observed before");
  command
      .add_option("-o,--output", arguments->output,
                  "File for the valve with what was observed, - for standard output")
      .required()
      .show_argument("FILE");
  command.footer(
      "Draws of tissue and chordae in which the valve looks otherwise count less from then on: in "
      "plan and\nevaluate, close --draws, study model and study information. A figure that was "
      "given before is replaced.\nThe valve as observed is the unrepaired one: a repair or a "
      "remodelling forgets it.\n\n"
      "Examples:\n"
      "  coapt observe valve.json --leak 30 --leak-sd 8 --source \"3D planimetry\" -o seen.json\n"
      "  coapt observe seen.json --widest-gap 3 --widest-gap-sd 0.5 -o seen.json");
  command.on_run([arguments, &status] { status = run(*arguments); });
}

}  // namespace coapt
