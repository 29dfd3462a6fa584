// The commands of coapt-lab, one file each.
#pragma once

#include "io/command_line/command_line.h"

namespace coapt {

/// Each adds commands to `parent`. A command chosen on the command line runs while the line is parsed, and leaves its
/// exit code in `status`.
void add_bench_closures(Command parent, int& status);
void add_bench_search(Command parent, int& status);
void add_bench_front(Command parent, int& status);
void add_bench_indications(Command parent, int& status);
void add_chart(Command parent, int& status);
void add_leak(Command parent, int& status);

}  // namespace coapt
