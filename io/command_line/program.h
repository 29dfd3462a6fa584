// What the programs coapt and coapt-lab have in common: parse the command line, run one command, give an exit code.
#pragma once

#include "io/command_line/command_line.h"

namespace coapt {

struct Program {
  const char* name;
  const char* description;
  const char* footer;  ///< of the program's help: examples, exit codes
  /// Each command that is chosen runs while the line is parsed and leaves its exit code in `status`.
  void (*add_commands)(Command app, int& status);
};

/// Returns main()'s exit code.
int run_program(const Program& program, int argc, char** argv);

}  // namespace coapt
