// What the commands of `coapt-lab chart` share.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "io/command_line/command_line.h"

namespace coapt {

/// Writes the table that `make` gives into the directory, and draws it; that it can be written is known before.
int run_chart(const std::string& directory, const std::string& name,
              const std::function<std::string()>& make);

/// Of a command's chart; its table goes there, too.
std::shared_ptr<std::string> add_output(Command command);

void add_threads_option(Command command, int& threads, const std::string& what);

/// Those of how much a closure's figures are worth: mesh, gap, uniqueness, verdicts.
void add_accuracy_charts(Command chart, int& status);

}  // namespace coapt
