#include "lab/cli/draw.h"

#include <cstdlib>
#include <iostream>
#include <string>

#include "io/command_line/files.h"

namespace coapt {

void draw(const std::filesystem::path& table) {
  const std::string command = shell_quoted(COAPT_PLOT) + ' ' + shell_quoted(table.string());
  if (std::system(command.c_str()) != 0)
    std::cerr << "coapt-lab: " << table.string() << ": is written, but not drawn; draw it with "
              << command << '\n';
}

}  // namespace coapt
