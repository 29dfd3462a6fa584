#include <iostream>
#include <string>

#include "clients/cli/commands.h"
#include "io/command_line/exit_code.h"

namespace coapt {

void add_moved(Command parent, int& status) {
  for (const std::string name : {"bench", "chart"}) {
    parent.add_hidden_command(name).on_run([name, &status] {
      std::cerr << "coapt: " << name << ": is now coapt-lab " << name
                << ", in a build with -DCOAPT_LAB=ON\n";
      status = exit_code::kBadInput;
    });
  }
}

}  // namespace coapt
