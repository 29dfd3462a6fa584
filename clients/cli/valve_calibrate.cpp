#include <cmath>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "clients/cli/commands.h"
#include "clients/cli/run_options.h"
#include "core/valve/counted.h"
#include "core/valve/number_text.h"
#include "core/valve/printable.h"
#include "io/command_line/exit_code.h"
#include "io/command_line/files.h"
#include "io/command_line/interrupt.h"
#include "io/command_line/progress_bar.h"
#include "io/json/calibration_json.h"
#include "io/json/physiology_json.h"
#include "io/json/version.h"
#include "io/picture/text_table.h"

namespace coapt {
namespace {

struct ValveCalibrateArguments {
  std::string file, directory = "calibration";
  int triangles = 650;
  ValveCalibrationOptions options;
  bool json = false;
};

/// Of one valve; no rows where it cannot be made.
using Rows = std::vector<PhysiologyRow>;

std::vector<Rows> rows_of(const CalibrationProblem& problem, const std::vector<double>& values,
                          const ValveCalibrateArguments& arguments) {
  const Expected<CalibrationValves> valves = problem.valves_at(values);
  std::vector<Rows> rows;
  const std::vector<Expected<Valve>> made = make_calibrated(*valves, arguments.triangles);
  for (std::size_t v = 0; v < made.size(); ++v) {
    PhysiologyOptions options;
    options.kind = valves->valves[v].kind;
    options.species = valves->valves[v].species;
    options.threads = arguments.options.threads;
    rows.push_back(made[v] ? study_physiology(*made[v], options).rows : Rows{});
  }
  return rows;
}

/// Rows that have a range or a target, before and after; the band is the target's where there is one.
TableRows table_of(const CalibrationProblem& problem, int valve, const Rows& before,
                   const Rows& after) {
  TableRows table = {{"quantity", "before", "after", "low", "high", "unit", "verdict"}};
  for (std::size_t r = 0; r < after.size(); ++r) {
    const PhysiologyRow& row = after[r];
    std::string low, high, verdict = to_string(row.verdict);
    if (row.range != nullptr)
      low = figure_cell(row.range->low), high = figure_cell(row.range->high);
    for (const CalibrationBand& band : problem.bands) {
      if (band.valve != valve || band.quantity != row.quantity) continue;
      low = figure_cell(band.low);
      high = figure_cell(band.high);
      verdict += band_cost(band, row.value) > 0.0 ? ", target missed" : ", target met";
    }
    if (low.empty()) continue;
    table.push_back({row.quantity->what, r < before.size() ? figure_cell(before[r].value) : "-",
                     figure_cell(row.value), low, high, row.quantity->unit, verdict});
  }
  return table;
}

Json rows_json(const Rows& rows) {
  Json json = Json::array();
  for (const PhysiologyRow& row : rows) json.push_back(to_json(row));
  return json;
}

int run(ValveCalibrateArguments arguments) {
  const std::atomic<bool>& interrupted = catch_interrupts();
  const Expected<std::string> text = read_input(arguments.file);
  if (!text) return report_errors(arguments.file, text.errors());
  const Expected<CalibrationFile> file = read_calibration(*text);
  if (!file) return report_errors(arguments.file, file.errors());
  if (const Errors errors = make_directory(arguments.directory); !errors.empty()) {
    report_errors("valve calibrate", errors);
    return exit_code::kFailure;
  }
  const CalibrationProblem& problem = file->problem;
  arguments.options.cancelled = &interrupted;
  const auto search = [&] {
    const ProgressBar bar;
    arguments.options.progress = [&](int evaluations, double best) {
      bar.show(evaluations, arguments.options.evaluations,
               "evaluations, cost " + significant(best, 4));
    };
    return calibrate_valves(problem, arguments.options);
  };
  const ValveCalibration found = search();
  std::vector<double> starts;
  for (const CalibrationUnknown& unknown : problem.unknowns) starts.push_back(unknown.start);
  const std::vector<Rows> before = rows_of(problem, starts, arguments),
                          after = rows_of(problem, found.values, arguments);
  const CalibrationValves valves = *problem.valves_at(found.values);

  Json result = {{"triangles", arguments.triangles},
                 {"evaluations", found.evaluations},
                 {"stop", to_string(found.stop)},
                 {"cost_before", found.cost_before},
                 {"cost", found.cost},
                 {"valves", Json::object()}};
  for (std::size_t v = 0; v < valves.valves.size(); ++v)
    result["valves"][valves.valves[v].name] = {{"rows_before", rows_json(before[v])},
                                               {"rows", rows_json(after[v])}};
  const std::string document =
      json_text(result_document("coapt.calibration_result/1", std::move(result)), 2) + "\n";
  std::vector<std::pair<std::string, std::string>> files = {
      {"calibration.json", with_values(file->document, found.values).dump(2) + "\n"},
      {"result.json", document}};
  for (std::size_t v = 0; v < valves.valves.size(); ++v)
    files.emplace_back(valves.valves[v].name + ".json",
                       calibrated_dimensions(valves, static_cast<int>(v)));
  for (const auto& [name, content] : files)
    if (const int failed = write_output(arguments.directory + "/" + name, content)) return failed;

  if (arguments.json) {
    std::cout << document;
  } else {
    for (std::size_t v = 0; v < valves.valves.size(); ++v) {
      std::cout << printable(valves.valves[v].name) << " (" << to_string(valves.valves[v].kind)
                << ")\n";
      print_table(std::cout, table_of(problem, static_cast<int>(v), before[v], after[v]));
      std::cout << '\n';
    }
    std::cout << "Cost " << significant(found.cost_before, 4) << " to "
              << significant(found.cost, 4) << " in " << counted(found.evaluations, "evaluation")
              << " (" << to_string(found.stop) << ").\nWritten to "
              << printable(arguments.directory) << "/calibration.json, and a file for each valve\n";
  }
  return interrupted ? exit_code::kInterrupted : exit_code::kOk;
}

}  // namespace

void add_valve_calibrate(Command parent, int& status) {
  const auto arguments = std::make_shared<ValveCalibrateArguments>();
  ValveCalibrationOptions& options = arguments->options;
  Command command = parent.add_command(
      "calibrate", "Adjust dimensions within bounds to meet rows of `coapt study physiology`");
  command
      .add_option("file", arguments->file,
                  "Dimensions, unknowns and targets "
                  "(coapt.calibration/1), - for standard input")
      .required();
  command
      .add_option("-o,--output", arguments->directory,
                  "Directory for calibration.json with the fitted values, result.json and a file "
                  "of dimensions for each valve")
      .show_default();
  command
      .add_option("--evaluations", options.evaluations,
                  "Start no new round after this many sets of values; a round takes eight more "
                  "than there are unknowns")
      .check(number_from(1, 1000000))
      .show_default();
  command
      .add_option("--seconds", options.seconds,
                  "Start no new round after this time, s; the result then depends on the machine")
      .check(number_from(0.0, 1e9))
      .show_default("no limit");
  command
      .add_option("--triangles", arguments->triangles,
                  "Approximate number of triangles for the final table; the search uses 650")
      .check(number_from(100, 50000))
      .show_default();
  add_threads_option(command, options.threads);
  command.add_flag("--json", arguments->json, "Print JSON");
  command.footer(
      "All valves of the file derive from one healthy valve and keep its chordae. An unknown "
      "refers to\nnumbers of the file by JSON pointers; a target is the published range of a row, "
      "or a given band.\ncalibration.json is the input file with the fitted values; run it again "
      "to continue.\n\n"
      "Example, minutes:\n"
      "  coapt valve calibrate examples/calibration/human.json -o human\n"
      "  coapt valve make --dimensions human/human-normal.json -o normal.json");
  command.on_run([arguments, &status] { status = run(*arguments); });
}

}  // namespace coapt
