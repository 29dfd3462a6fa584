#include <iostream>
#include <memory>
#include <string>

#include "clients/cli/commands.h"
#include "clients/cli/design_inputs.h"
#include "clients/cli/design_outputs.h"
#include "clients/cli/run_options.h"
#include "core/repair/limits.h"
#include "io/command_line/exit_code.h"
#include "io/command_line/files.h"
#include "io/command_line/interrupt.h"
#include "io/command_line/progress_bar.h"
#include "io/picture/text.h"

namespace coapt {
namespace {

struct DesignArguments {
  std::string population, valve, aetiology, output = "ring.json", name = "designed-ring";
  double printed_size_mm = 30.0;
  RingDesignOptions options;
  bool json = false;
};

Expected<DesignInputs> read_inputs(const DesignArguments& arguments) {
  if (arguments.population.empty() == arguments.valve.empty())
    return Error{ErrorCode::MissingField, "", "either --population or --valve is required"};
  return arguments.valve.empty()
             ? read_population_members(arguments.population, arguments.aetiology)
             : read_one_patient(arguments.valve);
}

int run(DesignArguments arguments) {
  const std::atomic<bool>& interrupted = catch_interrupts();
  if (Errors errors = check_ring_design({{arguments.name, {}}, 0.9}); !errors.empty()) {
    for (Error& error : errors)
      error.path.erase(0, std::string("/ring").size());  // "/name": --name
    return report_option_errors("design ring", errors);
  }
  Expected<DesignInputs> inputs = read_inputs(arguments);
  if (!inputs) {
    const std::string& file = arguments.valve.empty() ? arguments.population : arguments.valve;
    return report_errors(file.empty() ? "design ring" : file, inputs.errors());
  }
  std::vector<std::string> outputs = ring_files(arguments.output);
  outputs.push_back(arguments.output);
  for (const std::string& output : outputs)
    if (const int failed = check_output(output)) return failed;
  arguments.options.cancelled = &interrupted;
  const RingDesignSource source{inputs->made_for, arguments.aetiology, arguments.options.seed,
                                arguments.options.evaluations};
  const auto design = [&] {
    const ProgressBar bar;
    arguments.options.progress = [&bar](const RingSearchProgress& progress) {
      bar.show(
          progress.evaluations, progress.most_evaluations,
          std::string("closures, ") + progress.stage + ", best " + fixed(progress.best_cost, 3));
    };
    return design_ring(std::move(inputs->members), arguments.name, arguments.options);
  };
  const Expected<std::optional<RingDesignResult>> result = design();
  if (!result) return report_errors("design ring", result.errors());
  if (!*result) {
    std::cerr << "coapt: design ring: cancelled; nothing was written\n";
    return exit_code::kInterrupted;
  }
  if (const int failed =
          write_ring_files(arguments.output, arguments.printed_size_mm, **result, source))
    return failed;
  if (arguments.json) {
    std::cout << json_text(to_json(**result, source), 2) << '\n';
    return exit_code::kOk;
  }
  print_ring_design(std::cout, **result, source);
  std::cout << "Written to " << printable(arguments.output);
  for (const std::string& file : ring_files(arguments.output)) std::cout << ", " << printable(file);
  std::cout << '\n';
  return exit_code::kOk;
}

void add_design_ring(Command parent, int& status) {
  const auto arguments = std::make_shared<DesignArguments>();
  RingDesignOptions& options = arguments->options;
  Command command =
      parent.add_command("ring", "Design an annuloplasty ring for a population or for one patient");
  command.add_option("--population", arguments->population,
                     "Directory of a population, or its file (coapt.population/1)");
  command.add_option("--valve", arguments->valve, "Design the ring for this valve alone");
  command.add_option("--aetiology", arguments->aetiology,
                     "Use only members with this aetiology: ischaemic, dilated, ...");
  command
      .add_option("--evaluations", options.evaluations,
                  "Number of closures and openings for evaluating designs; generic shapes and the "
                  "final comparison need more")
      .check(number_from(static_cast<int>(kRingEvaluations.min),
                         static_cast<int>(kRingEvaluations.max)))
      .show_default();
  add_seed_option(command, options.seed, "Random seed; the same seed gives the same ring");
  add_threads_option(command, options.threads);
  command.add_option("--name", arguments->name, "Name of the ring, as used in plans")
      .show_default();
  command
      .add_option("--printed-size", arguments->printed_size_mm,
                  "Cross-sectional width of the solid ring in the STL file and the picture, mm")
      .check(number_from(kRingSizesMm.min, kRingSizesMm.max))
      .show_default();
  command
      .add_option("-o,--output", arguments->output,
                  "File for the ring (coapt.ring/1); a solid, a picture, its dimensions and a web "
                  "page are written beside it (.stl, .svg, .csv, .html)")
      .check({refuse_standard_output, "FILE"})
      .show_default();
  command.add_flag("--json", arguments->json, "Print the whole result as JSON");
  command.footer(
      "Six shape parameters and the sizing rule are optimised on every second member. The "
      "remaining\nmembers are held out to compare the ring with the best generic "
      "shape\n(docs/researcher/ring-design.md).\n\n"
      "Examples:\n"
      "  coapt design ring --population adults --evaluations 20000 --seed 1 -o ring.json\n"
      "  coapt design ring --population adults --aetiology ischaemic -o ischaemic.json\n"
      "  coapt design ring --valve human-functional-mr -o mine.json\n"
      "  coapt close human-functional-mr --ring ring.json");
  command.on_run([arguments, &status] { status = run(*arguments); });
}

}  // namespace

void add_design(Command parent, int& status) {
  Command design = parent.add_command("design", "Design devices for valves");
  design.require_command();
  add_design_ring(design, status);
}

}  // namespace coapt
