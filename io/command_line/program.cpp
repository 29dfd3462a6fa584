#include "io/command_line/program.h"

#include <fcntl.h>
#include <unistd.h>

#include <exception>
#include <iostream>
#include <string>

#include "core/valve/printable.h"
#include "io/command_line/exit_code.h"
#include "io/json/version.h"

namespace coapt {
namespace {

int run(const Program& program, int argc, char** argv) {
  const std::string name = program.name;
  CommandLine line(name, program.description);
  line.add_json_of_version();
  Command all = line.program();
  all.require_command();
  int status = exit_code::kOk;
  program.add_commands(all, status);
  // After the commands, which would take it over.
  all.footer(program.footer);
  line.end_helps_with(std::string(kResearchNotice));
  if (argc == 1) {
    std::cerr << line.help();
    return exit_code::kBadInput;
  }
  return line.parse(argc, argv).value_or(status);
}

/// Puts a file that takes no output where a standard stream is closed, lest a file opened later
/// become standard output.
void occupy_standard_streams() {
  int file = 0;
  while (file >= 0 && file <= STDERR_FILENO) file = open("/dev/null", O_RDONLY);
  if (file >= 0) close(file);
}

/// `status`, or kFailure if what was printed did not arrive.
int after_output(const Program& program, int status) {
  if (std::cout.flush()) return status;
  std::cerr << program.name << ": standard output: cannot be written\n";
  return exit_code::kFailure;
}

}  // namespace

int run_program(const Program& program, int argc, char** argv) {
  occupy_standard_streams();
  try {
    return after_output(program, run(program, argc, argv));
  } catch (const std::exception& error) {
    std::cerr << program.name << ": " << printable(error.what()) << '\n';
    return exit_code::kFailure;
  }
}

}  // namespace coapt
