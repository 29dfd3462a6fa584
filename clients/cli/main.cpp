// coapt: the command line.
#include <fcntl.h>
#include <unistd.h>

#include <exception>
#include <iostream>
#include <string>
#include <vector>

#include "clients/cli/commands.h"
#include "clients/cli/exit_code.h"
#include "io/json/result_json.h"

namespace {

using namespace coapt;

/// Every command's help ends in what coapt is not.
void end_with_notice(CLI::App& command) {
  for (CLI::App* below : command.get_subcommands([](const CLI::App*) { return true; }))
    end_with_notice(*below);
  const std::string footer = command.get_footer();
  command.footer(footer + (footer.empty() ? "" : "\n\n") + std::string(kResearchNotice));
}

int run(int argc, char** argv) {
  CLI::App app(
      "Closes a mitral valve in simulation, measures what leaks, and searches for repairs.",
      "coapt");
  app.set_version_flag("--version",
                       "coapt " + std::string(version()) + "\n" + std::string(kResearchNotice));
  app.require_subcommand(1);

  int status = exit_code::kOk;
  CLI::App* valve = app.add_subcommand("valve", "Make, import, check, describe and remodel valves");
  valve->require_subcommand(1);
  add_valve_make(*valve, status);
  add_valve_import(*valve, status);
  add_valve_check(*valve, status);
  add_valve_info(*valve, status);
  add_valve_remodel(*valve, status);
  add_close(app, status);
  add_evaluate(app, status);
  add_export(app, status);
  add_plan(app, status);
  add_bench(app, status);
  add_chart(app, status);
  add_study(app, status);
  // After the commands, which would take it over.
  app.footer(
      "Examples:\n"
      "  coapt close human-functional-mr                  # a preset leaks: how much, and where\n"
      "  coapt plan human-functional-mr -o report.html    # ranked repair plans\n"
      "  coapt valve import --leaflet a.obj p.obj --annulus ring.csv --chordae chordae.csv -o "
      "mine.json\n"
      "  coapt plan mine.json --server http://127.0.0.1:8080\n"
      "Each command's --help has more; `man coapt` has all.\n\n"
      "Exit codes: 0 done; 1 coapt failed; 2 bad input or usage; 3 closure not converged or "
      "leaflets\n"
      "cross; 4 the best plan is not known to close the valve robustly; 130 interrupted, best so "
      "far printed.");
  end_with_notice(app);
  if (argc == 1) {
    std::cerr << app.help();
    return exit_code::kBadInput;
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::RequiredError& error) {
    // CLI11 says what is missing before what it does not know, such as a misspelt command.
    const std::vector<std::string> unknown = app.remaining(true);
    if (!unknown.empty()) std::cerr << "coapt: unknown: " << unknown.front() << '\n';
    app.exit(error);
    return exit_code::kBadInput;
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? exit_code::kOk : exit_code::kBadInput;
  }
  return status;
}

/// Puts a file that takes no output where a standard stream is closed, lest a file opened later
/// become standard output.
void occupy_standard_streams() {
  int file = 0;
  while (file >= 0 && file <= STDERR_FILENO) file = open("/dev/null", O_RDONLY);
  if (file >= 0) close(file);
}

/// `status`, or kFailure if what was printed did not arrive.
int after_output(int status) {
  if (std::cout.flush()) return status;
  std::cerr << "coapt: standard output: cannot be written\n";
  return exit_code::kFailure;
}

}  // namespace

int main(int argc, char** argv) {
  occupy_standard_streams();
  try {
    return after_output(run(argc, argv));
  } catch (const std::exception& error) {
    std::cerr << "coapt: " << error.what() << '\n';
    return exit_code::kFailure;
  }
}
