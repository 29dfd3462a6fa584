#pragma once

#include "io/command_line/command_line.h"

namespace coapt {

/// Charts of fits of valves whose answers are known: whole ones, and those with ruptured chordae.
void add_twins(Command chart, int& status);
void add_ruptures(Command chart, int& status);

}  // namespace coapt
